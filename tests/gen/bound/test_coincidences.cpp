// Equal points that make a sign zero: those that are claimed do, and none is missing from the claims.
#include "tests/catch.hpp"
#include "tests/gen/bound/search.hpp"

#include <map>

using namespace meetc::bounds_test;

namespace {

using point = std::vector<std::size_t>; // its inputs by axis

// The points among the stored numbers of both operands.
std::vector<point> points_of(const stage_case &c) {
  const meetc::lower::predicate &p = c.kernel->decision;
  std::map<std::pair<int, int>, point> by_group;
  for (int v = 0; v < p.numbers->size(); ++v)
    if (const auto &s = p.local->stored(v); s.position)
      by_group[{s.operand, s.group}].push_back(static_cast<std::size_t>(v));
  std::vector<point> out;
  for (const auto &[at, inputs] : by_group)
    out.push_back(inputs);
  return out;
}

sample random_integers(const stage_case &c, random_numbers &random) {
  sample s;
  for (int i = 0; i < c.inputs(); ++i)
    s.numbers.push_back(random.integer(-4000, 4000));
  return s;
}

std::vector<bool> zeros_of(const stage_case &c, const sample &s) {
  std::vector<int128> v(static_cast<std::size_t>(c.signs)), m(v);
  c.in_integers(s, 0, v.data(), m.data());
  std::vector<bool> out;
  for (const int128 x : v)
    out.push_back(x == 0);
  return out;
}

unsigned coincident(const stage_case &c, const sample &s) {
  std::vector<float> row;
  for (const std::int64_t n : s.numbers)
    row.push_back(static_cast<float>(n));
  return c.coincident(row.data(), row.data() + c.inputs_a);
}

} // namespace

TEST_CASE("coincidences: two equal points make exactly the claimed signs zero") {
  tiny::format = {53, -900};
  int claimed = 0, pairs = 0;
  for (const stage_case &c : all_stages()) {
    const std::vector<point> points = points_of(c);
    random_numbers random(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size(); ++j, ++pairs) {
        INFO(c.name << ", points " << i << " and " << j);
        const auto signs = static_cast<std::size_t>(c.signs);
        std::vector<bool> always(signs, true), said(signs);
        for (int n = 0; n < 200; ++n) {
          sample s = random_integers(c, random);
          for (std::size_t axis = 0; axis < points[i].size(); ++axis)
            s.numbers[points[j][axis]] = s.numbers[points[i][axis]];
          const unsigned bits = coincident(c, s);
          const std::vector<bool> zero = zeros_of(c, s);
          for (std::size_t k = 0; k < signs; ++k) {
            said[k] = (c.zero_if(static_cast<int>(k)) & bits) != 0;
            always[k] = always[k] && zero[k];
          }
        }
        CHECK(always == said);
        claimed += static_cast<int>(std::count(said.begin(), said.end(), true));
      }
  }
  CHECK(pairs > 80);
  CHECK(claimed > 200);
}

TEST_CASE("coincidences: points that differ in one coordinate do not count, zeros of either sign do") {
  for (const stage_case &c : all_stages()) {
    INFO(c.name);
    const std::vector<point> points = points_of(c);
    random_numbers random(9);
    unsigned seen = 0;
    for (int n = 0; n < 400; ++n) {
      sample s;
      for (int i = 0; i < c.inputs(); ++i)
        s.numbers.push_back(1 + i + 100 * n); // all different
      CHECK(coincident(c, s) == 0);
      const auto i = static_cast<std::size_t>(random.integer(0, static_cast<int>(points.size()) - 1)),
                 j = static_cast<std::size_t>(random.integer(0, static_cast<int>(points.size()) - 1));
      if (i == j)
        continue;
      for (std::size_t axis = 0; axis + 1 < points[i].size(); ++axis)
        s.numbers[points[j][axis]] = s.numbers[points[i][axis]];
      CHECK(coincident(c, s) == 0);
      s.numbers[points[j].back()] = s.numbers[points[i].back()];
      seen |= coincident(c, s);
    }
    // Every claimed bit belongs to some pair.
    for (int k = 0; k < c.signs; ++k)
      CHECK((c.zero_if(k) & ~seen) == 0);
    std::vector<float> positive(static_cast<std::size_t>(c.inputs()), 0.0F), mixed = positive;
    for (std::size_t i = 0; i < mixed.size(); i += 2)
      mixed[i] = -0.0F;
    CHECK(c.coincident(mixed.data(), mixed.data() + c.inputs_a) ==
          c.coincident(positive.data(), positive.data() + c.inputs_a));
  }
}
