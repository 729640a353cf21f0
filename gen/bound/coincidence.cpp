// Signs that equal points decide. Where a point of one operand has the coordinates of a point of the other, some signs
// are zero whatever the other numbers are. Meshes are full of such pairs (neighbours share corners bit for bit), and no
// error bound can tell a true zero from a small number. These signs are found by substitution in the exact polynomials.
#include "gen/bound/bound.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace meetc::bound {
namespace {
// -1 for inputs that some stage uses outside a difference along their axis.
std::vector<int> lone_axes(const subject &of) {
  std::vector<int> axes;
  for (int v = 0; v < of.numbers.size(); ++v) {
    const poly::stored_number &s = of.local.stored(v);
    axes.push_back(s.position ? s.axis : -1);
  }
  for (const subject::stage &s : of.stages) {
    if (s.signs.empty())
      continue;
    const ir::arena &nodes = s.code->nodes;
    const auto axis = [&](ir::node_id i) -> int & { return axes[static_cast<std::size_t>(nodes.at(i).a)]; };
    const auto lone = [&](ir::node_id i) {
      if (nodes.at(i).kind == ir::op::input)
        axis(i) = -1;
    };
    for (const ir::node_id id : ir::needed(nodes, s.code->results)) {
      const ir::node &n = nodes.at(id);
      const auto l = leaf_at(nodes, id);
      if (l && l->subtrahend >= 0 && axis(n.a) == axis(n.b))
        continue;
      for (const ir::node_id operand : ir::operands(n))
        lone(operand);
    }
    for (const ir::node_id r : s.code->results)
      lone(r);
  }
  return axes;
}
} // namespace

std::vector<coincidence> pairs_of_points(const poly::local_origin &local) {
  std::map<std::pair<int, int>, std::vector<int>> points; // by operand and group
  for (int v = 0; v < local.base().size(); ++v)
    if (const poly::stored_number &s = local.stored(v); s.position)
      points[{s.operand, s.group}].push_back(v);
  std::vector<coincidence> out;
  for (auto x = points.begin(); x != points.end(); ++x)
    for (auto y = std::next(x); y != points.end(); ++y)
      if (x->second.size() == y->second.size())
        out.push_back({x->second, y->second});
  return out;
}

poly::poly with_equal_points(const poly::poly &f, const std::vector<coincidence> &all) {
  // The inputs of a point that equals others become those of the first of them.
  std::vector<int> first(static_cast<std::size_t>(f.in().size()));
  std::iota(first.begin(), first.end(), 0);
  for (const coincidence &c : all)
    for (std::size_t axis = 0; axis < c.x.size(); ++axis) {
      const auto [low, high] =
          std::minmax(first[static_cast<std::size_t>(c.x[axis])], first[static_cast<std::size_t>(c.y[axis])]);
      std::replace(first.begin(), first.end(), int{high}, int{low});
    }
  const std::vector<int> used = f.variables();
  if (std::all_of(used.begin(), used.end(), [&](int v) { return first[static_cast<std::size_t>(v)] == v; }))
    return f;
  return f.renamed(first, f.in());
}

void find_coincidences(const subject &of, kernel_bounds &out) {
  out.axes = lone_axes(of);
  const auto to = out.stages();
  for (std::size_t s = 0; s < to.size(); ++s)
    to[s]->zero_if.assign(of.stages[s].signs.size(), 0);
  for (const coincidence &c : pairs_of_points(of.local)) {
    if (out.coincidences.size() == most_coincidences)
      return;
    bool used = false;
    for (std::size_t s = 0; s < to.size(); ++s)
      for (std::size_t k = 0; k < of.stages[s].signs.size(); ++k) {
        if (!with_equal_points(*of.stages[s].signs[k], {c}).is_zero())
          continue;
        to[s]->zero_if[k] |= std::uint32_t{1} << out.coincidences.size();
        used = true;
      }
    if (used)
      out.coincidences.push_back(c);
  }
}

} // namespace meetc::bound
