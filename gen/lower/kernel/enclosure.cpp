// Bounded kinds: where the hull, the pad and the rule are in the stored row.
#include "gen/lower/kernel/kernel.hpp"

#include <fmt/format.h>

namespace meetc::lower {

enclosure enclosing(const lower::model &m, const lang::kind &k) {
  enclosure out;
  const stored_ring stored = stored_numbers(m, {"k"}, {&k});
  lower::decision unused;
  lower::expander expand(m, *stored.numbers, unused);
  const lower::value self = expand.operand(k, "k.");
  lower::environment env;
  const auto &object = *std::get<std::shared_ptr<const lower::object>>(self.is);
  for (std::size_t i = 0; i < k.store.size(); ++i)
    env.emplace_back(k.store[i].name, object.fields[i]);
  const auto add_point = [&](const lower::object &p, const location &where) {
    if (!p.kind->position)
      throw spec_error(where, fmt::format("a hull is made of points, not of a {}", p.kind->name));
    std::vector<int> axes;
    for (const lower::value &f : p.fields)
      axes.push_back(input_of(f, "a hull's coordinate", where));
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
      out.mixes_points = out.mixes_points || axes[axis] != axes[0] + static_cast<int>(axis);
    out.hull.push_back(std::move(axes));
  };
  if (k.position)
    add_point(object, k.where);
  if (k.hull) {
    const lower::value hull = expand.evaluate(*k.hull, env);
    const auto *points = std::get_if<std::shared_ptr<const lower::list>>(&hull.is);
    if (!points)
      throw spec_error(k.hull->where, "a hull is a list of points, as in '[p, q]'");
    for (const lower::value &p : **points) {
      const auto *o = std::get_if<std::shared_ptr<const lower::object>>(&p.is);
      if (!o)
        throw spec_error(k.hull->where, "a hull is a list of points, as in '[p, q]'");
      add_point(**o, k.hull->where);
    }
  }
  if (k.pad)
    out.pad = input_of(expand.evaluate(*k.pad, env), "a pad", k.pad->where);
  out.rule = rule_of(m, k);
  return out;
}

} // namespace meetc::lower
