// The exact rung's window: differences of at most `window` bits on a common grid make the fp64 form (with
// double-double from degree 3 where the stage is mixed) exact in every value; two bits more do not.
#include "tests/catch.hpp"
#include "tests/gen/bound/judge.hpp"
#include "tests/gen/bound/search.hpp"

using namespace meetc::bounds_test;

namespace {

// Positions in [0, 2^bits), so that differences stay below 2^bits. Numbers that stand alone are in (-2^bits, 2^bits).
std::int64_t any_on_grid(const stage_case &c, std::size_t input, int bits, random_numbers &random) {
  const std::int64_t top = (std::int64_t{1} << bits) - 1;
  const bool alone = c.analysed->axes[input] < 0;
  switch (random.integer(0, 4)) {
  case 0:
    return alone && random.one_in(2) ? -top : top;
  case 1:
    return random.integer(0, 3);
  case 2:
    return top - random.integer(0, 3);
  default:
    return random.integer(alone ? -top : 0, top);
  }
}

// The largest difference between a computed value and the integer. It climbs towards the largest error or, while there
// is none, towards the largest value.
double largest_error(const stage_case &c, int bits, int i, int starts, int steps, std::uint64_t seed) {
  random_numbers random(seed);
  std::vector<double> words(2 * static_cast<std::size_t>(c.signs));
  std::vector<int128> v(static_cast<std::size_t>(c.signs)), m(v);
  const auto k = static_cast<std::size_t>(i);
  double error = 0;
  const auto score = [&](const sample &s) {
    c.in_fp64(s, words.data());
    c.in_integers(s, 0, v.data(), m.data());
    const int128 off = static_cast<int128>(words[2 * k]) + static_cast<int128>(words[2 * k + 1]) - v[k];
    const bool whole = std::trunc(words[2 * k]) == words[2 * k] && std::trunc(words[2 * k + 1]) == words[2 * k + 1];
    const double here = std::abs(static_cast<double>(off)) + (whole ? 0 : 0.5);
    error = std::max(error, here);
    return here > 0 ? 1e60 + here : std::abs(static_cast<double>(v[k]));
  };
  for (int start = 0; start < starts; ++start) {
    sample at;
    for (std::size_t n = 0; n < static_cast<std::size_t>(c.inputs()); ++n)
      at.numbers.push_back(any_on_grid(c, n, bits, random));
    double here = score(at);
    for (int step = 0; step < steps; ++step) {
      sample next = at;
      const auto n = static_cast<std::size_t>(random.integer(0, c.inputs() - 1));
      next.numbers[n] = any_on_grid(c, n, bits, random);
      if (const double there = score(next); there >= here) {
        at = std::move(next);
        here = there;
      }
    }
  }
  return error;
}

} // namespace

TEST_CASE("window: the exact rung's fp64 form is exact inside it") {
  tiny::format = {53, -900};
  for (const stage_case &c : all_stages())
    for (int i = 0; i < c.signs; ++i) {
      INFO(c.name << ", sign " << i << ", window " << c.window);
      CHECK(largest_error(c, c.window, i, 6, 600, static_cast<std::uint64_t>(i)) == 0);
    }
}

// Where double-double sets the limit it is that of the proof, integers below 2^100; the words hold some 106
// bits.
TEST_CASE("window: the limit is real: a few bits more, and every stage has a value that is not exact") {
  tiny::format = {53, -900};
  for (const stage_case &c : all_stages()) {
    INFO(c.name << ", window " << c.window);
    const int more = c.mixed && c.degree > 3 ? 4 : 2;
    double error = 0;
    for (int i = 0; i < c.signs && error == 0; ++i)
      error = largest_error(c, c.window + more, i, 6, 600, static_cast<std::uint64_t>(i));
    CHECK(error > 0);
  }
}
