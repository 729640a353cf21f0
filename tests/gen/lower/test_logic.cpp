// The emitted decisions, compiled as they are, boolean and three-valued, against the compiler's decision and against
// each other.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"
#include "tests/gen/oracle/random.hpp"

#include <array>
#include <cga/cga.hpp>
#include <cga/for_each.hpp>
#include <cga/header_only.hpp>

using namespace meetc;
using namespace meetc::compiler_test;
using oracle_test::random_numbers;

namespace {

// The questions that a decision can answer.
enum class question { rejected, needs_rare, usual, whole };
constexpr std::array questions{question::rejected, question::needs_rare, question::usual, question::whole};

template <class P, class S> auto ask(question q, const S *s) {
  switch (q) {
  case question::rejected:
    return ::meetc::to_answer(P::rejected(s));
  case question::needs_rare:
    return ::meetc::to_answer(P::needs_rare(s)); // a bool for sets too: whether the rare stage may be needed
  case question::usual:
    return ::meetc::to_answer(P::usual(s));
  default:
    return ::meetc::to_answer(P::whole(s));
  }
}

::meetc::sign random_sign(random_numbers &random) {
  return static_cast<::meetc::sign>(random.integer(-1, 1));
}
::meetc::sign pick(::meetc::sign_set set, random_numbers &random) {
  for (;;)
    if (const ::meetc::sign s = random_sign(random); set.bits & ::meetc::sign_set::of(s).bits)
      return s;
}

template <class P> void check_logic(const char *name) {
  INFO(name);
  const lower::predicate &p = default_kernel(name).decision;
  // Emitted signs are numbered by stage.
  std::vector<int> atom_of;
  for (const lower::stage *s : {&p.reject, &p.common, &p.rare})
    atom_of.insert(atom_of.end(), s->atoms.begin(), s->atoms.end());
  REQUIRE(atom_of.size() == static_cast<std::size_t>(P::atoms));
  random_numbers random(31);
  std::vector<::meetc::sign> one(atom_of.size());
  std::vector<::meetc::sign_set> sets(one.size()), larger(one.size());
  std::vector<int> by_atom(p.signs.atoms().size());
  int certain = 0, unsure = 0;
  for (int round = 0; round < 2000; ++round) {
    // Singletons: the emitted bool, the emitted truth and the compiler's decision agree.
    const int zeros = random.integer(0, 3); // some rounds have many zeros
    for (std::size_t i = 0; i < one.size(); ++i) {
      one[i] = zeros == 0 && random.integer(0, 1) ? ::meetc::sign::zero : random_sign(random);
      sets[i] = ::meetc::sign_set::of(one[i]);
      by_atom[static_cast<std::size_t>(atom_of[i])] = static_cast<int>(one[i]);
    }
    bool reject = false, rare = false;
    for (const int t : p.truths.reject)
      reject = reject || p.signs.evaluate(t, by_atom);
    for (const int t : p.conditions)
      rare = rare || p.signs.evaluate(t, by_atom);
    const std::array have{ask<P>(question::rejected, one.data()), ask<P>(question::needs_rare, one.data()),
                          ask<P>(question::usual, one.data()), ask<P>(question::whole, one.data())};
    const std::array<bool, 4> wanted{reject, rare, p.signs.evaluate(p.usual, by_atom),
                                     p.signs.evaluate(p.truths.hit, by_atom)};
    for (std::size_t q = 0; q < questions.size(); ++q) {
      if (have[q] != ::meetc::to_answer(wanted[q]) || ask<P>(questions[q], sets.data()) != have[q])
        FAIL_CHECK("question " << q << " has several answers");
    }
    if (!rare && have[2] != have[3])
      FAIL_CHECK("the common case differs from the whole where no condition holds");

    // Sets: a certain answer is the answer for every choice, and a larger set never reverses it.
    const int wide = random.integer(1, 12);
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (random.integer(0, wide) == 0)
        sets[i].bits = static_cast<std::uint8_t>(sets[i].bits | random.integer(1, 7));
      larger[i] = sets[i];
      if (random.integer(0, 5) == 0)
        larger[i].bits = static_cast<std::uint8_t>(larger[i].bits | random.integer(1, 7));
    }
    for (const question q : {question::rejected, question::usual, question::whole}) {
      const ::meetc::answer of_set = ask<P>(q, sets.data()), of_larger = ask<P>(q, larger.data());
      if (of_larger != ::meetc::answer::unsure && of_larger != of_set)
        FAIL_CHECK("a larger set is more certain");
      if (of_set == ::meetc::answer::unsure) {
        ++unsure;
        continue;
      }
      ++certain;
      for (int choice = 0; choice < 8; ++choice) {
        for (std::size_t i = 0; i < one.size(); ++i)
          one[i] = pick(sets[i], random);
        if (ask<P>(q, one.data()) != of_set)
          FAIL_CHECK("a certain answer is not the answer of a choice");
      }
    }
    // Without the signs of the rare stage, as much is known as if each of them could be anything.
    if constexpr (requires { P::open(sets.data()); }) {
      larger = sets;
      for (std::size_t i = larger.size() - p.rare.atoms.size(); i < larger.size(); ++i)
        larger[i] = ::meetc::sign_set::all();
      if (::meetc::to_answer(P::open(sets.data())) != ask<P>(question::whole, larger.data()))
        FAIL_CHECK("the decision without the rare stage is another one");
    }
    // The rare stage is left out only where no choice needs it.
    if (!meetc::can_be_true(P::needs_rare(sets.data())))
      for (int choice = 0; choice < 8; ++choice) {
        for (std::size_t i = 0; i < one.size(); ++i)
          one[i] = pick(sets[i], random);
        if (P::needs_rare(one.data()))
          FAIL_CHECK("a choice needs the rare stage");
      }
  }
  CHECK(certain > 100); // the test can fail: both happen
  CHECK(unsure > 100);
}

} // namespace

TEST_CASE("the emitted decisions, on signs and on sets of signs") {
  std::size_t checked = 0;
  cga::for_each_predicate([&checked](auto p) {
    check_logic<typename decltype(p)::type>(p.name);
    ++checked;
  });
  CHECK(default_kernels(want::predicates).size() == checked);
}

TEST_CASE("signs and sets of signs: products, squares, tests and connectives, all of them") {
  const auto holds = [](::meetc::sign_set set, int s) { return (set.bits >> (s + 1) & 1) != 0; };
  for (int a = 1; a < 8; ++a)
    for (int b = 1; b < 8; ++b) {
      const ::meetc::sign_set x{static_cast<std::uint8_t>(a)}, y{static_cast<std::uint8_t>(b)};
      int product = 0, square = 0, minus = 0;
      for (int s = -1; s <= 1; ++s)
        for (int t = -1; t <= 1; ++t)
          if (holds(x, s) && holds(y, t)) {
            product |= 1 << (s * t + 1);
            square |= 1 << (s * s + 1);
            minus |= 1 << (1 - s);
          }
      CHECK((x * y).bits == product);
      CHECK(::meetc::square(x).bits == square);
      CHECK((-x).bits == minus);
    }
  for (int a = 1; a < 4; ++a)
    for (int b = 1; b < 4; ++b) {
      const ::meetc::truth x{static_cast<std::uint8_t>(a)}, y{static_cast<std::uint8_t>(b)};
      int both = 0, either = 0, negate = 0;
      for (int s = 0; s < 2; ++s)
        for (int t = 0; t < 2; ++t)
          if ((a >> s & 1) && (b >> t & 1)) {
            both |= 1 << (s & t);
            either |= 1 << (s | t);
            negate |= 1 << (1 - s);
          }
      CHECK(::meetc::both(x, y).bits == both);
      CHECK(::meetc::either(x, y).bits == either);
      CHECK(::meetc::negate(x).bits == negate);
    }
  for (int a = 1; a < 8; ++a) {
    const ::meetc::sign_set x{static_cast<std::uint8_t>(a)};
    CHECK(::meetc::in<3>(x).can_be_true() == ((a & 3) != 0));
    CHECK(::meetc::in<3>(x).can_be_false() == ((a & 4) != 0));
    CHECK(::meetc::in<2>(x).can_be_true() == ((a & 2) != 0));
    CHECK(::meetc::in<2>(x).can_be_false() == ((a & 5) != 0));
  }
}
