// bench/tables/paper/command.hpp: `meet bench paper`: reproduces the paper's tables and its figures 1 to 6.
#ifndef MEETC_BENCH_TABLES_PAPER_COMMAND_HPP
#define MEETC_BENCH_TABLES_PAPER_COMMAND_HPP

#include "meetc/support.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meetc::bench {

struct paper_request {
  std::optional<std::filesystem::path> folder; // paper.md and figure_1.png to figure_6.png are written there
  std::optional<std::filesystem::path> data;   // has meshes; without it procedural bodies are used
  std::string device = "auto";
  bool json = false, quick = false;
  int threads = 0; // for searching pairs; what is timed on the CPU runs on one core
};

// Returns the text for standard output. Throws io::error.
std::string paper(const catalogue &all, const paper_request &request);

} // namespace meetc::bench

#endif
