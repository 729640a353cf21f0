#include "bench/tables/paper/command.hpp"

#include "app/failure.hpp"
#include "app/output_files.hpp"
#include "app/progress.hpp"
#include "bench/harness/gnuplot.hpp"
#include "bench/tables/paper/figures.hpp"
#include "bench/tables/paper/parts.hpp"
#include "bench/tables/paper/report.hpp"
#include "core/threads.hpp"
#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace meetc::bench {

namespace fs = std::filesystem;

namespace {

void expect_files(const fs::path &folder, app::output_files &outputs) {
  if (folder.empty())
    throw app::failure("-o: the folder's name is empty");
  outputs.expect(folder / "paper.md", true);
  for (int i = 1; i <= figures; ++i)
    outputs.expect(folder / figure_file(i), true);
}

} // namespace

std::string paper(const catalogue &all, const paper_request &q) {
  app::output_files outputs;
  if (q.folder) {
    expect_files(*q.folder, outputs);
    need_gnuplot(); // fails before the work starts
  }
  const std::unique_ptr<bench_device> device = bench_device_named(q.device);
  const paper_bodies bodies(all, q.data, q.quick);

  const int threads = thread_count(q.threads);
  yardstick by;
  paper_context c{all, bodies, device.get(), by, q.quick, threads, q.quick ? 3 : 5, q.quick ? 300'000u : 5'000'000u,
                  {}};
  const std::size_t rows = mesh_rows(c) + sphere_rows(c) + segment_rows(c);
  std::size_t done_rows = 0;
  auto progress = std::make_unique<app::progress_line>("bench paper");
  c.advance = [&] { (*progress)(static_cast<double>(++done_rows) / static_cast<double>(rows)); };
  (*progress)(0);
  paper_result r;
  add_meshes(c, r);
  add_spheres(c, r);
  add_segments(c, r);
  progress.reset();
  std::sort(r.figures.begin(), r.figures.end(),
            [](const paper_figure &x, const paper_figure &y) { return x.number < y.number; });

  const paper_report report{r, bodies, device.get(), q.data.has_value(), q.quick, threads, q.folder.has_value()};
  std::string written;
  if (q.folder) {
    outputs.make_folder(*q.folder);
    const std::string command =
        fmt::format("meet bench paper{}{} -o DIR", q.quick ? " --quick" : "", q.data ? " --data FOLDER" : "");
    const fs::path page = *q.folder / "paper.md";
    outputs.write(page, [&](const fs::path &to) { io::write_file(to, as_markdown(report, command)); });
    written += fmt::format("wrote {}\n", page.string());
    for (const paper_figure &f : r.figures) {
      const fs::path path = *q.folder / figure_file(f.number);
      outputs.write(path, [&](const fs::path &to) { draw_figure(to, f, q.quick); });
      written += fmt::format("wrote {}\n", path.string());
    }
    outputs.commit();
  }
  return q.json ? as_json(report) : as_text(report) + (written.empty() ? "" : "\n" + written);
}

} // namespace meetc::bench
