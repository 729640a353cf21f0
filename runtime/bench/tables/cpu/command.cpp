#include "bench/tables/cpu/command.hpp"

#include "app/failure.hpp"
#include "app/output_files.hpp"
#include "app/progress.hpp"
#include "bench/harness/machine.hpp"
#include "bench/peers/peers.hpp"
#include "bench/tables/cpu/parts.hpp"
#include "core/threads.hpp"
#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>

namespace meetc::bench {

namespace {

struct family {
  const char *name;
  void (*measure)(const cpu_context &, cpu_result &);
};
constexpr std::array families{family{"precision", measure_precision}, family{"candidates", measure_candidates},
                              family{"balls", measure_balls}, family{"families", measure_families}};

constexpr const char *rules =
    "Each figure is from one run in which all works of a table take turns; the lower quartile counts. With one thread "
    "times are those of the process on its cores, with more they are wall-clock times. Every answer is compared with "
    "`exact`, other libraries' too. What a library offers was compiled as the notes below each table say.";

std::vector<const catalogue *> kernels_to_measure(const app::kernel_library &all, const std::string &named) {
  if (named != "auto")
    return {&app::kernels_named(all, named)};
  std::vector<const catalogue *> out;
  for (int s = 0; s < instruction_set_count; ++s)
    if (const catalogue *kernels = all.of(static_cast<instruction_set>(s)))
      out.push_back(kernels);
  return out;
}

std::string peers_in_words() {
  std::string words;
  for (const peers::library &l : peers::libraries())
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", l.name, l.built_in ? l.version : "not built in");
  return words;
}

} // namespace

std::string cpu(const app::kernel_library &kernels, const cpu_request &q) {
  app::output_files outputs;
  if (q.folder)
    outputs.expect(*q.folder / "cpu.md", true);
  const std::vector<const catalogue *> chosen = kernels_to_measure(kernels, q.instruction_set);
  const cpu_sets sets(*chosen.back(), q.data, q.quick);
  const cpu_context c{chosen, sets, thread_count(q.threads), q.repetitions, q.quick};
  std::vector<family> wanted;
  for (const family &f : families)
    if (!q.only || std::string(f.name).find(*q.only) != std::string::npos)
      wanted.push_back(f);
  if (wanted.empty())
    throw app::failure(fmt::format("--only {}: no family has this in its name", io::quote(*q.only)));

  auto progress = std::make_unique<app::progress_line>("bench cpu");
  cpu_result r;
  for (std::size_t f = 0; f < wanted.size(); ++f) {
    (*progress)(static_cast<double>(f) / static_cast<double>(wanted.size()));
    wanted[f].measure(c, r);
  }
  progress.reset();
  r.tables.push_back(table_of(r.bars));

  const std::string about = fmt::format("{}\n\nCompiled by {}. Other libraries: {}. {}\n\n{}\n", machine_in_words(),
                                        compiler_in_words(), peers_in_words(), sets.in_words(), rules);
  std::string text = about;
  std::string markdown = fmt::format(
      "# Measured on a CPU\n\nWritten by `meet bench cpu{}{}{} --threads {} --repetitions {} -o DIR`.\n\n{}",
      q.quick ? " --quick" : "", q.data ? " --data FOLDER" : "", q.only ? " --only TEXT" : "", c.threads, q.repetitions,
      about);
  app::json json_tables = app::json::array();
  for (const table &t : r.tables) {
    text += fmt::format("\n{}", as_text(t));
    markdown += fmt::format("\n{}", as_markdown(t));
    json_tables.push_back(as_json(t));
  }
  if (q.folder) {
    outputs.make_folder(*q.folder);
    outputs.write(*q.folder / "cpu.md", [&markdown](const std::filesystem::path &to) { io::write_file(to, markdown); });
    outputs.commit();
    text += fmt::format("\nwrote {}\n", (*q.folder / "cpu.md").string());
  }
  if (!q.json)
    return text;
  const app::json out = {{"machine", machine_in_words()},
                         {"compiler", compiler_in_words()},
                         {"peers", peers_in_words()},
                         {"threads", c.threads},
                         {"repetitions", q.repetitions},
                         {"quick", q.quick},
                         {"meshes", q.data ? "files" : "built-in"},
                         {"tables", std::move(json_tables)}};
  return app::in_one_line(out) + '\n';
}

} // namespace meetc::bench
