// bench/harness/list_difference.hpp: how a list of pairs differs from the exact one.
#ifndef MEETC_BENCH_HARNESS_LIST_DIFFERENCE_HPP
#define MEETC_BENCH_HARNESS_LIST_DIFFERENCE_HPP

#include "meetc/table.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace meetc::bench {

struct list_difference {
  std::uint64_t extra = 0, missed = 0; // pairs that are only in the list, and only in the exact one
};

// truth is sorted by a, then b, and holds no pair twice. A pair that the list holds twice counts as an extra one.
inline list_difference difference_of(std::vector<index_pair> found, const std::vector<index_pair> &truth) {
  const auto before = [](const index_pair &x, const index_pair &y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
  std::sort(found.begin(), found.end(), before);
  list_difference d;
  auto f = found.begin();
  for (auto t = truth.begin(); t != truth.end() || f != found.end();) {
    if (t == truth.end() || (f != found.end() && before(*f, *t)))
      ++d.extra, ++f;
    else if (f == found.end() || before(*t, *f))
      ++d.missed, ++t;
    else
      ++f, ++t;
  }
  return d;
}

} // namespace meetc::bench

#endif
