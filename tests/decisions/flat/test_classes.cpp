// The lists of classes are complete, and as long as is known.
#include "tests/catch.hpp"
#include "tests/decisions/flat/classes.hpp"
#include "tests/decisions/flat/necessary.hpp"

#include <algorithm>
#include <set>

using namespace meetc::decisions_test;

namespace {

// The number of classes without a coincident pair, up to labels and reflection; `general`: also without a
// vanishing determinant.
struct types {
  int all = 0, general = 0;
};
types types_of(int n, int d) {
  types out;
  std::set<key> seen;
  for (const auto &[k, x] : classes_of(n, d)) {
    points sorted = x;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end() || seen.contains(k))
      continue;
    witnesses orbit;
    add_relabelled(orbit, x, d);
    bool general = true;
    for (std::size_t i = 0; i < subsets(n, d + 1).size(); ++i)
      general = general && sign_at(k, i) != 0;
    for (const auto &[other, y] : orbit) {
      seen.insert(other);
      seen.insert(negative(other, n, d));
    }
    ++out.all;
    out.general += general;
  }
  return out;
}

std::size_t without_coincidences(int n, int d) {
  return static_cast<std::size_t>(std::ranges::count_if(classes_of(n, d), [](const auto &c) {
    points sorted = c.second;
    std::ranges::sort(sorted);
    return std::ranges::adjacent_find(sorted) == sorted.end();
  }));
}

} // namespace

TEST_CASE("classes: their number is right, and each has points with its signs") {
  struct row {
    int n, d;
    std::size_t all, distinct; // `distinct`: no two points coincide
  };
  for (const row &r : {row{4, 0, 1, 0}, row{4, 1, 74, 24}, row{4, 2, 50, 38}, row{4, 3, 2, 2},           //
                       row{5, 0, 1, 0}, row{5, 1, 540, 120}, row{5, 2, 1684, 1254}, row{5, 3, 180, 160}, //
                       row{6, 0, 1, 0}, row{6, 1, 4682, 720}, row{6, 2, 121924, 100464}, row{6, 3, 34324, 31794}}) {
    CAPTURE(r.n, r.d);
    const witnesses &all = classes_of(r.n, r.d);
    CHECK(all.size() == r.all);
    CHECK(without_coincidences(r.n, r.d) == r.distinct);
    CHECK(std::ranges::all_of(all, [&](const auto &c) { return chirotope_of(c.second, r.d) == c.first; }));
  }
}

// 180 = 3^5 - 2 * 2^5 + 1 sign vectors have signs of both kinds, and 50 = 3^4 - 2 * 2^4 + 1.
TEST_CASE("classes: they are all sign vectors that contradict no identity") {
  for (int n = 4; n <= 6; ++n)
    for (int d = 1; d <= 3; ++d) {
      CAPTURE(n, d);
      const std::vector<key> possible = possible_keys(n, d);
      CHECK(possible.size() == classes_of(n, d).size());
      CHECK(std::ranges::all_of(possible, [&](key k) { return classes_of(n, d).contains(k); }));
    }
}

// In general position in the plane these are the known order types (OEIS A006247).
TEST_CASE("classes: up to labels they are the known order types") {
  CHECK(types_of(3, 2).general == 1);
  CHECK(types_of(4, 2).general == 2);
  CHECK(types_of(5, 2).general == 3);
  CHECK(types_of(6, 2).general == 16);
  CHECK(types_of(4, 2).all == 3);
  CHECK(types_of(5, 2).all == 11);
  CHECK(types_of(6, 2).all == 93);
  CHECK(types_of(5, 3).general == 2);
  CHECK(types_of(5, 3).all == 5);
  CHECK(types_of(6, 3).all == 55);
}
