// Three-valued logic: where the decision over sets of signs is certain, it says exactly what every choice of signs
// says, and it never rules out the truth.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/numbers.hpp"
#include "tests/generated/judge/predicates.hpp"

using namespace meetc::generated_test;
using meetc::sign;
using meetc::sign_set;
using meetc::truth;

namespace {

constexpr sign signs[] = {sign::negative, sign::zero, sign::positive};
bool holds(sign_set set, sign s) {
  return (set.bits & sign_set::of(s).bits) != 0;
}
sign_set set_of(unsigned bits) {
  return {static_cast<std::uint8_t>(bits)};
}

} // namespace

TEST_CASE("decisions: operations on sets of signs are those on their members") {
  for (unsigned a = 1; a < 8; ++a) {
    unsigned negated = 0, squared = 0;
    for (const sign s : signs)
      if (holds(set_of(a), s)) {
        negated |= sign_set::of(-s).bits;
        squared |= sign_set::of(meetc::square(s)).bits;
      }
    CHECK((-set_of(a)).bits == negated);
    CHECK(meetc::square(set_of(a)).bits == squared);
    for (unsigned b = 1; b < 8; ++b) {
      unsigned product = 0;
      for (const sign s : signs)
        for (const sign t : signs)
          if (holds(set_of(a), s) && holds(set_of(b), t))
            product |= sign_set::of(s * t).bits;
      CHECK((set_of(a) * set_of(b)).bits == product);
    }
  }
}

TEST_CASE("decisions: comparisons and connectives are Kleene's") {
  const auto comparison = [](auto mask) {
    for (unsigned a = 1; a < 8; ++a) {
      unsigned want = 0;
      for (const sign s : signs)
        if (holds(set_of(a), s))
          want |= meetc::in<decltype(mask)::value>(s) ? 2U : 1U;
      CHECK(meetc::in<decltype(mask)::value>(set_of(a)).bits == want);
    }
  };
  comparison(std::integral_constant<int, 1>());
  comparison(std::integral_constant<int, 2>());
  comparison(std::integral_constant<int, 3>());
  comparison(std::integral_constant<int, 4>());
  comparison(std::integral_constant<int, 5>());
  comparison(std::integral_constant<int, 6>());
  for (unsigned a = 1; a < 4; ++a) {
    const truth x{static_cast<std::uint8_t>(a)};
    CHECK(meetc::to_answer(x) == (a == 3 ? meetc::answer::unsure : a == 2 ? meetc::answer::yes : meetc::answer::no));
    unsigned negated = 0;
    for (unsigned i = 0; i < 2; ++i)
      if (a >> i & 1)
        negated |= 1U << (1 - i);
    CHECK(meetc::negate(x).bits == negated);
    for (unsigned b = 1; b < 4; ++b) {
      unsigned conjunction = 0, disjunction = 0;
      for (unsigned i = 0; i < 2; ++i)
        for (unsigned j = 0; j < 2; ++j)
          if (a >> i & 1 && b >> j & 1) {
            conjunction |= 1U << (i & j);
            disjunction |= 1U << (i | j);
          }
      const truth y{static_cast<std::uint8_t>(b)};
      CHECK(meetc::both(x, y).bits == conjunction);
      CHECK(meetc::either(x, y).bits == disjunction);
    }
  }
}

// Over any signs, including those that no operands have, the emitted decision on sets must allow what it says of each
// member, and be certain where every set has one member.
TEST_CASE("decisions: every predicate over sets of signs is sound") {
  for_each_predicate([](auto p) {
    using P = typename decltype(p)::type;
    INFO(p.name);
    random_numbers random(9);
    bool sound = true, certain = true;
    int unsure = 0;
    for (int i = 0; i < effort(20000); ++i) {
      sign s[P::atoms];
      sign_set only[P::atoms], sets[P::atoms];
      const int doubt = random.integer(1, 40), zeros = random.integer(1, 3);
      for (int k = 0; k < P::atoms; ++k) {
        s[k] = random.one_in(zeros) ? sign::zero : signs[random.integer(0, 2)];
        only[k] = sign_set::of(s[k]);
        sets[k] = random.one_in(doubt) ? set_of(only[k].bits | static_cast<unsigned>(random.integer(1, 7))) : only[k];
      }
      const auto check = [&](bool plain, auto alone, auto set) {
        certain = certain && meetc::to_answer(alone) == meetc::to_answer(plain);
        sound = sound && (plain ? meetc::can_be_true(set) : meetc::can_be_false(set));
        unsure += meetc::to_answer(set) == meetc::answer::unsure;
      };
      check(P::whole(s), P::whole(only), P::whole(sets));
      check(P::usual(s), P::usual(only), P::usual(sets));
      if constexpr (P::reject_stage::atoms > 0)
        check(P::rejected(s), P::rejected(only), P::rejected(sets));
      // Without a rare condition the usual decision is the whole one.
      if (!P::needs_rare(s))
        sound = sound && P::usual(s) == P::whole(s);
    }
    CHECK(sound);
    CHECK(certain);
    CHECK(unsure > 0);
  });
}
