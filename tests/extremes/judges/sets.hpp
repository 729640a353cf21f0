// The families through the library: whole sets, prepared and collided under any control word, on several threads. The truth of
// each pair of elements is the predicate's decision on integer signs.
#ifndef MEETC_TESTS_EXTREMES_SETS_HPP
#define MEETC_TESTS_EXTREMES_SETS_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace meetc::extremes_test {

struct set_counts {
  std::uint64_t cases = 0, hits = 0;    // pairs of elements, and those that touch
  std::uint64_t queries = 0, wrong = 0; // each query answers for all pairs of two sets
  std::string first_wrong;

  set_counts &operator+=(const set_counts &o);
};

struct set_plan {
  std::uint64_t cases, seed;
  unsigned threads = 1;
  std::string_view family = {}; // empty: all
};

// Rounds until so many cases are judged. A round makes two sets from one family, and asks for their pairs: by pairs(), and of
// prepared sets, whole and for each other, by their hierarchy and all pairs. Every fourth round one prepared set, which holds
// its elements at several magnitudes, meets partners of each from several threads at once. `report` is called now and then.
set_counts run_sets(const set_plan &what, const std::function<void(const set_counts &)> &report = {});

} // namespace meetc::extremes_test

#endif
