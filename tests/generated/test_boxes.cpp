// The boxes of the catalogue are never too small, whatever is rounded or overflows, and hardly too large.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/operands.hpp"

#include <cga/cga_runtime.hpp>
#include <cmath>
#include <gmpxx.h>
#include <limits>
#include <string>

using namespace meetc::generated_test;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

const meetc::kind_info &kind(const std::string &name) {
  const meetc::catalogue &c = cga::catalogue();
  for (int i = 0; i < c.kind_count; ++i)
    if (name == c.kinds[i].name)
      return c.kinds[i];
  throw std::runtime_error("no kind " + name);
}

// lo <= q <= hi, with infinities where they are due.
bool below(float lo, const mpq_class &q) {
  return lo == -inf || (lo != inf && mpq_class(static_cast<double>(lo)) <= q);
}
bool above(float hi, const mpq_class &q) {
  return hi == inf || (hi != -inf && mpq_class(static_cast<double>(hi)) >= q);
}

bool sphere_box_fits(const row &r) {
  float lo[3], hi[3];
  kind("sphere").box(r.data(), lo, hi);
  for (std::size_t k = 0; k < 3; ++k) {
    const mpq_class c(static_cast<double>(r[k])), radius(static_cast<double>(r[3]));
    if (!below(lo[k], c - radius) || !above(hi[k], c + radius))
      return false;
    // At most two steps beyond the rounded sum.
    const float sum = r[k] + r[3], difference = r[k] - r[3];
    if (hi[k] > std::nextafter(std::nextafter(sum, inf), inf) ||
        lo[k] < std::nextafter(std::nextafter(difference, -inf), -inf))
      return false;
  }
  return true;
}

} // namespace

TEST_CASE("boxes: spheres, exactly") {
  random_numbers random(12);
  constexpr float most = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
  const float special[] = {0.0F, -0.0F, tiny, -tiny, 0x1p-126F, -0x1p-126F,
                           1.0F, -1.0F, most, -most, 0x1p127F,  0x1.fffffcp126F};
  bool fits = true;
  for (const float c : special)
    for (const float d : special)
      for (const float r : special)
        fits = fits && sphere_box_fits({c, d, -c, std::abs(r)});
  CHECK(fits);
  int overflown = 0;
  for (int i = 0; i < effort(60000) && fits; ++i) {
    const int k = random.integer(-149, 127);
    row r{random.pattern(), random.unit(), std::ldexp(random.unit(), k), std::abs(random.pattern())};
    if (random.one_in(2))
      r[3] = std::abs(stepped(std::ldexp(random.unit(), k), random.integer(-2, 2))); // of the centre's size
    if (random.one_in(8))
      r[3] = most;
    fits = sphere_box_fits(r);
    float lo[3], hi[3];
    kind("sphere").box(r.data(), lo, hi);
    overflown += hi[0] == inf || lo[0] == -inf;
  }
  CHECK(fits);
  CHECK(overflown > 0);
}

TEST_CASE("boxes: hulls of corners, to the bit") {
  random_numbers random(13);
  for (const auto &[name, corners] :
       {std::pair<std::string, std::size_t>{"point", 1}, {"segment", 2}, {"triangle", 3}}) {
    INFO(name);
    REQUIRE(kind(name).points == static_cast<int>(corners));
    REQUIRE(kind(name).fields == static_cast<int>(3 * corners));
    bool same = true;
    for (int i = 0; i < effort(20000); ++i) {
      row r(3 * corners);
      for (float &f : r)
        f = random.one_in(3) ? static_cast<float>(random.integer(-1, 1)) : random.pattern();
      float lo[3], hi[3];
      kind(name).box(r.data(), lo, hi);
      for (std::size_t k = 0; k < 3; ++k) {
        float least = r[k], largest = r[k];
        for (std::size_t c = 1; c < corners; ++c) {
          least = std::min(least, r[3 * c + k]);
          largest = std::max(largest, r[3 * c + k]);
        }
        same = same && lo[k] == least && hi[k] == largest;
      }
    }
    CHECK(same);
  }
}

TEST_CASE("boxes: a radius below zero is named") {
  const auto fault = [](float r) {
    const float sphere[] = {0, 0, 0, r};
    return kind("sphere").fault(sphere) != nullptr;
  };
  CHECK(fault(-1));
  CHECK(fault(-std::numeric_limits<float>::denorm_min()));
  CHECK(fault(std::numeric_limits<float>::quiet_NaN()));
  CHECK_FALSE(fault(0));
  CHECK_FALSE(fault(-0.0F));
  CHECK_FALSE(fault(1));
}
