// bench/tables/cpu/command.hpp: `meet bench cpu`: our kernels and queries on the CPU beside other libraries and the classic
// tests.
#ifndef MEETC_BENCH_TABLES_CPU_COMMAND_HPP
#define MEETC_BENCH_TABLES_CPU_COMMAND_HPP

#include "app/choose.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meetc::bench {

struct cpu_request {
  std::optional<std::filesystem::path> folder; // cpu.md is written there
  std::optional<std::filesystem::path> data;   // has meshes; without it procedural bodies are used
  std::optional<std::string> only;             // part of the names of the families to measure
  std::string instruction_set = "auto";        // the only one that is measured; auto: all that run here
  int threads = 1, repetitions = 21;
  bool json = false, quick = false;
};

// Returns the text for standard output. Throws io::error.
std::string cpu(const app::kernel_library &kernels, const cpu_request &request);

} // namespace meetc::bench

#endif
