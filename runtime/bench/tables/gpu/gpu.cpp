#include "meet/app/input/failure.hpp"
#include "meet/bench/tables/tables.hpp"

#if MEETC_WITH_CUDA
#include "meet/app/text/progress.hpp"
#include "meet/bench/harness/report.hpp"
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/io/files/atomic_file.hpp"

#include <fmt/format.h>

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

using scenes_of = std::vector<scene> (*)(const scene_source &from);
using measure_scenes = table (*)(gpu_bench &on, const std::vector<scene> &scenes, const std::function<void()> &step);

// A table that --only may name, after which a colon and a part of its scenes' names may stand.
struct named_table {
  const char *name;
  bool if_asked_alone; // it is not measured otherwise
  scenes_of scenes;
  measure_scenes measure;
};
constexpr named_table named_tables[] = {
    {"growth", false, growth_scenes,
     [](gpu_bench &on, const auto &scenes, const auto &step) { return on.measure_growth(scenes, step); }},
    {"hard", true, hard_scenes,
     [](gpu_bench &on, const auto &scenes, const auto &step) { return on.measure_hard(scenes, step); }},
    {"lbvh", true, growth_scenes,
     [](gpu_bench &on, const auto &scenes, const auto &step) { return on.measure_lbvh(scenes, step); }},
    {"first", true, first_scenes,
     [](gpu_bench &on, const auto &scenes, const auto &step) { return on.measure_first(scenes, step); }},
    {"contacts", true, contact_scenes,
     [](gpu_bench &on, const auto &scenes, const auto &step) { return on.measure_contacts(scenes, step); }},
    {"self", true, self_scenes,
     [](gpu_bench &on, const auto &scenes, const auto &step) { return on.measure_self(scenes, step); }},
    {"memory", true, growth_scenes,
     [](gpu_bench &on, const auto &scenes, const auto &step) { return on.measure_memory(scenes, step); }},
    {"group", true, group_scenes,
     [](gpu_bench &on, const auto &scenes, const auto &step) { return on.measure_group(scenes, step); }},
};

bool is_asked(const request &q, const char *name, bool if_asked_alone) {
  return q.only ? q.only->substr(0, q.only->find(':')) == name : !if_asked_alone;
}

std::vector<scene> with(std::vector<scene> scenes, const std::string &part) {
  std::erase_if(scenes, [&part](const scene &s) { return s.name.find(part) == std::string::npos; });
  return scenes;
}

struct wanted_table {
  std::vector<scene> scenes;
  measure_scenes measure;
};

std::vector<wanted_table> wanted_tables(const scene_source &from, const request &q) {
  const std::size_t colon = q.only ? q.only->find(':') : std::string::npos;
  const std::string part = colon == std::string::npos ? "" : q.only->substr(colon + 1);
  std::vector<wanted_table> out;
  for (const named_table &t : named_tables)
    if (is_asked(q, t.name, t.if_asked_alone))
      out.push_back({with(t.scenes(from), part), t.measure});
  std::erase_if(out, [](const wanted_table &t) { return t.scenes.empty(); });
  return out;
}

std::vector<table> measure_all(gpu_bench &on, const scene_source &from, const request &q) {
  const std::vector<scene> scenes = with(kernel_scenes(from), q.only.value_or(""));
  const std::vector<wanted_table> wanted = wanted_tables(from, q);
  const std::optional<posed_meshes> poses =
      is_asked(q, "poses", false) ? std::optional(meshes_for_poses(from)) : std::nullopt;
  std::size_t steps = scenes.size() + 1;
  for (const wanted_table &t : wanted)
    steps += t.scenes.size();
  const bool formulas = is_asked(q, "formulas", true);
  const bool bodies = is_asked(q, "bodies", true);
  if (steps == 1 && !poses && !formulas && !bodies)
    throw app::failure(fmt::format("--only {}: no scene has this in its name", io::quote(*q.only)));
  app::progress_line progress("bench gpu");
  double done = 0;
  const std::function<void()> step = [&] { progress(++done / static_cast<double>(steps)); };
  std::vector<table> out;
  for (const scene &s : scenes) {
    out.push_back(on.measure(s));
    step();
  }
  if (!q.only)
    out.push_back(on.measure_tangent());
  for (const wanted_table &t : wanted)
    out.push_back(t.measure(on, t.scenes, step));
  if (poses)
    out.push_back(on.measure_poses(*poses));
  if (formulas)
    out.push_back(on.measure_formulas(q.quick ? 100'000 : 20'000'000));
  if (bodies)
    out.push_back(on.measure_bodies(q.quick ? 10 : 100, q.quick ? 3 : 31));
  return out;
}

} // namespace

std::string gpu(const catalogue &all, const request &q) {
  report_folder folder(q.folder, {"gpu.md", "gpu.json"});
  try {
    const scene_source from{all, q.data, q.quick};
    gpu_bench on(from);
    std::vector<table> tables = measure_all(on, from, q);
    report r{"Measured on a GPU",
             in_words("meet bench gpu", q),
             {on.device_in_words(), rules},
             {{"device", on.device_in_words()}, {"quick", q.quick}, {"meshes", q.data ? "files" : "built-in"}},
             std::move(tables),
             {}};
    r.files.push_back({"gpu.json", [text = as_json(r)](const std::filesystem::path &to) { io::write_file(to, text); }});
    return folder.write(r, q.json);
  } catch (const device_error &e) {
    throw app::failure(e.what(), app::no_device);
  }
}

#else

std::string gpu(const catalogue &, const request &) {
  throw app::failure("bench gpu: this build has no CUDA kernels (" MEETC_NO_CUDA "); meet bench paper times the CPU",
                     app::no_device);
}

#endif

} // namespace meetc::bench
