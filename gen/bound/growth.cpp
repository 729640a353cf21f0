#include "gen/bound/growth.hpp"

#include "gen/ir/fold.hpp"

#include <algorithm>

namespace meetc::bound {
namespace {

struct growing {
  using value = growth;
  bool differences;
  const std::vector<int> &weights;
  bool homogeneous = true;

  value sum(const value &x, const value &y) {
    homogeneous = homogeneous && x.degree == y.degree;
    return {x.degree, std::max(x.bits_more, y.bits_more) + 1};
  }
  value input(const ir::node_ref &, int i) { return {weights.empty() ? 1 : weights[static_cast<std::size_t>(i)], 0}; }
  value constant(const ir::node_ref &, const ir::rational &q) {
    homogeneous = homogeneous && q.get_den() == 1;
    // q| < 2^size. A power of two needs one bit more than its logarithm.
    return {0, static_cast<int>(mpz_sizeinbase(q.get_num().get_mpz_t(), 2))};
  }
  value negate(const ir::node_ref &, const value &x) { return x; }
  value add(const ir::node_ref &, const value &x, const value &y) { return sum(x, y); }
  value subtract(const ir::node_ref &at, const value &x, const value &y) {
    const ir::node &n = at.operation();
    const auto is_input = [&](ir::node_id id) { return at.nodes.at(id).kind == ir::op::input; };
    const value out = sum(x, y);
    return differences && is_input(n.a) && is_input(n.b) ? value{x.degree, 0} : out;
  }
  value multiply(const ir::node_ref &, const value &x, const value &y) {
    return {x.degree + y.degree, x.bits_more + y.bits_more};
  }
  value fused(const ir::node_ref &at, const value &x, const value &y, const value &z) {
    return sum(multiply(at, x, y), z);
  }
};

} // namespace

std::vector<growth> growths(const ir::program &p, bool differences, const std::vector<int> &weights) {
  growing d{differences, weights};
  const auto values = ir::fold(p, d);
  if (!d.homogeneous)
    return {};
  std::vector<growth> out(p.nodes.size());
  for (const ir::node_id id : ir::needed(p.nodes, p.results))
    out[static_cast<std::size_t>(id)] = values.at(id);
  return out;
}

} // namespace meetc::bound
