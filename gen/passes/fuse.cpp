#include "gen/passes/fuse.hpp"

#include "gen/ir/rewrite.hpp"

namespace meetc::passes {
namespace {
using ir::node_id;

// A node of the new program, with its factors where it is a product that may be fused.
struct fusable {
  node_id id, a = -1, b = -1;
  ir::residency where{};
};

struct fusing {
  using value = fusable;
  ir::arena to;
  std::vector<int> uses; // by node of the old program

  explicit fusing(const ir::program &p) : to(p.nodes.inputs()), uses(p.nodes.size()) {
    for (const node_id r : p.results)
      ++uses[static_cast<std::size_t>(r)];
    for (const node_id id : ir::needed(p.nodes, p.results))
      for (const node_id operand : ir::operands(p.nodes.at(id)))
        ++uses[static_cast<std::size_t>(operand)];
  }

  static bool fits(const ir::node_ref &sum, const value &x) { return x.a >= 0 && x.where == sum.where(); }

  value input(const ir::node_ref &, int number) { return {to.input(number)}; }
  value constant(const ir::node_ref &, const ir::rational &q) { return {to.constant(q)}; }
  value negate(const ir::node_ref &, const value &x) { return {to.negate(x.id)}; }
  value add(const ir::node_ref &at, const value &x, const value &y) {
    return {fits(at, y) ? to.fused(y.a, y.b, x.id) : fits(at, x) ? to.fused(x.a, x.b, y.id) : to.add(x.id, y.id)};
  }
  value subtract(const ir::node_ref &at, const value &x, const value &y) {
    return {fits(at, y)   ? to.fused(to.negate(y.a), y.b, x.id)
            : fits(at, x) ? to.fused(x.a, x.b, to.negate(y.id))
                          : to.subtract(x.id, y.id)};
  }
  value multiply(const ir::node_ref &at, const value &x, const value &y) {
    const node_id product = to.multiply(x.id, y.id);
    if (uses[static_cast<std::size_t>(at.id)] != 1)
      return {product};
    return {product, x.id, y.id, at.where()};
  }
  value fused(const ir::node_ref &, const value &x, const value &y, const value &z) {
    return {to.fused(x.id, y.id, z.id)};
  }
};

} // namespace

ir::program fuse(const ir::program &p) {
  fusing d(p);
  const auto values = ir::fold(p, d);
  std::vector<node_id> results;
  for (const node_id r : p.results)
    results.push_back(values.at(r).id);
  return {std::move(d.to), std::move(results)};
}

} // namespace meetc::passes
