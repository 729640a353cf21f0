// Decisions with one mistake: a check that accepts one of them is useless.
#include "tests/decisions/round/decision.hpp"

#include <functional>
#include <stdexcept>

namespace meetc::decisions_round {
namespace {

constexpr int not_positive = 3;

way &way_of(decision &d, const std::string &name) {
  for (way &w : d.near)
    if (w.name == name)
      return w;
  throw std::invalid_argument(name);
}
literal &literal_of(decision &d, const std::string &name, const std::string &which) {
  for (literal &l : way_of(d, name).all)
    if (l.name == which)
      return l;
  throw std::invalid_argument(which);
}
void drop_way(decision &d, const std::string &name) {
  std::erase_if(d.near, [&](const way &w) { return w.name == name; });
}
void drop_literal(decision &d, const std::string &name, const std::string &which) {
  std::erase_if(way_of(d, name).all, [&](const literal &l) { return l.name == which; });
}
// Replaces <= 0 by < 0, < 0 by <= 0, and so on.
void turn_equality(literal &l) {
  l.mask ^= 2;
}
void turn_sign(literal &l) {
  l.mask = (l.mask & 2) | (l.mask & 1) << 2 | l.mask >> 2;
}

} // namespace

std::vector<mutant> mutants() {
  const gram &g = gram::ring();
  std::vector<mutant> out;
  const auto add = [&](const char *of, const char *what, const std::function<void(decision &)> &change) {
    decision d = stated(emitted_predicate(of));
    change(d);
    out.push_back({of, what, std::move(d)});
  };
  using D = decision &;
  add("ball_ball", "tangent balls miss", [](D d) { turn_equality(literal_of(d, "touch", "reach")); });
  add("ball_ball", "the difference of the radii for their sum", [&](D d) { d.atoms[0] = g.dd - square(g.r1 - g.r2); });
  add("ball_ball", "no product of the radii", [&](D d) { d.atoms[0] = g.dd - square(g.r1) - square(g.r2); });
  add("sphere_sphere", "tangent spheres miss", [](D d) { turn_equality(literal_of(d, "touch", "reach")); });
  add("sphere_sphere", "nested spheres hit", [](D d) { literal_of(d, "touch", "reach").atoms = {0}; });
  add("sphere_sphere", "the sign is turned", [](D d) { turn_sign(literal_of(d, "touch", "reach")); });

  add("ball_segment", "an end is forgotten", [](D d) { drop_way(d, "corner b"); });
  add("ball_segment", "an end on the surface misses", [](D d) { turn_equality(literal_of(d, "corner a", "a near")); });
  add("ball_segment", "the line for the segment", [](D d) { drop_literal(d, "edge ab", "ab between"); });
  add("ball_segment", "between includes the ends", [](D d) { turn_equality(literal_of(d, "edge ab", "ab between")); });
  add("ball_segment", "the line hits too", [](D d) {
    d.near.push_back({"line", {{"line close", {2}, not_positive}}});
  });
  add("ball_segment", "one end alone bounds the segment", [](D d) {
    literal_of(d, "edge ab", "ab between").atoms = {3}; // w.d > 0
  });
  add("ball_segment", "a tangent line misses", [](D d) { turn_equality(literal_of(d, "edge ab", "ab close")); });
  add("ball_segment", "the squared radius with the wrong sign",
      [&](D d) { d.atoms[2] = g.ww * g.g11 - square(g.w1) + g.R * g.g11; });
  add("ball_segment", "only the ends", [](D d) { drop_way(d, "edge ab"); });
  add("sphere_segment", "no bound from below", [](D d) { d.far.clear(), d.bounded_below = false; });
  add("sphere_segment", "one end alone may be far", [](D d) { d.far.pop_back(); });
  add("sphere_segment", "an end on the surface is not far", [](D d) { turn_equality(d.far.front()); });

  add("ball_triangle", "a corner is forgotten", [](D d) { drop_way(d, "corner c"); });
  add("ball_triangle", "an edge is forgotten", [](D d) { drop_way(d, "edge bc"); });
  add("ball_triangle", "the line for an edge", [](D d) { drop_literal(d, "edge ac", "ac between"); });
  add("ball_triangle", "the face is forgotten", [](D d) { drop_way(d, "face"); });
  add("ball_triangle", "the plane for the face", [](D d) { way_of(d, "face").all.resize(1); });
  add("ball_triangle", "one side of the face is open", [](D d) { drop_literal(d, "face", "b inside"); });
  add("ball_triangle", "a side of the face is turned", [](D d) { turn_sign(literal_of(d, "face", "b inside")); });
  add("ball_triangle", "the face includes its rim", [](D d) {
    for (const char *name : {"face", "reversed face"})
      for (std::size_t i = 1; i < 4; ++i)
        turn_equality(way_of(d, name).all[i]);
  });
  add("ball_triangle", "a tangent face misses", [](D d) { turn_equality(literal_of(d, "face", "face close")); });
  add("ball_triangle", "the squared radius with the wrong sign", [&](D d) { d.atoms[12] = g.volume + g.R * g.area; });
  add("sphere_triangle", "no bound from below", [](D d) { d.far.clear(), d.bounded_below = false; });
  add("sphere_triangle", "two corners alone may be far", [](D d) { d.far.pop_back(); });
  return out;
}

} // namespace meetc::decisions_round
