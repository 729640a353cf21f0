// bench/tables/trade/command.hpp: `meet trade`: what each rung costs, how often it is wrong, and how far.
#ifndef MEETC_BENCH_TABLES_TRADE_COMMAND_HPP
#define MEETC_BENCH_TABLES_TRADE_COMMAND_HPP

#include "app/choose.hpp"
#include "app/command.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meetc::bench {

struct trade_request {
  std::optional<std::filesystem::path> a, b; // both or none
  std::optional<std::filesystem::path> folder;
  std::string instruction_set = "auto", device = "auto";
  int threads = 1, repetitions = 21;
  bool quick = false, json = false;
};

// Writes trade.md, trade.csv, trade.png and a map for each predicate into the folder, if one is given, and returns the
// text for standard output. Throws app::failure and io::error.
std::string trade(const app::kernel_library &kernels, const trade_request &q);

// The command and its options.
app::command add_trade(CLI::App &program, const app::kernel_library &kernels);

} // namespace meetc::bench

#endif
