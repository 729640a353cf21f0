#include "gen/support/output.hpp"

#include <cerrno>
#include <cstdio>
#include <fmt/format.h>
#include <system_error>

namespace meetc {
namespace {

int first_fault = 0; // as in errno

} // namespace

void say(std::string_view text) {
  if (first_fault == 0 && std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
    first_fault = errno;
}

void warn(const spec_error &w) {
  fmt::print(stderr, "{}", w.render("warning"));
}

void finish_output() {
  if (first_fault == 0 && std::fflush(stdout) != 0)
    first_fault = errno;
  if (first_fault != 0 && first_fault != EPIPE)
    throw spec_error(
        {}, fmt::format("standard output cannot be written: {}", std::generic_category().message(first_fault)));
}

} // namespace meetc
