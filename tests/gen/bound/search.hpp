// Adversarial inputs: numbers of p bits in hostile families, and a climb that keeps any change of one number by which a
// score does not fall.
#ifndef MEETC_TESTS_BOUNDS_SEARCH_HPP
#define MEETC_TESTS_BOUNDS_SEARCH_HPP

#include "tests/gen/bound/stages.hpp"

#include <cstdlib>
#include <limits>
#include <random>

namespace meetc::bounds_test {

class random_numbers {
public:
  explicit random_numbers(std::uint64_t seed) : engine_(seed) {}
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(int n) { return integer(1, n) == 1; }

private:
  std::mt19937_64 engine_;
};

// Numbers m 2^e with |m| < 2^precision and |number| < 2^bits.
struct number_range {
  int precision, bits;
};

std::int64_t any_number(const number_range &r, random_numbers &random);
// The neighbour `steps` units in the last place away, or n itself if that leaves the range.
std::int64_t stepped(std::int64_t n, std::int64_t steps, const number_range &r);

// A pair from one of the families: independent, clustered about a point, powers of two and their neighbours, on a
// coarse grid, with equal coordinates. `groups` are the inputs, by axis, that a difference may join.
sample any_sample(const stage_case &c, const number_range &r, random_numbers &random);
void change_one(sample &s, const number_range &r, random_numbers &random);

// The steps of a climb that must not succeed; there are three times as many where the environment asks for long ones.
inline int steps_of_climb(int steps) {
  return std::getenv("MEETC_LONG_CLIMBS") != nullptr ? steps : steps / 3;
}

// The best score of some climbs with `steps` steps each; the first one above `enough` ends them.
template <class Score>
double climb(const stage_case &c, const number_range &r, random_numbers &random, int starts, int steps, Score &&score,
             double enough = std::numeric_limits<double>::infinity()) {
  double best = -1;
  for (int start = 0; start < starts; ++start) {
    sample at = any_sample(c, r, random);
    double here = score(at);
    for (int step = 0; step < steps && here <= enough; ++step) {
      sample next = at;
      do
        change_one(next, r, random);
      while (random.one_in(3));
      if (const double there = score(next); there >= here) {
        at = std::move(next);
        here = there;
      }
    }
    best = std::max(best, here);
    if (best > enough)
      break;
  }
  return best;
}

} // namespace meetc::bounds_test

#endif
