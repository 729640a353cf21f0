#include "bench/harness/option_values.hpp"

#include "app/failure.hpp"
#include "io/number.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace meetc::bench {

int repetitions_named(const std::string &text) {
  constexpr int most = 1000;
  std::int64_t n = 0;
  if (!io::parse_integer(text, n) || n < 1 || n > most)
    throw app::failure(fmt::format("--repetitions: {} is not a number from 1 to {}", io::quote(text), most));
  return static_cast<int>(n);
}

} // namespace meetc::bench
