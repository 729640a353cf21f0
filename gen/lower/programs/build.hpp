// Turns polynomials into straight-line code.
//
// Each polynomial is factored. An irreducible one is tried in its vector forms (gen/poly/invariants.hpp), in those with
// completed squares (gen/poly/squares.hpp), and in components, each by a multivariate Horner scheme (horner.hpp). Where
// operations decide, a product of factors competes with the forms of the whole, since a difference of two squares may be
// cheaper than its factors. Every program is expanded again and compared with its polynomials; a difference is a bug and
// throws.
#pragma once
#include "gen/ir/arena.hpp"
#include "gen/lower/programs/horner.hpp"
#include "gen/poly/squares.hpp"

namespace meetc::lower {

using ir::arena;
using ir::needed;
using ir::node;
using ir::node_id;
using ir::op;
using ir::program;
using poly::rational;
using poly::residency;

// The criterion for a form: the fewest operations; the fewest operations for the pair, if objects keep their own
// values (then all operations); or the fewest terms that can cancel (then operations). The last is for signs,
// whose error is bounded. It completes no squares: these save operations, but bring cancellation that the terms do not have,
// or one rounding more. So a formula and a sign of one polynomial may have different forms.
enum class prefer { operations, pair, accuracy };

class builder {
public:
  // The inputs of the program are the base variables of the local origin.
  builder(const poly::local_origin &f, prefer by);

  // A node for a polynomial in its base ring, lowered to differences where possible. Lowering is a change of
  // variables, so an irreducible polynomial stays irreducible and is not factored again.
  node_id build(const poly::poly &absolute, bool is_irreducible = false);
  // A node for a polynomial in any ring, with these nodes as its variables.
  node_id build_over(const poly::poly &p, const std::vector<node_id> &leaves);

  arena &nodes() { return nodes_; }
  const arena &nodes() const { return nodes_; }
  const poly::ring &numbers() const { return origin_.base(); }
  // The program for these results, checked against the polynomials that were asked for. It holds every form that was
  // tried; the passes prune it.
  program finish(const std::vector<node_id> &results) const;

private:
  const poly::local_origin &origin_;
  prefer prefer_;
  arena nodes_;
  std::map<std::string, node_id> known_; // by key of the primitive local polynomial
  std::map<std::vector<int>, std::array<node_id, 3>> crosses_;
  std::map<node_id, poly::poly> asked_; // the polynomials for which build() was called

  // A form that was built.
  struct candidate {
    std::size_t terms;
    int pair, operations; // of the pair; all
    node_id root;
  };
  candidate candidate_of(std::size_t terms, node_id root) const;
  std::array<int, 3> key(const candidate &c) const; // the least is the best
  candidate best_of(const std::vector<candidate> &all) const;
  price by() const { return prefer_ == prefer::pair ? price::pair : price::whole; }
  price other_price() const { return prefer_ == prefer::pair ? price::whole : price::pair; }

  node_id local(const poly::poly &p, bool is_irreducible);
  node_id factored(const poly::poly::factor &f);
  std::vector<candidate> forms(const poly::poly &p);
  node_id leaf(int variable);
  node_id symbol(const poly::invariant &q);
  node_id dot(int i, int j);
  const std::array<node_id, 3> &cross(int i, int j);
  std::vector<node_id> symbols(const std::vector<poly::invariant> &of);
  // symbols: of the form's invariants; the nodes of its made symbols are added.
  std::array<candidate, 3> with_squares(const poly::form &f, std::vector<node_id> &symbols);
};

} // namespace meetc::lower
