// Predicates with constants of 32 bits and more, and of degree 8, whose values overflow in fp64: no rung is wrong.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/many_rows.hpp"

#include "meet/core/cascade/cascade.hpp"

#include <cmath>
#include <cstring>
#include <string>
#include <unusual/shapes.hpp>
#include <unusual/unusual_runtime.hpp>

using namespace meetc::generated_test;
using meetc::answer;
using meetc::int128;

namespace {

constexpr std::size_t fields = 4; // of a kind with two points in the plane

struct pairs_of_rows {
  row a, b;
  std::vector<meetc::index_pair> pairs;
};

// Pairs of integers up to `most`, multiplied by `scale`. In every second pair products balance up to the constants.
pairs_of_rows integers(int most, float scale) {
  random_numbers random(31);
  pairs_of_rows r;
  const auto any = [&](int limit) {
    return static_cast<float>(static_cast<int>(random.bits() % (2U * static_cast<unsigned>(limit) + 1)) - limit);
  };
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(effort(20000)); ++i) {
    float x[2 * fields];
    for (float &v : x)
      v = any(most) * scale;
    if (i % 2 != 0) // all differences of the products with the constants are small, or zero
      x[0] = x[4] + 5 * scale, x[3] = x[7] + any(2) * scale, x[1] = x[5] + 3 * scale, x[2] = x[6] + any(2) * scale;
    r.a.insert(r.a.end(), x, x + fields), r.b.insert(r.b.end(), x + fields, x + 2 * fields);
    r.pairs.push_back({i, i});
  }
  return r;
}

template <class Decide> std::vector<answer> answers(const Decide &decide, const pairs_of_rows &r) {
  std::vector<answer> out(r.pairs.size());
  decide(meetc::row_array(r.a.data()), meetc::row_array(r.b.data()), r.pairs.data(), out.size(), out.data());
  return out;
}

} // namespace

TEST_CASE("constants of 32 bits and more: the exact rung is right") {
  const pairs_of_rows r = integers(1000, 1);
  const std::vector<answer> found =
      answers(named(unusual::catalogue(), "weighted").decide[static_cast<int>(meetc::rung::exact)], r);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto difference = [&](std::size_t k) {
      return static_cast<int128>(r.a[fields * i + k]) - static_cast<int128>(r.b[fields * i + k]);
    };
    const int128 value = 3000000001 * difference(0) * difference(3) - 5000000029 * difference(1) * difference(2);
    REQUIRE(found[i] == meetc::to_answer(value >= 0));
  }
}

TEST_CASE("large constants and degrees: no bounded rung is wrong, at any scale") {
  const meetc::catalogue &all = unusual::catalogue();
  int unsure_in_fp64 = 0, overflowing = 0;
  for (const int most : {3, 1000, 1 << 20})
    for (const float scale : {0x1p-120F, 0x1p-20F, 1.0F, 0x1p20F, 0x1p107F}) {
      const pairs_of_rows r = integers(most, scale);
      for (int i = 0; i < all.predicate_count; ++i) {
        const meetc::predicate_info &p = all.predicates[i];
        INFO(p.name << ", integers up to " << most << " times " << scale);
        const std::vector<answer> truth = answers(p.decide[static_cast<int>(meetc::rung::exact)], r);
        const meetc::cascade certified(p, meetc::rung::certified);
        CHECK(answers([&](auto... to) { certified.decide(to...); }, r) == truth);
        for (const meetc::decide_function certify : p.certify) {
          const std::vector<answer> found = answers(certify, r);
          int wrong = 0, unsure = 0;
          for (std::size_t k = 0; k < found.size(); ++k)
            (found[k] == answer::unsure ? unsure : wrong) += found[k] != truth[k];
          CHECK(wrong == 0);
          (scale > 1 ? overflowing : unsure_in_fp64) += certify == p.certify[1] ? unsure : 0;
        }
      }
    }
  CHECK(unsure_in_fp64 > 0);
  CHECK(overflowing > 0);
}

TEST_CASE("a kind's rule is the same for the shape, which a device asks, as for the host") {
  const meetc::catalogue &all = unusual::catalogue();
  const auto fault = [&all](const char *kind, const float *r) -> const char * {
    for (int i = 0; i < all.kind_count; ++i)
      if (std::strcmp(all.kinds[i].name, kind) == 0)
        return all.kinds[i].fault ? all.kinds[i].fault(r) : nullptr;
    return "no such kind";
  };
  const float same[fields] = {1, 0, 1, -0.0F}, other[fields] = {1, 0, 1, 2};
  CHECK(fault("pair", same) == std::string("p != q"));
  CHECK_FALSE(unusual::pair_shape::obeys(same));
  CHECK(fault("pair", other) == nullptr);
  CHECK(unusual::pair_shape::obeys(other));
  CHECK(fault("equal", same) == nullptr);
  CHECK(unusual::equal_shape::obeys(same));
}
