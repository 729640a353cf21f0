// Tests one placed member of a class by the emitted decision and by the judge.
#ifndef MEETC_TESTS_DECISIONS_WITNESS_HPP
#define MEETC_TESTS_DECISIONS_WITNESS_HPP

#include "tests/decisions/flat/classes.hpp"
#include "tests/decisions/flat/placement.hpp"
#include "tests/decisions/flat/subjects.hpp"
#include "tests/generated/judge/predicates.hpp"

#include <cmath>

namespace meetc::decisions_test {

// The exact signs of a pair with integer coordinates: the emitted programs run in 64-bit integers, which hold
// all values where coordinates stay below 2^18 (Stage::degree 3, Stage::growth 6).
template <class P> struct integer_pair {
  std::int64_t a[P::inputs_a], b[P::inputs_b];

  explicit integer_pair(const points &x) {
    for (std::size_t i = 0; i < P::inputs_a; ++i)
      a[i] = x[i / 3][i % 3];
    for (std::size_t i = 0; i < P::inputs_b; ++i)
      b[i] = x[(P::inputs_a + i) / 3][i % 3];
  }
  // In the form that meetc::decide requires.
  template <class Stage> void get(meetc::sign *s) const {
    static_assert(18 * Stage::degree + Stage::growth < 63);
    meetc::stage_signs<Stage>(a, b, s);
  }
  void all(meetc::sign *s) const {
    each_stage<P>([&](auto stage) { get<decltype(stage)>(s); });
  }
  bool small() const {
    const auto below = [](std::int64_t c) { return std::abs(c) < 1 << 18; };
    return std::ranges::all_of(a, below) && std::ranges::all_of(b, below);
  }
};

// The answer of the header's entry point for the same numbers in float32, which represents them exactly.
template <class P> bool hit_of(const points &x) {
  std::vector<float> rows;
  for (const place &p : x)
    for (const std::int64_t c : p)
      rows.push_back(static_cast<float>(c));
  bool hit = false;
  generated_test::for_each_predicate([&](auto p) {
    if constexpr (std::is_same_v<typename decltype(p)::type, P>)
      hit = p.hit(rows.data(), rows.data() + P::inputs_a);
  });
  return hit;
}

// Counts of faults of a witness, all of which must be 0.
struct findings {
  int big = 0;      // a coordinate is too large for this proof
  int judges = 0;   // the key's answer differs from the oracle's
  int decision = 0; // the staged decision on exact signs
  int whole = 0;    // the decision without its reject lines and stages
  int rejected = 0; // a reject line holds for a pair that meets
  int header = 0;   // P::hit
  int hits = 0, misses = 0;
  bool clean() const { return big + judges + decision + whole + rejected + header == 0; }
};

template <class P> void examine(const points &x, bool meets, bool by_oracle, findings &f) {
  const integer_pair<P> pair(x);
  meetc::sign s[P::atoms];
  pair.all(s);
  f.big += !pair.small();
  f.judges += meets != by_oracle;
  f.decision += meetc::decide<P>(pair) != meets;
  f.whole += P::whole(s) != meets;
  f.rejected += P::rejected(s) && meets;
  f.header += hit_of<P>(x) != meets;
  (meets ? f.hits : f.misses) += 1;
}

} // namespace meetc::decisions_test

#endif
