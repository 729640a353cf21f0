// Control words as plain numbers, so that bits are tested that this machine or an emulator does not have.
#include "tests/catch.hpp"

#include <cga/cga.hpp>

#include <algorithm>
#include <limits>

TEST_CASE("words: the faults of an MXCSR are seen, bit by bit") {
  using meetc::masks_mxcsr;
  using meetc::standard_mxcsr;
  CHECK(standard_mxcsr(0x1f80));
  for (unsigned bit = 0; bit < 16; ++bit) {
    INFO("bit " << bit);
    const unsigned changed = 0x1f80U ^ 1U << bit;
    CHECK(standard_mxcsr(changed) == (bit < 6)); // the record of past exceptions changes nothing
    CHECK(masks_mxcsr(changed) == (bit < 7 || bit > 12));
  }
  CHECK_FALSE(standard_mxcsr(0x7f80));
}

TEST_CASE("words: the faults of an FPCR are seen, bit by bit") {
  using meetc::masks_fpcr;
  using meetc::standard_fpcr;
  CHECK(standard_fpcr(0));
  const auto among = [](unsigned bit, std::initializer_list<unsigned> bits) {
    return std::find(bits.begin(), bits.end(), bit) != bits.end();
  };
  for (unsigned bit = 0; bit < 32; ++bit) {
    INFO("bit " << bit);
    const std::uint64_t word = std::uint64_t{1} << bit;
    const bool trap = among(bit, {8, 9, 10, 11, 12, 15});
    // FIZ, AH, RMode, FZ
    CHECK(standard_fpcr(word) == !(trap || among(bit, {0, 1, 22, 23, 24})));
    CHECK(masks_fpcr(word) == !trap);
  }
  CHECK_FALSE(standard_fpcr(0xc00000));
}

TEST_CASE("words: valid() is for finite numbers and radii that are not negative") {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN(),
                  largest = std::numeric_limits<float>::max();
  using sphere = cga::sphere<float>;
  for (const float r : {0.0F, -0.0F, 0x1p-149F, 1.0F, largest}) {
    CHECK(cga::valid(sphere{{0, -largest, 0x1p-149F}, r}));
    if (r != 0) {
      CHECK_FALSE(cga::valid(sphere{{0, 0, 0}, -r}));
    }
  }
  for (const float bad : {inf, -inf, nan, -nan}) {
    CHECK_FALSE(cga::valid(sphere{{0, 0, 0}, bad}));
    CHECK_FALSE(cga::valid(sphere{{0, bad, 0}, 1}));
    CHECK_FALSE(cga::valid(cga::triangle<float>{{0, 0, 0}, {0, 0, bad}, {0, 0, 0}}));
    CHECK_FALSE(cga::valid(cga::segment<float>{{0, 0, 0}, {bad, 0, 0}}));
  }
  CHECK(cga::valid(cga::triangle<float>{{0, 0, 0}, {0, 0, largest}, {0, -0.0F, 0}}));
  CHECK(cga::valid(cga::sphere<double>{{0, 0, 0}, 0x1p-1074}));
  CHECK_FALSE(cga::valid(cga::sphere<double>{{0, 0, 0}, -0x1p-1074}));
  CHECK_FALSE(cga::valid(cga::sphere<double>{{0, 0, std::numeric_limits<double>::infinity()}, 1}));
}

#if defined(__SSE2__)
TEST_CASE("words: a negative subnormal radius is not valid, whatever the control word") {
  const cga::sphere<float> s{{0, 0, 0}, -0x1p-149F};
  __builtin_ia32_ldmxcsr(0x9fc0);
  const bool valid = cga::valid(s);
  __builtin_ia32_ldmxcsr(0x1f80);
  CHECK_FALSE(valid);
}
#endif
