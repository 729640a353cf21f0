// The simulated precision itself: with float32's format it gives float32's results.
#include "tests/catch.hpp"
#include "tests/gen/bound/search.hpp"

using namespace meetc::bounds_test;

namespace {

float any_float(random_numbers &random, int exponent_span) {
  const auto m = static_cast<double>(random.integer(-0xffffff, 0xffffff));
  return static_cast<float>(std::ldexp(m, static_cast<int>(random.integer(-exponent_span, exponent_span))));
}

} // namespace

TEST_CASE("tiny: float32's format gives float32's results, subnormals and ties included") {
  tiny::format = {24, -149};
  random_numbers random(1);
  bool sums = true, products = true, fused = true;
  for (int i = 0; i < 400000; ++i) {
    // Near 1, near the least normal number, and anywhere that does not overflow.
    const int span = i % 3 == 0 ? 3 : i % 3 == 1 ? 26 : 36;
    const float low = i % 3 == 2 ? 0x1p-82F : 1;
    const float a = any_float(random, span) * low, b = any_float(random, span) * low;
    float c = any_float(random, span) * low;
    if (random.one_in(2)) // cancellation, to the last place
      c = -(a * b);
    const tiny x = tiny::of(static_cast<double>(a)), y = tiny::of(static_cast<double>(b)),
               z = tiny::of(static_cast<double>(c));
    sums = sums && static_cast<float>((x + y).value()) == a + b && static_cast<float>((x - y).value()) == a - b;
    products = products && static_cast<float>((x * y).value()) == a * b;
    fused = fused && static_cast<float>(meetc::fma(x, y, z).value()) == __builtin_fmaf(a, b, c);
  }
  CHECK(sums);
  CHECK(products);
  CHECK(fused);
}

TEST_CASE("tiny: four bits by hand") {
  tiny::format = {4, -2};
  const auto of = [](double d) { return tiny::of(d); };
  CHECK((of(15) + of(1)).value() == 16);
  CHECK((of(15) + of(2)).value() == 16);      // 17: a tie goes to the even one
  CHECK((of(15) + of(4)).value() == 20);      // 19: a tie, the even one is above
  CHECK((of(9) * of(9)).value() == 80);       // 81
  CHECK((of(0.25) * of(0.5)).value() == 0);   // an eighth is half of the least number: even
  CHECK((of(0.75) * of(0.5)).value() == 0.5); // three eighths: a tie again
  CHECK(meetc::fma(of(9), of(9), of(-80)).value() == 1);
  CHECK((of(9) * of(9)).unrounded().high == 81);
  CHECK((-(of(9) * of(9))).unrounded().high == -81);
}
