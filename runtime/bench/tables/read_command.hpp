// bench/tables/read_command.hpp: `meet bench read`: how long the readers take.
#ifndef MEETC_BENCH_TABLES_READ_COMMAND_HPP
#define MEETC_BENCH_TABLES_READ_COMMAND_HPP

#include "meetc/support.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meetc::bench {

struct read_request {
  std::optional<std::filesystem::path> mesh; // a mesh; a built-in body serves without it
  int threads = 2, repetitions = 21;
  bool json = false;
};

// The reader of each format beside the least that such a file takes: for text, one thread that passes all numbers to
// std::from_chars; for a binary file, a copy of its bytes into fresh memory. Files lie in a temporary folder, and so in the
// page cache. Medians of interleaved runs; all memory is fresh in each. Throws io::error.
std::string read_times(const catalogue &all, const read_request &q);

} // namespace meetc::bench

#endif
