// Comparisons of numbers by their bits.
#include "tests/catch.hpp"

#include <meetc/environment/valid.hpp>

#include <cmath>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace {

template <class T> void check_not_above(const T *ascending, int n) {
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      INFO(i << " and " << k);
      CHECK(meetc::not_above(ascending[i], ascending[k]) == (i <= k));
    }
}

} // namespace

TEST_CASE("valid: not above is the order of the numbers, and zeros are equal") {
  const float floats[] = {-HUGE_VALF, -2, -0x1p-126F, -0x1p-149F, 0, 0x1p-149F, 0x1p-148F, 1, 0x1.fffffep127F};
  const double doubles[] = {-1e300, -1, -0x1p-1074, 0, 0x1p-1074, 0x1p-1073, 1e300};
  check_not_above(floats, 9);
  check_not_above(doubles, 7);
  CHECK(meetc::not_above(0.0F, -0.0F));
  CHECK(meetc::not_above(-0.0F, 0.0F));
#if defined(__SSE2__)
  const unsigned found = _mm_getcsr();
  _mm_setcsr(found | 0x8040U); // under which subnormals compare as zero
  const bool above = !meetc::not_above(0x1p-149F, 0.0F), below = !meetc::not_above(0.0F, -0x1p-149F);
  _mm_setcsr(found);
  CHECK(above);
  CHECK(below);
#endif
}
