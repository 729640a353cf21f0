#include "gen/passes/prune.hpp"

#include "gen/passes/rewrite.hpp"

namespace meetc::passes {

ir::program prune(const ir::program &p) {
  rewrite d(p.nodes);
  std::vector<ir::node_id> results = ir::fold(p, d).of(p.results);
  return {std::move(d.to), std::move(results)};
}

} // namespace meetc::passes
