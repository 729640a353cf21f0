// Signs that equal points decide. Where a point of one operand has the coordinates of a point of the other, some signs
// are zero whatever the other numbers are. Meshes are full of such pairs (neighbours share corners bit for bit), and no
// error bound can tell a true zero from a small number. These signs are found by substitution in the exact polynomials.
#include "gen/bound/bound.hpp"

#include <algorithm>
#include <map>

namespace meetc::bound {
namespace {
constexpr std::size_t most = 32; // the bits of one word

// The positions of both operands, as inputs by axis.
std::vector<std::vector<int>> positions(const subject &of) {
  std::map<std::pair<int, int>, std::vector<int>> groups;
  for (int v = 0; v < of.numbers.size(); ++v)
    if (const poly::stored_number &s = of.local.stored(v); s.position)
      groups[{s.operand, s.group}].push_back(v);
  std::vector<std::vector<int>> out;
  for (const auto &[at, inputs] : groups)
    out.push_back(inputs);
  return out;
}

poly::poly with_equal_points(const poly::poly &f, const coincidence &c, const poly::ring &numbers) {
  std::vector<poly::poly> images;
  for (int v = 0; v < numbers.size(); ++v) {
    const auto at = std::find(c.y.begin(), c.y.end(), v);
    images.push_back(
        poly::poly::variable(numbers, at == c.y.end() ? v : c.x[static_cast<std::size_t>(at - c.y.begin())]));
  }
  return f.substitute(images, numbers);
}

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

void find_coincidences(const subject &of, kernel_bounds &out) {
  out.axes = lone_axes(of);
  const auto points = positions(of);
  const auto to = out.stages();
  for (std::size_t s = 0; s < to.size(); ++s)
    to[s]->zero_if.assign(of.stages[s].signs.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size() && out.coincidences.size() < most; ++j) {
      const coincidence c{points[i], points[j]};
      bool used = false;
      for (std::size_t s = 0; s < to.size(); ++s)
        for (std::size_t k = 0; k < of.stages[s].signs.size(); ++k) {
          if (c.x.size() != c.y.size() || !with_equal_points(*of.stages[s].signs[k], c, of.numbers).is_zero())
            continue;
          to[s]->zero_if[k] |= std::uint32_t{1} << out.coincidences.size();
          used = true;
        }
      if (used)
        out.coincidences.push_back(c);
    }
}

} // namespace meetc::bound
