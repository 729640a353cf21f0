#include "meet/bench/tables/paper/paper.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/text/progress.hpp"
#include "meet/bench/harness/machine.hpp"
#include "meet/bench/harness/report.hpp"
#include "meet/bench/tables/tables.hpp"
#include "meet/core/threads/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace meetc::bench {

namespace {

constexpr int figures = 6;

std::string figure_file(int number) {
  return fmt::format("figure_{}.png", number);
}

paper_result measure_all(paper_context &c) {
  app::progress_line progress("bench paper");
  const std::size_t rows = mesh_rows(c) + sphere_rows(c) + segment_rows(c);
  c.advance = [&progress, rows, done = 0.0]() mutable { progress(++done / static_cast<double>(rows)); };
  progress(0);
  paper_result out;
  add_meshes(c, out);
  add_spheres(c, out);
  add_segments(c, out);
  c.advance = {};
  std::sort(out.figures.begin(), out.figures.end(),
            [](const paper_figure &x, const paper_figure &y) { return x.number < y.number; });
  return out;
}

} // namespace

std::string paper(const catalogue &all, const request &q) {
  std::vector<std::string> names{"paper.md"};
  for (int i = 1; i <= figures; ++i)
    names.push_back(figure_file(i));
  report_folder folder(q.folder, names);
  const std::unique_ptr<bench_device> device = bench_device_named(q.device);
  const paper_bodies bodies(all, q.data, q.quick);
  paper_context c{
      all, bodies, device.get(), q.quick, thread_count(q.threads), q.quick ? 3 : 5, q.quick ? 300'000U : 5'000'000U,
      {}};
  paper_result found = measure_all(c);

  app::json laws = app::json::object(), drawn = app::json::array();
  for (const paper_scaling &s : found.scalings)
    laws[s.name] = as_json(s.fit);
  report r{"The paper's tables and figures again",
           in_words("meet bench paper", q),
           {bodies.in_words(),
            fmt::format("{} {}", machine_in_words(),
                        device ? fmt::format("GPU: {}.", device->name())
                               : "There is no device, so the columns of the GPU are empty."),
            "CPU times are ratios within one run, medians; only a GPU's are absolute. Counts are certified."},
           {},
           std::move(found.tables),
           {}};
  for (const paper_figure &f : found.figures) {
    r.files.push_back({figure_file(f.number), f.draw, fmt::format("Figure {}: {}", f.number, f.title)});
    if (q.folder)
      drawn.push_back(figure_file(f.number));
  }
  r.facts = {{"meshes", q.data ? "files" : "built-in"},
             {"pose", bodies.pose_options()},
             {"device", device ? app::json(device->name()) : app::json()},
             {"quick", q.quick},
             {"threads", c.threads},
             {"laws", std::move(laws)},
             {"figures", std::move(drawn)}};
  return folder.write(r, q.json);
}

} // namespace meetc::bench
