// The emitted decisions equal the hand-written ones for all signs, and their stages agree: see symbolic.hpp.
#include "tests/decisions/flat/symbolic.hpp"

#include "tests/catch.hpp"
#include "tests/decisions/flat/subjects.hpp"
#include "tests/generated/judge/numbers.hpp"

#include <algorithm>

using namespace meetc::decisions_test;
using meetc::symbolic_sign;

namespace {

template <class P> std::vector<symbolic_sign> names() {
  std::vector<symbolic_sign> s;
  for (int i = 0; i < P::atoms; ++i)
    s.push_back({1, {i}});
  return s;
}

template <class P> formula whole_by_hand(const std::vector<symbolic_sign> &s, const atom_table &table, change c) {
  return written<P>::whole(formulas<symbolic_sign>(table, s.data(), c)).form;
}
template <class P> formula rejected_by_hand(const std::vector<symbolic_sign> &s, change c) {
  if constexpr (staged<P>)
    return written<P>::rejected(formulas<symbolic_sign>(atoms_of<P>(), s.data(), c)).form;
  else
    return constant(false);
}
template <class P> formula rejected(const std::vector<symbolic_sign> &s) {
  if constexpr (staged<P>)
    return P::rejected(s.data()).form;
  else
    return constant(P::rejected(s.data()));
}
template <class P> formula needs_rare(const std::vector<symbolic_sign> &s) {
  if constexpr (staged<P>)
    return P::needs_rare(s.data()).form;
  else
    return constant(P::needs_rare(s.data()));
}

} // namespace

TEST_CASE("formulas: every emitted sign is that of a determinant, a turn or a difference") {
  for_each_subject([](auto p) {
    using P = decltype(p);
    INFO(written<P>::name);
    const atom_table &table = atoms_of<P>(); // throws if a value is something else
    CHECK(table.label_count() == written<P>::of_a + written<P>::of_b);
    CHECK(table.all().size() == P::atoms);
  });
  // Half of such a value, or a sum of two, is not recognised.
  const auto x = [](int label) { return polynomial::coordinate(label, 0); };
  CHECK_NOTHROW(recognise(3, {x(1) - x(0)}));
  CHECK_THROWS(recognise(3, {x(1) + x(0)}));
  CHECK_THROWS(recognise(3, {x(1) - x(0) + x(1) - x(0)}));
}

TEST_CASE("formulas: the emitted decision equals the hand-written one for all signs") {
  for_each_subject([](auto p) {
    using P = decltype(p);
    INFO(written<P>::name);
    const auto s = names<P>();
    CHECK(P::whole(s.data()).form == whole_by_hand<P>(s, atoms_of<P>(), change::none));
    CHECK(rejected<P>(s) == rejected_by_hand<P>(s, change::none));
    if constexpr (staged<P>) {
      const formulas<symbolic_sign> f(atoms_of<P>(), s.data());
      CHECK(needs_rare<P>(s) == written<P>::rare(f).form);
      CHECK(P::usual(s.data()).form == written<P>::usual(f).form);
    }
  });
}

TEST_CASE("formulas: if no rare sign is needed, the usual decision equals the whole one") {
  for_each_subject([](auto p) {
    using P = decltype(p);
    INFO(written<P>::name);
    const auto s = names<P>();
    const formula rare = needs_rare<P>(s), whole = P::whole(s.data()).form, usual = P::usual(s.data()).form;
    const auto untrue = alternatives(rare);
    CHECK(where_false(whole, untrue) == where_false(usual, untrue));
    // Without one rare condition it does not.
    if constexpr (staged<P>)
      for (std::size_t i = 0; i < untrue.size(); ++i) {
        auto fewer = untrue;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        CHECK(where_false(whole, fewer) != where_false(usual, fewer));
      }
  });
}

TEST_CASE("formulas: another formula, or another table of signs, has another form") {
  std::vector<bool> seen(static_cast<std::size_t>(change::count));
  for_each_subject([&](auto p) {
    using P = decltype(p);
    INFO(written<P>::name);
    const auto s = names<P>();
    const formula whole = P::whole(s.data()).form, reject = rejected<P>(s);
    for (std::size_t c = 0; c < seen.size(); ++c)
      if (whole_by_hand<P>(s, atoms_of<P>(), static_cast<change>(c)) != whole ||
          rejected_by_hand<P>(s, static_cast<change>(c)) != reject)
        seen[c] = true;
    // One sign is replaced by its opposite. A test for zero alone is not affected.
    int minded = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      auto atoms = atoms_of<P>().all();
      atoms[i].sign = -atoms[i].sign;
      minded += whole_by_hand<P>(s, atom_table(atoms_of<P>().label_count(), atoms), change::none) != whole;
    }
    CHECK(minded == P::atoms - (staged<P> ? 0 : 1));
  });
  CHECK(!seen[static_cast<std::size_t>(change::none)]);
  CHECK(std::ranges::count(seen, true) == static_cast<int>(change::count) - 1);
}

// This case does not use forms.
TEST_CASE("formulas: hand-written and emitted answers agree on random signs") {
  for_each_subject([](auto p) {
    using P = decltype(p);
    INFO(written<P>::name);
    meetc::generated_test::random_numbers random(5);
    bool same = true;
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
      meetc::sign s[P::atoms];
      const int zeros = random.integer(1, 4);
      for (meetc::sign &x : s)
        x = random.one_in(zeros) ? meetc::sign::zero : static_cast<meetc::sign>(random.integer(-1, 1));
      const formulas<meetc::sign> f(atoms_of<P>(), s);
      same = same && P::whole(s) == written<P>::whole(f);
      if constexpr (staged<P>)
        same = same && P::rejected(s) == written<P>::rejected(f) && P::needs_rare(s) == written<P>::rare(f) &&
               P::usual(s) == written<P>::usual(f);
      hits += P::whole(s);
    }
    CHECK(same);
    CHECK(hits > 0);
    CHECK(hits < 20000);
  });
}
