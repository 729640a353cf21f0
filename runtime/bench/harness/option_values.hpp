// bench/harness/option_values.hpp: how the values of options are read that several measuring commands share.
#ifndef MEETC_BENCH_HARNESS_OPTION_VALUES_HPP
#define MEETC_BENCH_HARNESS_OPTION_VALUES_HPP

#include <string>

namespace meetc::bench {

// The value of --repetitions, from 1 to 1000. Throws app::failure.
int repetitions_named(const std::string &text);

} // namespace meetc::bench

#endif
