// bench/tables/command/command.hpp: `meet bench` and its subcommands, and `meet trade`.
#ifndef MEETC_BENCH_TABLES_COMMAND_COMMAND_HPP
#define MEETC_BENCH_TABLES_COMMAND_COMMAND_HPP

#include "meet/app/commands/command.hpp"
#include "meet/app/query/choose.hpp"
#include "meetc/support.hpp"

namespace meetc::bench {

// The commands and their options. The catalogue must outlive them.
app::command add_bench(CLI::App &program, const catalogue &all, const app::kernel_library &kernels);
app::command add_trade(CLI::App &program, const app::kernel_library &kernels);

} // namespace meetc::bench

#endif
