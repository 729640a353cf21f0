// The costs of scenes, beside each other: a scene's code and programs hold the requested kernels and nothing else.
#include "gen/columns.hpp"
#include "gen/compare_kernels.hpp"
#include "gen/formula_costs.hpp"
#include "gen/ir/count.hpp"
#include "gen/support/output.hpp"
#include "gen/support/process.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/timing.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <sstream>
#include <unistd.h>

namespace meetc {
namespace {

namespace fs = std::filesystem;

struct scene_figures {
  std::string name, kinds;
  std::size_t kernels = 0, files = 0, cpp_bytes = 0, cuda_bytes = 0;
  // Sums over all kernels, in multiplications and additions.
  int for_objects = 0, for_pairs = 0, for_rare_pairs = 0;
  std::size_t stored = 0;
  std::optional<std::size_t> object_bytes;
  std::optional<double> compile_seconds;
  std::optional<int> registers;                            // the most of any device kernel
  std::vector<std::pair<std::string, double>> nanoseconds; // a pair, by predicate
  std::string formulas;                                    // a table, if it is asked for
  std::vector<kernel_figures> each;                        // where they are asked for
};

void count_kernel(const lower::kernel &k, scene_figures &to) {
  lower::kernel copy = k; // programs() returns references that passes may replace
  if (!k.is_predicate) {
    to.for_pairs += cheapest(k.value).total();
    return;
  }
  for (const lower::kernel_program &p : lower::programs(copy)) {
    if (p.as == lower::use::once && !k.is_sign) {
      to.for_rare_pairs += ir::count(p.code->nodes, p.code->results).total();
      continue;
    }
    to.for_pairs += ir::count_pair(*p.code).total();
    for (const poly::residency object : {poly::residency::a, poly::residency::b}) {
      to.for_objects += ir::count_object(*p.code, object).total();
      to.stored += ir::stored_of(*p.code, object).size();
    }
  }
}

// A folder that is removed at the end.
class scratch_folder {
public:
  scratch_folder() : at_(fs::temp_directory_path() / fmt::format("meetc-compare-{}", ::getpid())) {
    fs::create_directories(at_);
  }
  ~scratch_folder() {
    std::error_code ignored;
    fs::remove_all(at_, ignored);
  }
  scratch_folder(const scratch_folder &) = delete;
  scratch_folder &operator=(const scratch_folder &) = delete;
  const fs::path &at() const { return at_; }

private:
  fs::path at_;
};

// The first line that names an error, or else the first one.
std::string first_error(const std::string &said) {
  const std::size_t error = said.find("error"), at = error == std::string::npos ? 0 : said.rfind('\n', error) + 1;
  return said.substr(at, said.find('\n', at) - at);
}

finished_process compile_file(const std::vector<std::string> &words) {
  finished_process done = run_process(words);
  if (done.code == 127)
    throw spec_error({}, fmt::format("{}: cannot be run", words.front()));
  if (done.code != 0)
    throw spec_error({}, fmt::format("{}: failed: {}", words.front(), first_error(done.said)));
  return done;
}

// The largest N in "Used N registers".
int most_registers(const std::string &said) {
  int most = 0;
  for (std::size_t at = 0; (at = said.find("Used ", at)) != std::string::npos; at += 5)
    most = std::max(most, std::atoi(said.c_str() + at + 5));
  return most;
}

// Nanoseconds of a pair and of an evaluation, by predicate and by formula.
struct times {
  std::vector<std::pair<std::string, double>> predicates;
  std::map<std::string, double> formulas;
};

// Links the objects with the program that times them, and runs it.
times time_kernels(const compare_options &o, const std::string &space, const fs::path &folder,
                   const std::vector<std::string> &objects) {
  const std::string source = (folder / "timing.cpp").string(), program = (folder / "timing").string();
  std::ofstream(source, std::ios::binary) << timing_program(space);
  std::vector<std::string> words{o.cxx, "-std=c++20", "-O2", "-ffp-contract=off", "-I" + folder.string(), source};
  words.insert(words.end(), objects.begin(), objects.end());
  words.insert(words.end(), {"-o", program});
  compile_file(words);
  std::istringstream lines(compile_file({program}).said);
  times out;
  std::string what, name;
  for (double nanoseconds = 0; lines >> what >> nanoseconds && std::getline(lines >> std::ws, name);)
    if (what == "formula")
      out.formulas[name] = nanoseconds;
    else
      out.predicates.emplace_back(name, nanoseconds);
  return out;
}

// Compiles the sources as a build does: those of C++ by `cxx`, those of CUDA by `nvcc`, where these are given.
// Returns what the program that times them says.
times compile_files(const std::vector<target::file> &files, const std::string &space, const compare_options &o,
                    scene_figures &to) {
  const scratch_folder folder;
  for (const target::file &f : files) {
    fs::create_directories((folder.at() / f.path).parent_path());
    std::ofstream(folder.at() / f.path, std::ios::binary) << f.text;
  }
  const std::string cubin = (folder.at() / "object.cubin").string(), include = "-I" + folder.at().string();
  std::vector<std::string> objects;
  std::size_t bytes = 0;
  double seconds = 0;
  int registers = 0;
  bool device = false;
  times out;
  for (const target::file &f : files) {
    const std::string source = (folder.at() / f.path).string();
    if (!o.cxx.empty() && f.path.ends_with(".cpp")) {
      const std::string object = objects.emplace_back((folder.at() / fmt::format("{}.o", objects.size())).string());
      seconds +=
          compile_file({o.cxx, "-std=c++20", "-O2", "-ffp-contract=off", include, "-c", source, "-o", object}).seconds;
      bytes += fs::file_size(object);
    } else if (!o.nvcc.empty() && f.path.ends_with(".cu")) {
      device = true;
      registers =
          std::max(registers, most_registers(compile_file({o.nvcc, "-std=c++20", "-O3", "--fmad=false", "-arch=sm_90",
                                                           "-Xptxas", "-v", include, "-cubin", source, "-o", cubin})
                                                 .said));
    }
  }
  if (!o.cxx.empty()) {
    to.object_bytes = bytes;
    to.compile_seconds = seconds;
    out = time_kernels(o, space, folder.at(), objects);
    to.nanoseconds = out.predicates;
  }
  if (device)
    to.registers = registers;
  return out;
}

// The names of scenes: the stems of their files, and the paths as the user wrote them where stems are equal.
std::vector<std::string> names_of(const std::vector<std::string> &scenes) {
  const auto stem = [](const std::string &path) { return fs::path(path).stem().string(); };
  std::vector<std::string> out;
  for (const std::string &path : scenes) {
    const auto alike = std::count_if(scenes.begin(), scenes.end(),
                                     [&](const std::string &other) { return stem(other) == stem(path); });
    out.push_back(alike > 1 ? path : stem(path));
  }
  return out;
}

scene_figures figures_of(const std::string &scene, const std::string &name, const compare_options &o,
                         const published_counts &beside, std::vector<formula_cost> &formulas) {
  compilation c = load(scene, o.algebra_path);
  compile_all(c);
  scene_figures out;
  out.name = name;
  out.kernels = c.kernels.size();
  for (const lower::kernel &k : c.kernels)
    count_kernel(k, out);
  for (const lower::lowered_kind &k : lower::kinds_of(*c.model, c.kernels))
    out.kinds += (out.kinds.empty() ? "" : " ") + k.name;
  const std::vector<formula_cost> costs = o.formulas ? formula_costs(c) : std::vector<formula_cost>();
  if (o.kernels)
    out.each = kernel_figures_of(c);
  const std::vector<target::file> files = emit_all(c);
  for (const target::file &f : files) {
    if (f.path.starts_with("meetc/")) // the kernel headers are the same for every scene
      continue;
    const bool cpp = f.path.ends_with(".cpp") || f.path.ends_with(".hpp"),
               cuda = f.path.ends_with(".cu") || f.path.ends_with("_cuda.hpp");
    out.files += cpp || cuda;
    (cuda ? out.cuda_bytes : out.cpp_bytes) += cpp || cuda ? f.text.size() : 0;
  }
  times took;
  if (!o.cxx.empty() || !o.nvcc.empty())
    took = compile_files(files, target::identifier(c.scene->space), o, out);
  out.formulas = costs.empty() ? "" : formula_table(costs, took.formulas, beside);
  formulas.insert(formulas.end(), costs.begin(), costs.end());
  return out;
}

std::string kilobytes(std::size_t bytes) {
  return fmt::format("{:.1f}", static_cast<double>(bytes) / 1000);
}

// Nanoseconds of a pair, by predicate and scene.
std::string times_of(const std::vector<scene_figures> &all) {
  std::vector<std::vector<std::string>> rows{{"ns a pair"}};
  std::vector<std::string> predicates;
  for (const scene_figures &f : all) {
    rows[0].push_back(f.name);
    for (const auto &[name, nanoseconds] : f.nanoseconds)
      if (std::find(predicates.begin(), predicates.end(), name) == predicates.end())
        predicates.push_back(name);
  }
  for (const std::string &name : predicates) {
    std::vector<std::string> &row = rows.emplace_back(1, name);
    for (const scene_figures &f : all) {
      const auto at =
          std::find_if(f.nanoseconds.begin(), f.nanoseconds.end(), [&](const auto &x) { return x.first == name; });
      row.push_back(at == f.nanoseconds.end() ? "-" : fmt::format("{:.1f}", at->second));
    }
  }
  return in_columns(rows, false);
}

std::string table_of(const std::vector<scene_figures> &all, const compare_options &o) {
  std::vector<std::vector<std::string>> rows{
      {"scene", "kernels", "files", "C++ KB", "CUDA KB", "object", "pair", "rare pair", "stored"}};
  if (!o.cxx.empty())
    rows[0].insert(rows[0].end(), {"object KB", "compile s"});
  if (!o.nvcc.empty())
    rows[0].emplace_back("registers");
  rows[0].emplace_back("kinds");
  for (const scene_figures &f : all) {
    std::vector<std::string> row{f.name,
                                 fmt::format("{}", f.kernels),
                                 fmt::format("{}", f.files),
                                 kilobytes(f.cpp_bytes),
                                 kilobytes(f.cuda_bytes),
                                 fmt::format("{}", f.for_objects),
                                 fmt::format("{}", f.for_pairs),
                                 fmt::format("{}", f.for_rare_pairs),
                                 fmt::format("{}", f.stored)};
    if (!o.cxx.empty()) {
      row.push_back(kilobytes(f.object_bytes.value_or(0)));
      row.push_back(fmt::format("{:.1f}", f.compile_seconds.value_or(0)));
    }
    if (!o.nvcc.empty())
      row.push_back(f.registers ? fmt::format("{}", *f.registers) : "-");
    row.push_back(f.kinds);
    rows.push_back(std::move(row));
  }
  return in_columns(rows, true);
}

} // namespace

int compare_scenes(const compare_options &o) {
  const published_counts beside = o.beside.empty() ? published_counts{} : read_published(o.beside);
  std::vector<scene_figures> all;
  std::vector<formula_cost> formulas; // of all scenes
  const std::vector<std::string> names = names_of(o.scenes);
  for (std::size_t i = 0; i < o.scenes.size(); ++i)
    all.push_back(figures_of(o.scenes[i], names[i], o, beside, formulas));
  require_asked(beside, formulas);
  say(table_of(all, o));
  for (const scene_figures &f : all)
    if (!f.formulas.empty())
      say(fmt::format("\nformulas of {}\n{}", f.name, f.formulas));
  if (std::any_of(all.begin(), all.end(), [](const scene_figures &f) { return !f.nanoseconds.empty(); }))
    say('\n' + times_of(all));
  if (o.kernels) {
    std::vector<std::vector<kernel_figures>> each;
    for (scene_figures &f : all)
      each.push_back(std::move(f.each));
    say('\n' + in_columns(kernel_rows(names, each), false));
  }
  return 0;
}

} // namespace meetc
