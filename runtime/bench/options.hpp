// app/bench/options.hpp: the command line of `meet bench` and its subcommands.
#ifndef MEETC_APP_BENCH_OPTIONS_HPP
#define MEETC_APP_BENCH_OPTIONS_HPP

#include "bench/gpu_command.hpp"
#include "bench/paper_command.hpp"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace meetc::app {

struct bench_arguments {
  paper_request paper;
  gpu_request gpu;
  std::optional<std::string> threads;
  CLI::App *command = nullptr, *paper_command = nullptr, *gpu_command = nullptr;
};

void add_bench(CLI::App &app, bench_arguments &to);

// What the subcommand that was parsed prints.
std::string bench(const catalogue &all, bench_arguments &args);

} // namespace meetc::app

#endif
