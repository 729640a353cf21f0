#include "bench/tables/gpu/command.hpp"

#include "app/failure.hpp"

#if MEETC_WITH_CUDA
#include "app/output_files.hpp"
#include "app/progress.hpp"
#include "bench/tables/gpu/measure.hpp"
#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <memory>
#include <vector>
#endif

namespace meetc::bench {

#if MEETC_WITH_CUDA

namespace {

constexpr const char *rules =
    "A filter alone lists pairs whose enclosing balls may touch; a query is the whole: columns where the sets are new, "
    "filter, boxes, rungs, sorted pairs. With transfers: from the host's memory to the pairs in it, with the extent "
    "and "
    "the columns of both sets.";

// Whether --only leaves a table that has a name: "growth" or "poses"; "hard", "lbvh", "first", "memory" and
// "group" are only measured if asked for. After a colon there may be a part of the names of the table's scenes.
bool is_asked(const gpu_request &q, const char *name) {
  return q.only && q.only->substr(0, q.only->find(':')) == name;
}
bool is_meant(const gpu_request &q, const char *name) {
  return !q.only || is_asked(q, name);
}

void keep(std::vector<gpu_scene> &scenes, const std::string &part) {
  std::erase_if(scenes, [&part](const gpu_scene &s) { return s.name.find(part) == std::string::npos; });
}
std::vector<gpu_scene> scenes_of_table(const gpu_request &q, std::vector<gpu_scene> scenes) {
  if (const std::size_t colon = q.only ? q.only->find(':') : std::string::npos; colon != std::string::npos)
    keep(scenes, q.only->substr(colon + 1));
  return scenes;
}

} // namespace

std::string gpu(const catalogue &all, const gpu_request &q) {
  app::output_files outputs;
  if (q.folder)
    for (const char *file : {"gpu.md", "gpu.json"})
      outputs.expect(*q.folder / file, true);
  try {
    gpu_bench bench(all, q.quick);
    std::vector<gpu_scene> scenes = gpu_scenes(all, q.data, q.quick);
    if (q.only)
      keep(scenes, *q.only);
    struct search_table {
      const char *name, *title;
      std::vector<gpu_scene> scenes;
    };
    std::vector<search_table> searches;
    if (is_meant(q, "growth"))
      searches.push_back({"growth", "Growth with the sets", scenes_of_table(q, growth_scenes(all, q.data, q.quick))});
    if (is_asked(q, "hard"))
      searches.push_back({"hard", "Sets that do not lie evenly", scenes_of_table(q, hard_scenes(all, q.quick))});
    const auto if_asked = [&](const char *name, const auto &scenes_with) {
      return is_asked(q, name) ? scenes_of_table(q, scenes_with(all, q.data, q.quick)) : std::vector<gpu_scene>{};
    };
    const std::vector<gpu_scene> beside_lbvh = if_asked("lbvh", growth_scenes), first = if_asked("first", first_scenes),
                                 of_memory = if_asked("memory", growth_scenes),
                                 grouped = if_asked("group", group_scenes);
    std::erase_if(searches, [](const search_table &t) { return t.scenes.empty(); });
    std::size_t steps = scenes.size() + beside_lbvh.size() + first.size() + of_memory.size() + grouped.size() + 1;
    for (const search_table &t : searches)
      steps += t.scenes.size();
    const std::optional<posed_meshes> poses =
        is_meant(q, "poses") ? std::optional(meshes_for_poses(all, q.data, q.quick)) : std::nullopt;
    if (steps == 1 && !poses)
      throw app::failure(fmt::format("--only {}: no scene has this in its name", io::quote(*q.only)));
    auto progress = std::make_unique<app::progress_line>("bench gpu");
    std::vector<table> tables;
    double done = 0;
    const auto step = [&] { (*progress)(++done / static_cast<double>(steps)); };
    for (const gpu_scene &s : scenes) {
      tables.push_back(bench.measure(s));
      step();
    }
    if (!q.only)
      tables.push_back(bench.measure_tangent());
    for (const search_table &t : searches)
      tables.push_back(bench.measure_searches(t.name, t.title, t.scenes, step));
    if (!beside_lbvh.empty())
      tables.push_back(bench.measure_lbvh(beside_lbvh, step));
    if (!first.empty())
      tables.push_back(bench.measure_first(first, step));
    if (!of_memory.empty())
      tables.push_back(bench.measure_memory(of_memory, step));
    if (!grouped.empty())
      tables.push_back(bench.measure_group(grouped, step));
    if (poses)
      tables.push_back(bench.measure_poses(*poses));
    progress.reset();
    std::string text = fmt::format("{}\n{}\n", bench.device_in_words(), rules);
    std::string markdown = fmt::format("# Measured on a GPU\n\nWritten by `meet bench gpu{}{}{} -o DIR`.\n\n{}\n\n{}\n",
                                       q.quick ? " --quick" : "", q.data ? " --data FOLDER" : "",
                                       q.only ? " --only TEXT" : "", bench.device_in_words(), rules);
    app::json json_tables = app::json::array();
    for (const table &t : tables) {
      text += fmt::format("\n{}", as_text(t));
      markdown += fmt::format("\n{}", as_markdown(t));
      json_tables.push_back(as_json(t));
    }
    const std::string json = app::in_one_line({{"device", bench.device_in_words()},
                                               {"quick", q.quick},
                                               {"meshes", q.data ? "files" : "built-in"},
                                               {"tables", std::move(json_tables)}}) +
                             '\n';
    if (q.folder) {
      outputs.make_folder(*q.folder);
      const auto write = [&](const char *file, const std::string &content) {
        outputs.write(*q.folder / file, [&content](const std::filesystem::path &to) { io::write_file(to, content); });
      };
      write("gpu.md", markdown);
      write("gpu.json", json);
      outputs.commit();
      text += fmt::format("\nwrote {} and gpu.json\n", (*q.folder / "gpu.md").string());
    }
    return q.json ? json : text;
  } catch (const device_error &e) {
    throw app::failure(e.what(), app::no_device);
  }
}

#else

std::string gpu(const catalogue &, const gpu_request &) {
  throw app::failure("bench gpu: this build has no CUDA kernels (" MEETC_NO_CUDA "); meet bench paper times the CPU",
                     app::no_device);
}

#endif

} // namespace meetc::bench
