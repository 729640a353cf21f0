// What equal points decide: where a point of the operands has the coordinates of another, some signs are zero
// whatever the rest is. Meshes are full of such pairs (neighbours share corners bit for bit), and no error bound can
// tell a true zero from a small number. Found by substitution in the exact polynomials.
#include "gen/bound/bound.hpp"

#include <algorithm>
#include <map>

namespace meetc::bound {
namespace {
constexpr std::size_t most = 32; // they are bits of one word

// The positions of both operands: inputs by axis.
std::vector<std::vector<int>> positions(const lower::predicate &p) {
  std::map<std::pair<int, int>, std::vector<int>> groups;
  for (int v = 0; v < p.numbers->size(); ++v)
    if (const poly::stored_number &s = p.local->stored(v); s.position)
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

// -1 for the inputs that some stage reads outside of a difference along their axis.
std::vector<int> lone_axes(const lower::predicate &p) {
  std::vector<int> axes;
  for (int v = 0; v < p.numbers->size(); ++v) {
    const poly::stored_number &s = p.local->stored(v);
    axes.push_back(s.position ? s.axis : -1);
  }
  for (const lower::stage *s : {&p.reject, &p.common, &p.rare})
    for (const ir::node_id id : ir::needed(s->code.nodes, s->code.results)) {
      const ir::node &n = s->code.nodes.at(id);
      const auto axis = [&](ir::node_id i) -> int & { return axes[static_cast<std::size_t>(s->code.nodes.at(i).a)]; };
      const auto l = leaf_at(s->code, id);
      if (l && l->subtrahend >= 0 && axis(n.a) == axis(n.b))
        continue;
      for (const ir::node_id operand : {n.a, n.b, n.c})
        if (n.kind != ir::op::input && n.kind != ir::op::constant && operand >= 0 &&
            s->code.nodes.at(operand).kind == ir::op::input)
          axis(operand) = -1;
    }
  for (const lower::stage *s : {&p.reject, &p.common, &p.rare})
    for (const ir::node_id r : s->code.results)
      if (s->code.nodes.at(r).kind == ir::op::input)
        axes[static_cast<std::size_t>(s->code.nodes.at(r).a)] = -1;
  return axes;
}
} // namespace

void find_coincidences(const lower::predicate &p, kernel_bounds &out) {
  out.axes = lone_axes(p);
  const auto points = positions(p);
  const struct {
    const lower::stage &from;
    stage_bounds &to;
  } stages[] = {{p.reject, out.reject}, {p.common, out.common}, {p.rare, out.rare}};
  for (const auto &s : stages)
    s.to.zero_if.assign(s.from.atoms.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size() && out.coincidences.size() < most; ++j) {
      const coincidence c{points[i], points[j]};
      bool used = false;
      for (const auto &s : stages)
        for (std::size_t k = 0; k < s.from.atoms.size(); ++k) {
          const poly::poly &f = p.signs.atoms()[static_cast<std::size_t>(s.from.atoms[k])];
          if (c.x.size() != c.y.size() || !with_equal_points(f, c, *p.numbers).is_zero())
            continue;
          s.to.zero_if[k] |= std::uint32_t{1} << out.coincidences.size();
          used = true;
        }
      if (used)
        out.coincidences.push_back(c);
    }
}

} // namespace meetc::bound
