// Straight-line arithmetic as a hash-consed graph with 32-bit ids. Ids grow from operands to results.
//
// Construction folds constants, 0, 1 and signs: x - y and y - x are one node and a negation, which is free in
// floating point and in integers alike.
#pragma once
#include "gen/poly/frame.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <tuple>
#include <vector>

namespace meetc::ir {

using poly::rational;
using poly::residency;
using node_id = std::int32_t;

enum class op : std::uint8_t { input, constant, negate, add, subtract, multiply, fused }; // fused: a*b + c

struct node {
  op kind;
  node_id a = -1, b = -1, c = -1; // input: a is its number; constant: a indexes constants()
  auto operator<=>(const node &) const = default;
};

class arena {
public:
  arena() = default;
  // where[i]: the residency of input i.
  explicit arena(std::vector<residency> where) : input_residency_(std::move(where)) {}

  node_id input(int i);
  node_id constant(const rational &q);
  node_id negate(node_id a);
  node_id add(node_id a, node_id b);
  node_id subtract(node_id a, node_id b);
  node_id multiply(node_id a, node_id b);
  node_id fused(node_id a, node_id b, node_id c);
  node_id power(node_id a, int exponent);

  const node &at(node_id id) const { return nodes_[static_cast<std::size_t>(id)]; }
  std::size_t size() const { return nodes_.size(); }
  const rational &value(node_id id) const { return constants_[static_cast<std::size_t>(at(id).a)]; }
  bool is_constant(node_id id, const rational &q) const { return at(id).kind == op::constant && value(id) == q; }
  residency where(node_id id) const { return residency_[static_cast<std::size_t>(id)]; }
  const std::vector<residency> &inputs() const { return input_residency_; }

private:
  std::vector<residency> input_residency_;
  std::vector<node> nodes_;
  std::vector<residency> residency_;
  std::vector<rational> constants_;
  std::map<node, node_id> ids_;
  std::map<rational, node_id> constant_ids_;

  node_id intern(node n, residency where);
};

// What a piece of straight-line code computes: nodes of an arena, in the order asked for.
struct program {
  arena nodes;
  std::vector<node_id> results;
};

// Operation counts of what the results need. Negations, constants and products with powers of two are free.
struct counts {
  int multiplications = 0, additions = 0, fused = 0;
  int total() const { return multiplications + additions + 2 * fused; }
};
counts count(const arena &nodes, const std::vector<node_id> &results);
// The same for the nodes of one residency alone.
counts count(const program &p, residency where);

// The ids that the results need, ascending.
std::vector<node_id> needed(const arena &nodes, const std::vector<node_id> &results);

// Products that are used once, in a sum, become explicit fused multiply-adds; unused nodes go.
program fuse(const program &p);

// Each result as a polynomial in the inputs: the check of every pass is to_poly(pass(p)) == to_poly(p).
std::vector<poly::poly> to_poly(const program &p, const poly::ring &inputs);
// Exact evaluation.
std::vector<rational> evaluate(const program &p, const std::vector<rational> &inputs);

// For the exact rung: when inputs are integers below 2^bits in magnitude, every node of the program is below
// 2^(degree * bits + growth). Empty when the nodes are not homogeneous or a constant is not an integer.
struct magnitude {
  int degree, growth;
};
// With `differences`, 2^bits bounds the differences of inputs too.
std::vector<magnitude> magnitudes(const program &p, bool differences = false); // of all nodes by id, or empty

} // namespace meetc::ir
