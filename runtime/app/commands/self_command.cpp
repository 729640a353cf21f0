#include "meet/app/commands/self_command.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/output/output_files.hpp"
#include "meet/app/output/paint.hpp"
#include "meet/app/output/report_page.hpp"
#include "meet/app/output/self_report.hpp"
#include "meet/app/query/device_self.hpp"
#include "meet/app/text/progress.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/views/nouns.hpp"
#include "meet/io/read.hpp"

#include <chrono>
#include <fmt/format.h>
#include <iterator>
#include <memory>

namespace meetc::app {

namespace {

namespace fs = std::filesystem;
using clock = std::chrono::steady_clock;

double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

void check_outputs(const collide_request &q, output_files &outputs) {
  if (q.pairs)
    outputs.expect(*q.pairs);
  if (q.image)
    check_picture(*q.image), outputs.expect(*q.image);
  if (q.page)
    check_page(*q.page), outputs.expect(*q.page);
  if (q.colour && q.colour->empty())
    throw failure("--color: the folder's name is empty");
  if (q.colour)
    outputs.expect(*q.colour / "a.ply", true);
}

void write_all(const collide_request &q, const predicate_info &predicate, output_files &outputs, self_report &report) {
  const painted a{report.a, report.hit, q.a.filename().string(), picture::palette::calm[0], picture::palette::yellow};
  if (q.pairs) {
    outputs.write(*q.pairs, [&report](const fs::path &to) { write_self_pairs(to, report); });
    report.written.push_back(q.pairs->string());
  }
  if (q.colour) {
    outputs.make_folder(*q.colour);
    const fs::path path = *q.colour / "a.ply";
    outputs.write(path, [&a](const fs::path &to) { write_coloured(to, a); });
    report.written.push_back(path.string());
  }
  if (q.image) {
    outputs.write(*q.image, [&](const fs::path &to) { write_picture(to, {a}, q.view); });
    report.written.push_back(q.image->string());
  }
  if (q.page) {
    outputs.write(*q.page, [&](const fs::path &to) { write_page(to, a, predicate, report, q.threads); });
    report.written.push_back(q.page->string());
  }
  outputs.commit();
}

void find_here(const self_predicates &by, const self_options &options, self_report &report) {
  const clock::time_point start = clock::now();
  const prepared set = prepare(report.a, options.threads);
  set.bounds(report.bounds.lo, report.bounds.hi);
  report.prepare_seconds = seconds_since(start);
  report.found = self_pairs(set, view_of(report.a), by, options);
}

void find_there(const self_predicates &by, const self_options &options, self_report &report) {
  device_self d = self_pairs_on_device(report.a, by, options);
  report.on = processor::cuda;
  report.bounds = d.around;
  report.prepare_seconds = d.account.start_seconds + d.prepare_seconds;
  report.by_device = std::move(d.account);
  report.found = std::move(d.found);
}

void find_on(processor on, const self_predicates &by, const self_options &options, self_report &report) {
  if (on == processor::best && device_expected(report.a.elements, options.threads))
    try {
      find_there(by, options, report);
      report.notes.push_back("--device auto took the CUDA device");
      return;
    } catch (const failure &e) {
      if (e.code() != no_device)
        throw;
      report.notes.push_back(fmt::format("--device auto took the CPU: {}", e.what()));
    }
  on == processor::cuda ? find_there(by, options, report) : find_here(by, options, report);
}

} // namespace

printed collide_self(const catalogue &all, const catalogue &neighbours, const collide_request &q) {
  output_files outputs({q.a});
  check_outputs(q, outputs);
  const clock::time_point start = clock::now();
  const io::element_set a = io::read(q.a, kinds_of(all), q.read_a);
  if (!is_mesh(a))
    throw failure(fmt::format("--self needs a mesh, whose faces may cross each other; {} holds {}", q.a.string(),
                              plural_of(a.kind->name)));
  self_report report{q.a.string(), a};
  report.read_seconds = seconds_since(start);
  report.moved = q.read_a.move.any();
  report.merged = q.merge;
  report.instruction_set = name_of(all.compiled_for);

  auto progress = std::make_unique<progress_line>("collide");
  self_options options;
  options.threads = q.threads;
  options.merge = q.merge;
  options.owner = a.owner;
  options.progress = [&progress](double fraction) { (*progress)(fraction); };
  const self_predicates by = of_one_mesh(all, neighbours);
  find_on(q.on, by, options, report);
  progress.reset();
  name_faces(report);
  write_all(q, by.apart, outputs, report);
  return {q.json ? as_json(report) : summary(report),
          q.fail_on_touch && !report.found.pairs.empty() ? check_failed : done};
}

} // namespace meetc::app
