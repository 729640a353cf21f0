// Decisions over sign atoms.
//
// An atom is the sign of an irreducible primitive polynomial whose leading coefficient is positive, so equal (or
// opposite) signs are one atom however they were written. A sign value is a unit times a product of atoms. A truth is a
// node of a hash-consed graph over tests of sign values.
#pragma once
#include "gen/lower/expand/rule.hpp"

#include <map>
#include <string>
#include <vector>

namespace meetc::lower {

// unit * product of atoms; unit 0 is the sign zero. The exponent 2 stands for every even power.
struct sign_value {
  int unit = 0;
  std::vector<std::pair<int, int>> atoms; // (atom, 1 or 2), by atom
  auto operator<=>(const sign_value &) const = default;
};

sign_value operator*(const sign_value &a, const sign_value &b);
sign_value operator-(sign_value a);

// The signs that pass a test: bit 0 negative, bit 1 zero, bit 2 positive (as meetc::in<Mask>).
using sign_mask = int;

struct truth_node {
  enum class type { constant, test, both, either, negate, choose } kind;
  int flag = 0;          // for constants: 0 or 1; for tests: the mask
  sign_value sign;       // for tests
  std::vector<int> args; // both, either: two or more, sorted; negate: one; choose: condition, then, else
  auto operator<=>(const truth_node &) const = default;
};

// The atoms and truths of one kernel.
class decision {
public:
  // Factors that are positive on all valid operands are left out of the signs taken from here on (rule.hpp).
  void assume(known_signs known) { known_ = std::move(known); }
  sign_value sign_of(const poly::poly &p);
  // The same for an atom of another decision, which is not factored again.
  sign_value sign_of_atom(const poly::poly &atom);
  // The spec's text for an atom, "side(B, A.a)"; "" where it has none.
  std::string text(int atom) const;
  // Records the spec's text for a sign. It replaces a text recorded since `mark`, but not an older one.
  void describe(const sign_value &s, const std::string &text, long mark);
  long mark() const { return given_; }
  int constant(bool b);
  int test(const sign_value &s, sign_mask mask);
  int both(const std::vector<int> &args) { return connect(truth_node::type::both, args); }
  int either(const std::vector<int> &args) { return connect(truth_node::type::either, args); }
  int negate(int a);
  int choose(int condition, int then, int otherwise);

  const std::vector<poly::poly> &atoms() const { return atoms_; }
  const truth_node &at(int id) const { return nodes_[static_cast<std::size_t>(id)]; }
  std::size_t size() const { return nodes_.size(); }

  // Evaluates a truth for given signs of the atoms.
  bool evaluate(int id, const std::vector<int> &signs) const;

  // The atoms that a truth reads, ascending. If `rare` is false, the then-branches of choose are left out.
  std::vector<int> atoms_of(int id, bool rare) const;
  // The conditions of all choose nodes that a truth reaches outside then-branches.
  std::vector<int> conditions_of(int id) const;
  // The truth in the case that every condition of conditions_of() is false.
  int usual(int id);

private:
  struct name {
    std::string text;
    bool opposite = false; // the text is that of the negated atom
    long given = 0;
  };

  int id_of(const poly::poly &atom);

  std::vector<poly::poly> atoms_;
  std::vector<name> texts_; // by atom
  long given_ = 0;
  known_signs known_;
  std::map<std::string, int> atom_ids_;
  std::map<std::string, sign_value> signs_; // by the key of the primitive polynomial, factored or not
  std::vector<truth_node> nodes_;
  std::map<truth_node, int> node_ids_;

  int intern(truth_node n);
  int connect(truth_node::type kind, const std::vector<int> &args);
};

// A predicate's decision, by stages.
struct staged {
  std::vector<int> reject; // any true one means a miss
  int hit = 0;
};

} // namespace meetc::lower
