#include "gen/ir/rewrite.hpp"

namespace meetc::ir {
namespace {

struct parting : rewrite {
  using rewrite::rewrite;
  value fused(const node_ref &, value x, value y, value z) { return to.add(to.multiply(x, y), z); }
};

} // namespace

program unfused(const program &p) {
  parting d(p.nodes);
  const folded<node_id> nodes = fold(p, d);
  std::vector<node_id> results = nodes.of(p.results);
  return {std::move(d.to), std::move(results)};
}

} // namespace meetc::ir
