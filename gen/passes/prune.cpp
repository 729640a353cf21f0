#include "gen/passes/prune.hpp"

#include "gen/ir/rewrite.hpp"

namespace meetc::passes {

ir::program prune(const ir::program &p) {
  ir::rewrite d(p.nodes);
  std::vector<ir::node_id> results = ir::fold(p, d).of(p.results);
  return {std::move(d.to), std::move(results)};
}

} // namespace meetc::passes
