// A ball and a triangle's face. The foot is the centre's projection on the plane; its weights of a, b and c,
// times the squared double area N, are ma, mb and mc, and ma + mb + mc = N.
#include "tests/decisions/round/facts.hpp"

namespace meetc::decisions_round {
namespace {

struct corner {
  std::string name;
  polynomial weight, foot; // of the point at (s, t); of the foot, times N
};
std::vector<corner> corners() {
  const gram &g = gram::ring();
  return {{"a", g.one - g.s - g.t, g.ma}, {"b", g.s, g.mb}, {"c", g.t, g.mc}};
}

// A hit by the way of the face: the foot is a point of the triangle and is within reach.
void add_hits(const decision &d, std::vector<claim> &out) {
  const gram &g = gram::ring();
  if (const way *w = d.find("reversed face")) // no foot lies on the wrong side of all three edges
    out.push_back({"reversed face hit",
                   with(d, *w, {at_least("area", g.area)}),
                   {{1, {"a inside"}}, {1, {"b inside"}}, {1, {"c inside"}}, {1, {"area"}}},
                   {}});
  const way *w = d.find("face");
  if (!w)
    return;
  out.push_back({"face hit, yet no area",
                 with(d, *w, {at_least("flat", -g.area)}),
                 {{1, {"a inside"}}, {1, {"b inside"}}, {1, {"c inside"}}, {1, {"flat"}}},
                 {}});
  const fact area = above("area", g.area);
  const polynomial at_s = g.area * g.s - g.mb, at_t = g.area * g.t - g.mc;
  const std::vector<fact> foot = {area, equal("foot s", at_s), equal("foot t", at_t)};
  for (const corner &c : corners()) {
    claim k{"face hit, yet the foot's weight of " + c.name + " is not positive",
            with(d, *w, foot),
            {{1, {c.name + " inside"}}, {1, {"area", "no weight"}}},
            {}};
    k.facts.push_back(at_least("no weight", -c.weight));
    if (c.name != "c")
      k.equations.push_back({"foot s", c.name == "a" ? -g.one : g.one});
    if (c.name != "b")
      k.equations.push_back({"foot t", c.name == "a" ? -g.one : g.one});
    out.push_back(k);
  }
  claim k{"face hit, yet the foot is out of reach",
          with(d, *w, foot),
          {{1, {"out", "area", "area"}}, {1, {"area", "face close"}}},
          {{"foot s", -(g.g11 * at_s + 2 * (g.g12 * at_t))}, {"foot t", -(g.g22 * at_t)}}};
  k.facts.push_back(above("out", g.reach(g.s, g.t) - g.R));
  out.push_back(k);
}

// If a point of the triangle is within reach and the foot is inside, the way of the face hits.
void add_misses(const decision &d, std::vector<claim> &out) {
  const gram &g = gram::ring();
  const polynomial at_s = g.area * g.s - g.mb, at_t = g.area * g.t - g.mc;
  std::vector<fact> given = {above("area", g.area), above("length", g.g11),
                             at_least("within", g.R - g.reach(g.s, g.t))};
  for (const corner &c : corners()) {
    given.push_back(above("foot " + c.name, c.foot));
    given.push_back(at_least("weight " + c.name, c.weight));
  }
  for (const char *name : {"a", "b", "c"})
    add_failure(d, std::string("corner ") + name, given);
  add_failures(d, "face", "a point of the triangle within reach, the foot inside", given, out,
               [&](const std::string &literal, claim &c) {
                 if (literal == "face close")
                   c.products = {{1, {"not face close", "area", "length"}},
                                 {1, {"within", "area", "area", "length"}},
                                 {1, {}, g.g11 * at_s + g.g12 * at_t},
                                 {1, {"area"}, at_t}};
                 else // "a inside" and the like
                   c.products = {{1, {"not " + literal}}, {1, {"foot " + literal.substr(0, 1)}}};
               });
}

// Facts about the triangle that do not depend on the decision.
void add_geometry(std::vector<claim> &out) {
  const gram &g = gram::ring();
  out.push_back({"area, yet a first edge without length",
                 {above("area", g.area), at_least("other", g.g22), at_least("none", -g.g11)},
                 {{1, {"area"}}, {1, {"none", "other"}}, {1, {}, g.g12}},
                 {}});
  // (l1, l2) is the foot: w - l1 d1 - l2 d2 is at right angles to d1 and d2. The point is the part tau of the
  // way from (s, t) to it.
  const polynomial u = g.s - g.l1, v = g.t - g.l2;
  const polynomial nearer = g.reach(g.s - g.tau * u, g.t - g.tau * v);
  const product along{1, {"tau"}, g.g11 * u + g.g12 * v}, across{1, {"tau", "area"}, v};
  const auto again = [](product p) {
    p.of.insert(p.of.begin(), "1-tau");
    return p;
  };
  out.push_back({"on the way to the foot, yet further from the centre",
                 {above("area", g.area), above("length", g.g11), at_least("tau", g.tau),
                  at_least("1-tau", g.one - g.tau), equal("foot 1", g.w1 - g.l1 * g.g11 - g.l2 * g.g12),
                  equal("foot 2", g.w2 - g.l1 * g.g12 - g.l2 * g.g22), above("farther", nearer - g.reach(g.s, g.t))},
                 {{1, {"farther", "length"}}, along, again(along), across, again(across)},
                 {{"foot 1", -2 * (g.g11 * g.tau * u)}, {"foot 2", -2 * (g.g11 * g.tau * v)}}});
}

} // namespace

std::vector<claim> triangle_claims(const decision &d) {
  std::vector<claim> out = triangle_edge_claims(d);
  add_hits(d, out);
  add_misses(d, out);
  add_geometry(out);
  return out;
}

} // namespace meetc::decisions_round
