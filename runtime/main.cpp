// The program `meet`: which commands it has, and on which kernels they work.
#include "meet/app/commands/collide_command.hpp"
#include "meet/app/commands/demo_command.hpp"
#include "meet/app/commands/inspect_command.hpp"
#include "meet/app/commands/program.hpp"
#include "meet/bench/tables/command/command.hpp"

#include <cga/cga_runtime.hpp>
#include <neighbours/neighbours_runtime.hpp>

namespace {

int run(int argc, char **argv) {
  const meetc::catalogue &all = cga::catalogue();
  return meetc::app::run(argc, argv,
                         {[](CLI::App &program) {
                            return meetc::app::add_collide(program, {cga::catalogue, cga::catalogue_for},
                                                           {neighbours::catalogue, neighbours::catalogue_for});
                          },
                          [&all](CLI::App &program) { return meetc::app::add_inspect(program, all); },
                          [&all](CLI::App &program) { return meetc::app::add_demo(program, all); },
                          [&all](CLI::App &program) {
                            return meetc::bench::add_bench(program, all, {cga::catalogue, cga::catalogue_for});
                          },
                          [](CLI::App &program) {
                            return meetc::bench::add_trade(program, {cga::catalogue, cga::catalogue_for});
                          }});
}

} // namespace

// A library that was linked with -ffast-math, and that is loaded into the program, has changed its control word.
int main(int argc, char **argv) {
  return meetc::under_standard_word([&] { return run(argc, argv); });
}
