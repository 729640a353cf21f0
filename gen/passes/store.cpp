#include "gen/passes/store.hpp"

#include "gen/ir/count.hpp"

#include <algorithm>
#include <set>

namespace meetc::passes {
namespace {
using ir::node_id;
using ir::op;
using ir::residency;

bool of_one_object(const ir::arena &nodes, node_id id) {
  const residency where = nodes.where(id);
  return where == residency::a || where == residency::b;
}

// A negation is not stored; its readers negate.
node_id without_sign(const ir::arena &nodes, node_id id) {
  while (nodes.at(id).kind == op::negate)
    id = nodes.at(id).a;
  return id;
}

// Stores what costs more than `most_recomputed` operations.
ir::program storing(const ir::program &p, int most_recomputed) {
  std::set<node_id> stored;
  const auto read_by_pair = [&](node_id id) {
    id = without_sign(p.nodes, id);
    if (of_one_object(p.nodes, id) && ir::count(p.nodes, {id}).total() > most_recomputed)
      stored.insert(id);
  };
  for (const node_id r : p.results)
    read_by_pair(r);
  for (const node_id id : ir::needed(p.nodes, p.results))
    if (!of_one_object(p.nodes, id))
      for (const node_id operand : ir::operands(p.nodes.at(id)))
        read_by_pair(operand);
  ir::program out = p;
  out.stored.assign(stored.begin(), stored.end());
  return out;
}

} // namespace

ir::program store(const ir::program &p) {
  return storing(p, cheapest);
}

ir::program keep(const ir::program &p) {
  return storing(p, 0);
}

} // namespace meetc::passes
