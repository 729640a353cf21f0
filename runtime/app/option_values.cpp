#include "app/option_values.hpp"

#include "app/failure.hpp"
#include "core/threads.hpp"
#include "io/number.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

namespace meetc::app {

int threads_named(const std::string &text) {
  std::int64_t n = 0;
  if (!io::parse_integer(text, n) || n < 0 || n > max_threads)
    throw failure(fmt::format("--threads: {} is not a number from 0 to {}", io::quote(text), max_threads));
  return static_cast<int>(n);
}

} // namespace meetc::app
