// Families about the size of numbers: by axis, from the ends of float32, near its overflow.
#include "tests/extremes/families/families.hpp"

#include <cmath>
#include <limits>

namespace meetc::extremes_test {
namespace {

using generated_test::stepped;
constexpr float most = std::numeric_limits<float>::max();

float scaled_number(float f, int k) {
  return std::clamp(std::ldexp(f, k), -most, most);
}
float either_sign(float f, random_numbers &random) {
  return random.one_in(2) ? f : -f;
}

template <class Next> row draw(shape kind, Next &&next) {
  row r;
  for (std::size_t i = 0; i < 3 * corners(kind); ++i)
    r.push_back(next());
  if (padded(kind))
    r.push_back(std::abs(next()));
  return r;
}

// The least and the largest numbers with their neighbours, and ordinary ones between them.
float of_palette(random_numbers &random) {
  switch (random.integer(0, 7)) {
  case 0:
    return 0;
  case 1:
    return 0x1p-149F;
  case 2: // other subnormals: one bit, or all at random
    return 0x1p-149F * static_cast<float>(random.one_in(2) ? 1 << random.integer(1, 22) : random.integer(1, 0x7fffff));
  case 3:
    return stepped(0x1p-126F, random.integer(-1, 1));
  case 4:
  case 5:
    return static_cast<float>(random.integer(1, 9));
  case 6:
    return std::ldexp(1.0F, random.integer(-149, 127));
  default:
    return stepped(most, -random.integer(0, 2));
  }
}

} // namespace

pair_of_rows axis_magnitudes(shape a, shape b, random_numbers &random) {
  static constexpr int reaches[] = {3, 12, 40, 127};
  pair_of_rows p = random.one_in(2) ? placed(a, b, random) : any_at_home(a, b, random);
  const int reach = reaches[random.integer(0, 3)];
  const int exponent[3] = {random.integer(-reach, reach), random.integer(-reach, reach), random.integer(-reach, reach)};
  for (auto [kind, r] : {std::pair(a, &p.a), std::pair(b, &p.b)}) {
    for (std::size_t i = 0; i < 3 * corners(kind); ++i)
      (*r)[i] = scaled_number((*r)[i], exponent[i % 3]);
    if (padded(kind))
      r->back() = scaled_number(r->back(), exponent[random.integer(0, 2)]);
  }
  if (padded(a) && random.one_in(2)) // a sphere does not stay one: it touches anew
    graze(a, b, p, random);
  return p;
}

// Few different ones make coincidences; without the largest, the others fit into boxes.
pair_of_rows palette(shape a, shape b, random_numbers &random) {
  float few[6];
  const int count = random.integer(2, 6);
  const bool without_largest = random.one_in(2);
  for (float &f : few)
    do
      f = of_palette(random);
    while (without_largest && f > 0x1p20F);
  const bool any = random.one_in(4);
  const auto next = [&] { return either_sign(any ? of_palette(random) : few[random.integer(0, count - 1)], random); };
  pair_of_rows p;
  p.a = draw(a, next);
  p.b = draw(b, next);
  return p;
}

// Sums and differences of these overflow in float32, and every product does.
pair_of_rows near_overflow(shape a, shape b, random_numbers &random) {
  if (random.one_in(2)) { // another family's, as large as can be
    pair_of_rows p = any_at_home(a, b, random);
    float largest = 0;
    for (const row *r : {&p.a, &p.b})
      for (const float f : *r)
        largest = std::max(largest, std::abs(f));
    if (largest > 0) {
      const int k = 127 - std::ilogb(largest) - random.integer(0, 1);
      // Reflected at random, so that signs differ; a reflection changes no answer of a decision.
      bool mirrored[3];
      for (bool &m : mirrored)
        m = random.one_in(2);
      for (row *r : {&p.a, &p.b})
        for (std::size_t i = 0; i < r->size(); ++i)
          (*r)[i] = scaled_number(i < 9 && mirrored[i % 3] && !(padded(a) && i == 3) ? -(*r)[i] : (*r)[i], k);
    }
    return p;
  }
  // A coarse grid that ends with the largest number, and numbers a step away from it.
  const int cells = random.one_in(2) ? 8 : 4;
  const auto next = [&] {
    const int i = random.integer(-cells, cells);
    const float f = std::abs(i) == cells ? std::copysign(most, static_cast<float>(i))
                                         : std::ldexp(static_cast<float>(i), cells == 8 ? 125 : 126);
    return random.one_in(6) ? stepped(f, random.integer(-1, 1)) : f;
  };
  pair_of_rows p;
  p.a = draw(a, next);
  p.b = draw(b, next);
  return p;
}

} // namespace meetc::extremes_test
