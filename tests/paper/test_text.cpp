// The paper's numbers, compared with each other.
#include "tests/catch.hpp"

#include <cmath>

TEST_CASE("text: the one table of times shows a factor of 42, not three orders of magnitude") {
  CHECK(std::round(30034.4 / 715.872) == 42);
}

TEST_CASE("text: Armadillo hits grow as the root of its triangles within 3 % except in the row of 1000K") {
  struct row {
    double thousands, bunny, armadillo;
  };
  constexpr row rows[] = {{5, 187, 491},    {20, 185, 996},    {100, 194, 2215},
                          {345, 195, 3968}, {1000, 107, 5498}, {5000, 191, 15063}};
  double sum = 0, bunny = 0;
  for (const row &r : rows)
    if (r.thousands != 1000) {
      sum += r.armadillo / std::sqrt(r.thousands) / 5;
      bunny += r.bunny / 5;
    }
  for (const row &r : rows) {
    const double ratio = r.armadillo / std::sqrt(r.thousands) / sum;
    const bool out_of_line = r.thousands == 1000;
    CHECK((std::abs(ratio - 1) > 0.03) == out_of_line);
    CHECK((std::abs(r.bunny / bunny - 1) > 0.03) == out_of_line);
  }
}
