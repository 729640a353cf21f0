#include "bench/tables/paper/report.hpp"

#include "bench/tables/paper/figures.hpp"
#include "core/threads.hpp"

#include <fmt/format.h>

namespace meetc::bench {

namespace {

std::string machine(const bench_device *device) {
#if defined(__x86_64__)
  constexpr const char *processor = "x86-64";
#elif defined(__aarch64__)
  constexpr const char *processor = "AArch64";
#else
  constexpr const char *processor = "of another kind";
#endif
  const int cores = thread_count(0);
  return fmt::format("{} core{} {}; {}.", cores, cores == 1 ? "" : "s", processor,
                     device ? "GPU: " + device->name() : "no device, so the columns of the GPU are empty");
}

constexpr const char *rules =
    "CPU times are ratios within one run, medians; only a GPU's are absolute. Counts are certified.";

} // namespace

std::string as_text(const paper_report &r) {
  std::string out = fmt::format("{}\n{}\n{}\n", r.bodies.in_words(), machine(r.device), rules);
  for (const table &t : r.found.tables)
    out += fmt::format("\n{}", as_text(t));
  return out;
}

std::string as_markdown(const paper_report &r, const std::string &command) {
  std::string out = fmt::format("# The paper's tables and figures again\n\nWritten by `{}`.\n\n{}\n\n{}\n\n{}\n",
                                command, r.bodies.in_words(), machine(r.device), rules);
  for (const table &t : r.found.tables)
    out += fmt::format("\n{}", as_markdown(t));
  out += "\n## Figures\n";
  for (const paper_figure &f : r.found.figures)
    out += fmt::format("\n![Figure {}: {}]({})\n\nFigure {}: {}\n", f.number, f.title, figure_file(f.number), f.number,
                       f.title);
  return out;
}

std::string as_json(const paper_report &r) {
  app::json tables = app::json::array(), scalings = app::json::object(), drawn = app::json::array();
  for (const table &t : r.found.tables)
    tables.push_back(as_json(t));
  for (const paper_scaling &s : r.found.scalings)
    scalings[s.name] = as_json(s.fit);
  if (r.drawn)
    for (const paper_figure &f : r.found.figures)
      drawn.push_back(figure_file(f.number));
  const app::json out = {{"meshes", r.from_files ? "files" : "built-in"},
                         {"pose", r.bodies.pose_options()},
                         {"device", r.device ? app::json(r.device->name()) : app::json()},
                         {"quick", r.quick},
                         {"threads", r.threads},
                         {"tables", std::move(tables)},
                         {"laws", std::move(scalings)},
                         {"figures", std::move(drawn)}};
  return app::in_one_line(out) + '\n';
}

} // namespace meetc::bench
