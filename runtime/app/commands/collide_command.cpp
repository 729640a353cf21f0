#include "meet/app/commands/collide_command.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/input_options.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/output/contact_files.hpp"
#include "meet/app/output/output_files.hpp"
#include "meet/app/output/paint.hpp"
#include "meet/app/output/pair_values.hpp"
#include "meet/app/output/report.hpp"
#include "meet/app/output/report_page.hpp"
#include "meet/app/query/coarse_tolerance.hpp"
#include "meet/app/query/collide_sets.hpp"
#include "meet/app/text/progress.hpp"
#include "meet/core/views/nouns.hpp"
#include "meet/io/read.hpp"

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

void check_outputs(const collide_request &q, output_files &outputs) {
  if (q.any && (q.pairs || q.first || q.contacts || q.colour || q.image || q.page || !q.evaluate.empty()))
    throw failure(
        "--any stops at the first pair and keeps none; --pairs, --first, --contacts, --evaluate, --color, --image "
        "and --report need them all");
  if (q.first && q.tolerance > 0)
    throw failure("--first is exact and goes with no --tolerance");
  if (q.contacts && q.tolerance > 0)
    throw failure("--contacts are exact and go with no --tolerance");
  if (q.contacts_float64 && !q.contacts)
    throw failure("--contacts-float64: the file is missing; write --contacts out.obj as well");
  if (q.contacts_embedded && !q.contacts)
    throw failure("--contacts-embedded: the file is missing; write --contacts out.obj as well");
  if (q.pairs)
    outputs.expect(*q.pairs);
  if (q.contacts) {
    outputs.expect(*q.contacts);
    check_contact_file(*q.contacts);
  }
  if (q.first)
    outputs.expect(*q.first);
  if (!q.evaluate.empty())
    outputs.expect(q.evaluate[1]);
  if (q.image) {
    outputs.expect(*q.image);
    check_picture(*q.image);
  }
  if (q.page) {
    outputs.expect(*q.page);
    check_page(*q.page);
  }
  if (q.colour && q.colour->empty())
    throw failure("--color: the folder's name is empty");
  if (q.colour)
    for (const char *const name : {"a.ply", "b.ply"})
      outputs.expect(*q.colour / name, true);
}

void write_colours(const collide_request &q, const painted &a, const painted &b, output_files &outputs,
                   collide_report &report) {
  if (!is_mesh(a.set) && !is_mesh(b.set))
    throw failure(fmt::format("--color: only the faces of a mesh can be coloured; here are {} and {}",
                              plural_of(a.set.kind->name), plural_of(b.set.kind->name)));
  outputs.make_folder(*q.colour);
  for (const painted *const side : {&a, &b}) {
    const bool first = side == &a;
    if (!is_mesh(side->set)) {
      report.notes.push_back(fmt::format("{} is no mesh and has no coloured one", first ? "A" : "B"));
      continue;
    }
    const fs::path path = *q.colour / (first ? "a.ply" : "b.ply");
    outputs.write(path, [side](const fs::path &to) { write_coloured(to, *side); });
    report.written.push_back(path.string());
  }
}

void write_all(const collide_request &q, const std::optional<formula_choice> &formula, output_files &outputs,
               collide_report &report) {
  const painted a{report.a, report.found.a.hit, q.a.filename().string(), picture::palette::calm[0],
                  picture::palette::yellow};
  const painted b{report.b, report.found.b.hit, q.b.filename().string(), picture::palette::calm[1],
                  picture::palette::vermilion};
  const auto write_list = [&](const std::optional<fs::path> &to, const std::vector<index_pair> &list) {
    if (!to)
      return;
    outputs.write(*to, [&list](const fs::path &file) { io::write_pairs_csv(file, list); });
    report.written.push_back(to->string());
  };
  write_list(q.pairs, report.found.list);
  write_list(q.first, report.found.first);
  if (q.contacts) {
    report.contacts =
        write_contacts(*q.contacts, q.contacts_float64, report.a, report.b, report.asked, report.found, outputs);
    report.written.push_back(q.contacts->string());
  }
  if (formula) {
    const fs::path values = q.evaluate[1];
    outputs.write(values, [&](const fs::path &to) {
      write_pair_values(to, *formula, report.a, report.b, report.found.list, q.threads);
    });
    report.written.push_back(values.string());
  }
  if (q.colour)
    write_colours(q, a, b, outputs, report);
  if (q.image) {
    outputs.write(*q.image, [&](const fs::path &to) { write_picture(to, {a, b}, q.view); });
    report.written.push_back(q.image->string());
  }
  if (q.page) {
    outputs.write(*q.page, [&](const fs::path &to) { write_page(to, a, b, report); });
    report.written.push_back(q.page->string());
  }
  outputs.commit();
}

} // namespace

printed collide(const catalogue &all, const catalogue &neighbours, const collide_request &q) {
  output_files outputs({q.a, q.b});
  check_outputs(q, outputs);
  const auto start = std::chrono::steady_clock::now();
  const std::vector<const kind_info *> kinds = kinds_of(all);
  check_inputs(q.a, q.b);
  const io::element_set a = io::read(q.a, kinds, q.read_a);
  std::error_code code;
  const bool same_file = fs::equivalent(q.a, q.b, code), moved_a = q.read_a.move.any(), moved_b = q.read_b.move.any();
  std::optional<io::element_set> other; // unless A is collided with itself
  if (!same_file || q.a.extension() != q.b.extension() || q.read_a.format != q.read_b.format ||
      q.read_a.kind != q.read_b.kind || moved_a || moved_b) // the extension names the format
    other = io::read(q.b, kinds, q.read_b);
  const io::element_set &b = other ? *other : a;
  const std::chrono::duration<double> read = std::chrono::steady_clock::now() - start;

  std::optional<formula_choice> formula;
  if (!q.evaluate.empty())
    formula = choose_formula(all, a, b, q.evaluate[0], q.precision == rung::fp32);
  query h;
  h.by = choose(all, *a.kind, *b.kind, q.predicate, q.mode);
  h.precision = q.precision;
  set_tolerance(h, q.tolerance);
  h.box = all.box;
  h.any = q.any;
  h.keep = q.pairs.has_value() || q.page.has_value() || !q.evaluate.empty();
  h.elements = q.contacts.has_value() || (q.page && page_has_contacts(h));
  if (q.contacts)
    require_contacts(*h.by.predicate);
  const self_predicates of_mesh = of_one_mesh(all, neighbours);
  if (q.contacts_embedded && !(is_mesh(a) && is_mesh(b)))
    throw failure(fmt::format("--contacts-embedded goes with two meshes; here are {} and {}", plural_of(a.kind->name),
                              plural_of(b.kind->name)));
  if (q.contacts_embedded)
    h.embedded_by = &of_mesh;
  h.first = q.first.has_value();
  h.threads = q.threads;
  h.devices = q.devices;
  h.on = q.on;
  if (const std::string warning = tolerance_warning(a, b, h); !warning.empty())
    std::fprintf(stderr, "meet: %s\n", warning.c_str());
  auto progress = std::make_unique<progress_line>("collide");
  h.progress = [&progress](double fraction) { (*progress)(fraction); };
  const answers found = collide_sets(a, b, h);
  progress.reset();
  if (const std::string warning = box_warning(h, found); !warning.empty())
    std::fprintf(stderr, "meet: %s\n", warning.c_str());

  collide_report report{
      q.a.string(), q.b.string(), a, b, h, found, same_file, moved_a, moved_b, read.count(), name_of(all.compiled_for),
      {},           {},           {}};
  write_all(q, formula, outputs, report);
  return {q.json ? as_json(report) : summary(report), q.fail_on_touch && found.pairs > 0 ? check_failed : done};
}

} // namespace meetc::app
