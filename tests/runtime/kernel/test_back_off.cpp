// An attempt that fails is left out for longer and longer, up to a limit, until one goes well.
#include "tests/catch.hpp"

#include <meetc/simd/back_off.hpp>

namespace {

// How often the attempt is left out before it is made.
int left_out(meetc::back_off &b) {
  int n = 0;
  while (!b.tries())
    ++n;
  return n;
}

} // namespace

TEST_CASE("an attempt is left out more often after each failure, and never after a success") {
  meetc::back_off b;
  CHECK(left_out(b) == 0);
  for (const int most : {1, 3, 7, 15, 15}) {
    b.went(false);
    CHECK(left_out(b) == most);
  }
  b.went(true);
  CHECK(left_out(b) == 0);
  b.went(true);
  CHECK(left_out(b) == 0);
  b.went(false);
  CHECK(left_out(b) == 1);
}
