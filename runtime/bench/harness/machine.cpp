#include "meet/bench/harness/machine.hpp"

#include "meetc/environment/instruction_set.hpp"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace meetc::bench {

namespace {

// From Linux's list of processors; elsewhere nothing is known.
std::string model_of_processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "a processor of unknown model";
}

} // namespace

std::string machine_in_words() {
  std::string sets;
  for (int s = 0; s < instruction_set_count; ++s)
    if (runs_here(static_cast<instruction_set>(s)))
      sets += fmt::format("{}{}", sets.empty() ? "" : ", ", name_of(static_cast<instruction_set>(s)));
  return fmt::format("{}, {} cores. Instruction sets: {}.", model_of_processor(), std::thread::hardware_concurrency(),
                     sets);
}

std::string compiler_in_words() {
#if defined(__clang__)
  return fmt::format("clang {} with {}", __clang_version__, MEETC_BENCH_FLAGS);
#else
  return fmt::format("gcc {} with {}", __VERSION__, MEETC_BENCH_FLAGS);
#endif
}

} // namespace meetc::bench
