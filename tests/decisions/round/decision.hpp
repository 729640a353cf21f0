// The decisions as the written proof states them: polynomials in inner products, a list of ways to be near
// enough, and for surfaces a list of ways to be far enough.
#ifndef MEETC_TESTS_DECISIONS_ROUND_DECISION_HPP
#define MEETC_TESTS_DECISIONS_ROUND_DECISION_HPP

#include "tests/decisions/round/gram.hpp"

#include <cstdint>

namespace meetc::decisions_round {

// A test of the sign of a product of atoms; the mask as in meetc::in: 1 negative, 2 zero, 4 positive.
struct literal {
  std::string name;
  std::vector<int> atoms;
  int mask;
};

// A conjunction of literals; the name says which points of the figure it is about.
struct way {
  std::string name;
  std::vector<literal> all;
};

// A hit: one of the ways `near` holds and, if `bounded_below`, one of the literals `far`.
struct decision {
  std::vector<polynomial> atoms;
  std::vector<way> near;
  std::vector<literal> far;
  bool bounded_below = false;

  const way *find(const std::string &name) const; // null if there is none
  // The literal holds if this does: a polynomial is >= 0, or > 0 if `strict`.
  struct inequality {
    polynomial value;
    bool strict;
  };
  inequality holds(const literal &l) const;
  inequality fails(const literal &l) const;

  bool hit(const std::vector<int> &signs) const;
  // 64 cases at once, one in each bit: negative[i] and positive[i] are the cases in which atom i is so.
  std::uint64_t hits(const std::vector<std::uint64_t> &negative, const std::vector<std::uint64_t> &positive) const;
};

// The stated decision of a predicate (not of the single sign, which is one atom).
decision stated(const emitted &e);
// The one atom of side(sphere, point): the sign is its opposite.
polynomial stated_side();

// Decisions with one mistake.
struct mutant {
  std::string of, what;
  decision wrong;
};
std::vector<mutant> mutants();

} // namespace meetc::decisions_round

#endif
