// bench/harness/machine.hpp: the machine and the program, for tables of CPU times.
#ifndef MEETC_BENCH_HARNESS_MACHINE_HPP
#define MEETC_BENCH_HARNESS_MACHINE_HPP

#include <string>

namespace meetc::bench {

std::string machine_in_words();  // the processor's model, its cores, and the instruction sets that run on it
std::string compiler_in_words(); // compiler and flags of the baseline

} // namespace meetc::bench

#endif
