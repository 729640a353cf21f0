#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/text/progress.hpp"
#include "meet/bench/harness/machine.hpp"
#include "meet/bench/harness/report.hpp"
#include "meet/bench/peers/peers.hpp"
#include "meet/bench/tables/tables.hpp"
#include "meet/core/threads/threads.hpp"

#include <fmt/format.h>

#include <array>

namespace meetc::bench {

namespace {

struct family {
  const char *name;
  void (*measure)(const cpu_context &, cpu_result &);
};
constexpr std::array families{family{"precision", measure_precision}, family{"candidates", measure_candidates},
                              family{"balls", measure_balls},         family{"bodies", measure_moved_bodies},
                              family{"contacts", measure_contacts},   family{"refit", measure_refit},
                              family{"cancel", measure_cancelling},   family{"families", measure_families}};

constexpr const char *rules =
    "Each figure is from one run in which all works of a table take turns; the median counts. With one thread times "
    "are "
    "those of the process on its cores, with more they are wall-clock times. Every answer is compared with `exact`, "
    "other libraries' too. The libraries were compiled as the notes below each table say.";

std::vector<const catalogue *> kernels_to_measure(const app::kernel_library &all, const std::string &named) {
  if (named != "auto")
    return {&app::kernels_named(all, named)};
  std::vector<const catalogue *> out;
  for (int s = 0; s < instruction_set_count; ++s)
    if (const catalogue *kernels = all.of(static_cast<instruction_set>(s)))
      out.push_back(kernels);
  return out;
}

std::vector<family> families_to_measure(const request &q) {
  std::vector<family> out;
  for (const family &f : families)
    if (!q.only || std::string(f.name).find(*q.only) != std::string::npos)
      out.push_back(f);
  if (out.empty())
    throw app::failure(fmt::format("--only {}: no family has this in its name", io::quote(*q.only)));
  return out;
}

std::string peers_in_words() {
  std::string words;
  for (const peers::library &l : peers::libraries())
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", l.name, l.built_in ? l.version : "not built in");
  return words;
}

} // namespace

table table_of_bars(const std::vector<bar> &bars) {
  const auto limit = [](const bar &b) {
    return of_words(fmt::format("{} {} {}", b.reach == bar::side::at_least ? "≥" : "≤", b.limit, b.unit));
  };
  const auto measured = [](const bar &b) {
    cell c = b.measured ? of_ratio(*b.measured) : missing(b.why_not);
    c.text += b.measured ? " " + b.unit : "";
    return c;
  };
  const auto met = [](const bar &b) { return b.measured ? cell{b.met() ? "yes" : "**no**", b.met()} : missing(); };
  return table_of<bar>("bars", "Speeds to reach",
                       {{"work", "work", of_words, &bar::work},
                        {"figure", "figure", of_words, &bar::figure},
                        {"bar", "bar", limit},
                        {"measured", "measured", measured},
                        {"met", "met", met}},
                       bars);
}

std::string cpu(const app::kernel_library &kernels, const request &q) {
  report_folder folder(q.folder, {"cpu.md"});
  const std::vector<const catalogue *> chosen = kernels_to_measure(kernels, q.instruction_set);
  const cpu_sets sets({*chosen.back(), q.data, q.quick});
  const cpu_context c{chosen, sets, thread_count(q.threads), q.repetitions, q.quick};
  const std::vector<family> wanted = families_to_measure(q);
  cpu_result found;
  {
    app::progress_line progress("bench cpu");
    for (std::size_t f = 0; f < wanted.size(); ++f) {
      progress(static_cast<double>(f) / static_cast<double>(wanted.size()));
      wanted[f].measure(c, found);
    }
  }
  found.tables.push_back(table_of_bars(found.bars));
  const report r{
      "Measured on a CPU",
      in_words("meet bench cpu", q, fmt::format(" --threads {} --repetitions {}", c.threads, q.repetitions)),
      {machine_in_words(),
       fmt::format("Compiled by {}. Other libraries: {}. {}", compiler_in_words(), peers_in_words(), sets.in_words()),
       rules},
      {{"machine", machine_in_words()},
       {"compiler", compiler_in_words()},
       {"peers", peers_in_words()},
       {"threads", c.threads},
       {"repetitions", q.repetitions},
       {"quick", q.quick},
       {"meshes", q.data ? "files" : "built-in"}},
      std::move(found.tables),
      {}};
  return folder.write(r, q.json);
}

} // namespace meetc::bench
