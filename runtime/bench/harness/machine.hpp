// bench/harness/machine.hpp: what a table of CPU times must say of the machine and of the program.
#ifndef MEETC_BENCH_HARNESS_MACHINE_HPP
#define MEETC_BENCH_HARNESS_MACHINE_HPP

#include <string>

namespace meetc::bench {

std::string machine_in_words();  // the processor's model, its cores, and the instruction sets that run on it
std::string compiler_in_words(); // compiler and flags of the baseline

} // namespace meetc::bench

#endif
