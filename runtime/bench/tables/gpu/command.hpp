// bench/tables/gpu/command.hpp: `meet bench gpu`: kernels and queries on the CUDA device, compared with the classic tests.
#ifndef MEETC_BENCH_TABLES_GPU_COMMAND_HPP
#define MEETC_BENCH_TABLES_GPU_COMMAND_HPP

#include "meetc/support.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meetc::bench {

struct gpu_request {
  std::optional<std::filesystem::path> folder; // gpu.md and gpu.json are written there
  std::optional<std::filesystem::path> data;   // has meshes; without it procedural bodies are used
  std::optional<std::string> only;             // part of the names of the scenes to measure
  bool json = false, quick = false;
};

// Returns the text for standard output. Throws io::error, or failure with no_device.
std::string gpu(const catalogue &all, const gpu_request &request);

} // namespace meetc::bench

#endif
