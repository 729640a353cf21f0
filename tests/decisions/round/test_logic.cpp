// Step 2 of the proof: the emitted decision with its staging equals the stated decision and the spec's on every
// vector of signs, whether or not any operands have it.
#include "gen/driver.hpp"
#include "tests/catch.hpp"
#include "tests/decisions/round/decision.hpp"

#include <algorithm>

using namespace meetc;
using namespace meetc::decisions_round;

namespace {

using bits = std::uint64_t;
constexpr int lane_atoms = 3, lanes = 27; // a word has 3^3 vectors of signs

// All vectors of signs of `atoms` atoms, one word at a time, until `f` returns false; the first three atoms vary
// within a word. `f` takes the masks of the vectors in which each atom is negative and positive, and the number of
// vectors.
template <class F> long for_each_word(int atoms, F &&f) {
  const int inner = std::min(atoms, lane_atoms), outer = atoms - inner;
  int in_word = 1;
  std::vector<bits> below(static_cast<std::size_t>(atoms)), above(below);
  for (int i = 0; i < inner; ++i, in_word *= 3)
    for (int lane = 0; lane < lanes; ++lane) {
      const int sign = lane / in_word % 3;
      below[static_cast<std::size_t>(i)] |= bits{sign == 0} << lane;
      above[static_cast<std::size_t>(i)] |= bits{sign == 2} << lane;
    }
  std::vector<int> signs(static_cast<std::size_t>(outer), -1);
  long words = 0;
  for (;;) {
    for (int i = 0; i < outer; ++i) {
      const auto at = static_cast<std::size_t>(i);
      below[at + lane_atoms] = signs[at] < 0 ? ~bits{0} : 0;
      above[at + lane_atoms] = signs[at] > 0 ? ~bits{0} : 0;
    }
    ++words;
    if (!f(below, above, in_word))
      return words * in_word;
    int i = 0;
    while (i < outer && signs[static_cast<std::size_t>(i)] == 1)
      signs[static_cast<std::size_t>(i++)] = -1;
    if (i == outer)
      return words * in_word;
    ++signs[static_cast<std::size_t>(i)];
  }
}

// The spec's decision, as the compiler keeps it, on a word of sign vectors. It is written independently, so that
// the compiler's evaluation is not trusted either. `place` is an atom's index among the emitted ones.
bits spec_hits(const lower::decision &d, int id, const std::vector<int> &place, const std::vector<bits> &below,
               const std::vector<bits> &above, std::vector<bits> &value) {
  using type = lower::truth_node::type;
  for (int i = 0; i <= id; ++i) {
    const lower::truth_node &n = d.at(i);
    bits v = 0;
    const auto of = [&](std::size_t k) { return value[static_cast<std::size_t>(n.args[k])]; };
    switch (n.kind) {
    case type::constant:
      v = n.flag ? ~bits{0} : 0;
      break;
    case type::test: {
      bits negative = n.sign.unit < 0 ? ~bits{0} : 0, positive = n.sign.unit > 0 ? ~bits{0} : 0;
      for (const auto &[atom, exponent] : n.sign.atoms)
        for (int k = 0; k < exponent; ++k) {
          const auto at = static_cast<std::size_t>(place[static_cast<std::size_t>(atom)]);
          const bits product = (negative & above[at]) | (positive & below[at]);
          positive = (negative & below[at]) | (positive & above[at]);
          negative = product;
        }
      v = (n.flag & 1 ? negative : 0) | (n.flag & 2 ? ~(negative | positive) : 0) | (n.flag & 4 ? positive : 0);
      break;
    }
    case type::both:
      v = ~bits{0};
      for (std::size_t k = 0; k < n.args.size(); ++k)
        v &= of(k);
      break;
    case type::either:
      for (std::size_t k = 0; k < n.args.size(); ++k)
        v |= of(k);
      break;
    case type::negate:
      v = ~of(0);
      break;
    case type::choose:
      v = (of(0) & of(1)) | (~of(0) & of(2));
      break;
    }
    value[static_cast<std::size_t>(i)] = v;
  }
  return value[static_cast<std::size_t>(id)];
}

// The answers of the emitted functions for one word.
struct words {
  bits decide = 0, rejected = 0, needs_rare = 0, usual = 0, whole = 0;
};
words emitted_words(const emitted &e, const std::vector<bits> &below, const std::vector<bits> &above, int count) {
  words out;
  meetc::sign s[32];
  for (int lane = 0; lane < count; ++lane) {
    for (std::size_t i = 0; i < below.size(); ++i)
      s[i] = static_cast<meetc::sign>(static_cast<int>(above[i] >> lane & 1) - static_cast<int>(below[i] >> lane & 1));
    out.decide |= bits{e.decide(s)} << lane;
    out.rejected |= bits{e.rejected(s)} << lane;
    out.needs_rare |= bits{e.needs_rare(s)} << lane;
    out.usual |= bits{e.usual(s)} << lane;
    out.whole |= bits{e.whole(s)} << lane;
  }
  return out;
}

} // namespace

TEST_CASE("on all sign vectors the emitted decision equals the stated one and the spec's") {
  const compilation scene = load(MEETC_SCENE);
  long expected[] = {3, 9, 243, 243, 43046721, 43046721};
  std::size_t number = 0;
  for (const emitted &e : emitted_predicates()) {
    if (e.value)
      continue;
    INFO(e.name);
    const decision stated_one = stated(e);
    const lower::kernel k =
        compile(scene, lower::resolve(*scene.model, lang::parse_expression(e.name, "a test"))).kernel;
    const lower::predicate &p = k.decision;
    // The spec's numbers are the rows' in the same order, and its atoms are the emitted polynomials.
    REQUIRE(p.stored_inputs.size() == static_cast<std::size_t>(e.inputs_a + e.inputs_b));
    CHECK(p.stored_inputs[3] == "S.r");
    REQUIRE(p.truths.reject.empty());
    REQUIRE(p.common.atoms.size() == static_cast<std::size_t>(e.atoms));
    REQUIRE(p.signs.atoms().size() == static_cast<std::size_t>(e.atoms));
    const std::vector<polynomial> emits = e.polynomials(*p.numbers);
    std::vector<int> place(p.signs.atoms().size());
    for (std::size_t i = 0; i < emits.size(); ++i) {
      const auto atom = static_cast<std::size_t>(p.common.atoms[i]);
      CHECK(p.signs.atoms()[atom] == emits[i]);
      place[atom] = static_cast<int>(i);
    }
    long differ_stated = 0, differ_spec = 0, rejected = 0, rare = 0, differ_whole = 0, hits = 0;
    std::vector<bits> value(p.signs.size());
    const long all = for_each_word(e.atoms, [&](const auto &below, const auto &above, int count) {
      const bits mask = (bits{1} << count) - 1;
      const words w = emitted_words(e, below, above, count);
      differ_stated += (w.decide ^ (stated_one.hits(below, above) & mask)) != 0;
      differ_spec += (w.decide ^ (spec_hits(p.signs, p.truths.hit, place, below, above, value) & mask)) != 0;
      rejected += w.rejected != 0;
      rare += w.needs_rare != 0;
      differ_whole += w.usual != w.whole;
      hits += __builtin_popcountll(w.decide);
      return true;
    });
    CHECK(all == expected[number++]);
    CHECK(differ_stated == 0);
    CHECK(differ_spec == 0);
    CHECK(rejected == 0); // the ball predicates have no reject stage,
    CHECK(rare == 0);     // no rare stage,
    CHECK(differ_whole == 0);
    CHECK(hits > 0);
    CHECK(hits < all);
  }
}

TEST_CASE("a stated decision with one mistake is not the emitted one") {
  for (const mutant &m : mutants()) {
    INFO(m.of << ": " << m.what);
    const emitted &e = emitted_predicate(m.of);
    if (m.wrong.atoms != stated(e).atoms)
      continue; // the mistake is in an atom, which the identities find
    bool differs = false;
    for_each_word(e.atoms, [&](const auto &below, const auto &above, int count) {
      const bits mask = (bits{1} << count) - 1;
      differs = emitted_words(e, below, above, count).decide != (m.wrong.hits(below, above) & mask);
      return !differs;
    });
    CHECK(differs);
  }
}

TEST_CASE("the single sign is the opposite of that of its atom") {
  const emitted &e = emitted_predicate("side_sphere_point");
  for (const meetc::sign s : {meetc::sign::negative, meetc::sign::zero, meetc::sign::positive})
    CHECK(e.value(&s) == -s);
}
