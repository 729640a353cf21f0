// Straight-line arithmetic as a hash-consed graph with 32-bit ids. The id of a node is greater than those of its
// operands.
//
// Construction folds constants, 0, 1 and signs: x - y and y - x become one node and a negation, which costs nothing in
// floating point or in integers.
#pragma once
#include "gen/poly/local_origin.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
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

// The operands of an operation; inputs and constants have none.
struct operand_list {
  std::array<node_id, 3> ids;
  std::size_t count;
  auto begin() const { return ids.begin(); }
  auto end() const { return ids.begin() + static_cast<std::ptrdiff_t>(count); }
};
constexpr operand_list operands(const node &n) {
  const bool none = n.kind == op::input || n.kind == op::constant;
  return {{n.a, n.b, n.c}, none ? 0U : n.b < 0 ? 1U : n.c < 0 ? 2U : 3U};
}

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

// A piece of straight-line code: nodes of an arena, with the results in a given order.
struct program {
  arena nodes;
  std::vector<node_id> results;
  // Values of one object that are computed once and stored beside it, in ascending order; the pair reads them. All
  // other values of one object are computed for each pair. See gen/passes/store.hpp.
  std::vector<node_id> stored = {};
  // The names of values that have one in the spec, by node; of programs after the last pass.
  std::map<node_id, std::string> names = {};
};

// The ids of the nodes that the results need, in ascending order. Operands of a node in `given` are not needed for it.
std::vector<node_id> needed(const arena &nodes, const std::vector<node_id> &results,
                            const std::vector<node_id> &given = {});
// The stored values of object A or of object B.
std::vector<node_id> stored_of(const program &p, residency object);

// The nodes that one root needs, itself included, each after its operands, in an order that depends only on the shape
// of the graph. The operands of a node that `stops` accepts are left out.
std::vector<node_id> operands_first(const arena &nodes, node_id root, const std::function<bool(node_id)> &stops);

} // namespace meetc::ir
