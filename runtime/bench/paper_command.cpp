#include "bench/paper_command.hpp"

#include "app/failure.hpp"
#include "app/output_files.hpp"
#include "app/paint.hpp"
#include "app/progress.hpp"
#include "app/report.hpp"
#include "bench/paper_parts.hpp"
#include "core/threads.hpp"
#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

constexpr int figures = 6;

std::string figure_file(int number) {
  return fmt::format("figure_{}.png", number);
}

void expect_files(const fs::path &folder, output_files &outputs) {
  if (folder.empty())
    throw failure("-o: the folder's name is empty");
  outputs.expect(folder / "paper.md", true);
  for (int i = 1; i <= figures; ++i)
    outputs.expect(folder / figure_file(i), true);
}

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

std::string text_of(const paper_result &r, const paper_bodies &bodies, const bench_device *device) {
  std::string out = fmt::format("{}\n{}\n{}\n", bodies.in_words(), machine(device), rules);
  for (const table &t : r.tables)
    out += fmt::format("\n{}", as_text(t));
  return out;
}

std::string markdown_of(const paper_result &r, const paper_bodies &bodies, const bench_device *device,
                        const std::string &command) {
  std::string out = fmt::format("# The paper's tables and figures again\n\nWritten by `{}`.\n\n{}\n\n{}\n\n{}\n",
                                command, bodies.in_words(), machine(device), rules);
  for (const table &t : r.tables)
    out += fmt::format("\n{}", as_markdown(t));
  out += "\n## Figures\n";
  for (const paper_figure &f : r.figures)
    out += fmt::format("\n![Figure {}: {}]({})\n\nFigure {}: {}\n", f.number, f.title, figure_file(f.number), f.number,
                       f.title);
  return out;
}

std::string json_of(const paper_result &r, const paper_request &q, const paper_bodies &bodies,
                    const bench_device *device, int threads) {
  std::string tables, laws, drawn;
  for (const table &t : r.tables)
    tables += fmt::format("{}{}", tables.empty() ? "" : ",", as_json(t));
  for (const paper_law &law : r.laws)
    laws += fmt::format("{}\"{}\":{}", laws.empty() ? "" : ",", law.name, as_json(law.fit));
  for (const paper_figure &f : r.figures)
    if (q.folder)
      drawn += fmt::format("{}{}", drawn.empty() ? "" : ",", json_string(figure_file(f.number)));
  return fmt::format(R"({{"meshes":"{}","pose":{},"device":{},"quick":{},"threads":{},"tables":[{}],"laws":{{{}}},)"
                     R"("figures":[{}]}})"
                     "\n",
                     q.data ? "files" : "built-in", json_string(bodies.pose_options()),
                     device ? json_string(device->name()) : "null", q.quick, threads, tables, laws, drawn);
}

void draw_figure(const fs::path &to, const paper_figure &f, int width, int height) {
  if (f.plot) {
    write_png(to, draw(*f.plot, width, height));
    return;
  }
  const paper_scene &s = *f.scene;
  std::vector<painted> sides{{s.a, s.hit_a, s.name_a, s.base_a, s.hit_colour_a}};
  if (s.b.kind)
    sides.push_back({s.b, s.hit_b, s.name_b, s.base_b, s.hit_colour_b});
  write_picture(to, sides, {}, width, height);
}

void write_text(const fs::path &to, const std::string &text) {
  io::atomic_file file(to);
  file.write(text);
  file.commit();
}

} // namespace

std::string paper(const catalogue &all, const paper_request &q) {
  output_files outputs;
  if (q.folder)
    expect_files(*q.folder, outputs);
  const std::unique_ptr<bench_device> device = bench_device_named(q.device);
  const paper_bodies bodies(all, q.data, q.quick);

  const int threads = thread_count(q.threads);
  yardstick by;
  paper_context c{all, bodies, device.get(), by, q.quick, threads, q.quick ? 3 : 5, q.quick ? 300'000u : 5'000'000u,
                  {}};
  const std::size_t rows = mesh_rows(c) + sphere_rows(c) + segment_rows(c);
  std::size_t done_rows = 0;
  auto progress = std::make_unique<progress_line>("bench paper");
  c.advance = [&] { (*progress)(static_cast<double>(++done_rows) / static_cast<double>(rows)); };
  (*progress)(0);
  paper_result r;
  add_meshes(c, r);
  add_spheres(c, r);
  add_segments(c, r);
  progress.reset();
  std::sort(r.figures.begin(), r.figures.end(),
            [](const paper_figure &x, const paper_figure &y) { return x.number < y.number; });

  std::string written;
  if (q.folder) {
    outputs.make_folder(*q.folder);
    const std::string command =
        fmt::format("meet bench paper{}{} -o DIR", q.quick ? " --quick" : "", q.data ? " --data FOLDER" : "");
    const fs::path page = *q.folder / "paper.md";
    outputs.write(page, [&](const fs::path &to) { write_text(to, markdown_of(r, bodies, device.get(), command)); });
    written += fmt::format("wrote {}\n", page.string());
    for (const paper_figure &f : r.figures) {
      const fs::path path = *q.folder / figure_file(f.number);
      outputs.write(path, [&](const fs::path &to) {
        draw_figure(to, f, q.quick ? 800 : f.plot ? 1000 : 1600, q.quick ? 450 : f.plot ? 650 : 900);
      });
      written += fmt::format("wrote {}\n", path.string());
    }
    outputs.commit();
  }
  return q.json ? json_of(r, q, bodies, device.get(), threads)
                : text_of(r, bodies, device.get()) + (written.empty() ? "" : "\n" + written);
}

} // namespace meetc::app
