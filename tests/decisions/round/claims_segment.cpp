// A ball and an edge from p to q: a segment, or one of the three edges of a triangle.
//
// With A = |w|^2, B = w.d, C = |d|^2, w the centre less p, d = q - p, the point at s is p + s d, and its
// squared distance from the centre is f(s) = A - 2 s B + s^2 C.
#include "tests/decisions/round/facts.hpp"

namespace meetc::decisions_round {
namespace {

struct edge {
  std::string p, q;
  polynomial A, B, C;

  std::string name() const { return p + q; }
  polynomial reach(const polynomial &s) const { return A - 2 * (s * B) + s * s * C; }
};

// A hit by the way of the edge: the foot of the perpendicular lies between the ends and is within reach.
void add_hits(const decision &d, const edge &e, std::vector<claim> &out) {
  const way *w = d.find("edge " + e.name());
  if (!w)
    return; // a missing way gives no hit
  const gram &g = gram::ring();
  const std::string between = e.name() + " between", close = e.name() + " close";
  const fact length = at_least("length", e.C);
  out.push_back({"edge " + e.name() + " hit, yet the foot is not after " + e.p,
                 with(d, *w, {length, at_least("before", -e.B)}),
                 {{1, {between}}, {1, {"before", "length"}}, {1, {}, e.B}},
                 {}});
  out.push_back({"edge " + e.name() + " hit, yet the foot is not before " + e.q,
                 with(d, *w, {length, at_least("beyond", e.B - e.C)}),
                 {{1, {between}}, {1, {"beyond", "length"}}, {1, {}, e.B - e.C}},
                 {}});
  const polynomial foot = g.s * e.C - e.B;
  out.push_back({"edge " + e.name() + " hit, yet the foot is out of reach",
                 with(d, *w, {above("length", e.C), equal("foot", foot), above("out", e.reach(g.s) - g.R)}),
                 {{1, {"out", "length"}}, {1, {close}}},
                 {{"foot", -foot}}});
}

// If a point of the edge is within reach, the way of an end or of the edge hits.
void add_misses(const decision &d, const edge &e, std::vector<claim> &out) {
  const gram &g = gram::ring();
  const polynomial rest = g.one - g.s;
  const auto given = [&](std::vector<fact> more) {
    std::vector<fact> all = {at_least("length", e.C), at_least("s", g.s), at_least("1-s", rest),
                             at_least("within", g.R - e.reach(g.s))};
    all.insert(all.end(), more.begin(), more.end());
    add_failure(d, "corner " + e.p, all);
    add_failure(d, "corner " + e.q, all);
    return all;
  };
  const std::string within = "a point of edge " + e.name() + " within reach";
  out.push_back({within + ", the foot not after " + e.p,
                 given({at_least("before", -e.B)}),
                 {{1, {"not " + e.p + " near"}}, {1, {"within"}}, {2, {"s", "before"}}, {1, {"length"}, g.s}},
                 {}});
  out.push_back({within + ", the foot not before " + e.q,
                 given({at_least("beyond", e.B - e.C)}),
                 {{1, {"not " + e.q + " near"}}, {1, {"within"}}, {2, {"1-s", "beyond"}}, {1, {"length"}, rest}},
                 {}});
  const std::string close = e.name() + " close", between = e.name() + " between";
  add_failures(d, "edge " + e.name(), within + ", the foot between",
               given({above("after", e.B), above("ahead", e.C - e.B)}), out, [&](const std::string &literal, claim &c) {
                 if (literal == close)
                   c.products = {{1, {"not " + close}}, {1, {"length", "within"}}, {1, {}, e.B - g.s * e.C}};
                 else if (literal == between)
                   c.products = {{1, {"not " + between}}, {1, {"after", "ahead"}}};
               });
}

std::vector<claim> edge_claims(const decision &d, const std::vector<edge> &edges) {
  std::vector<claim> out;
  for (const edge &e : edges) {
    add_hits(d, e, out);
    add_misses(d, e, out);
  }
  return out;
}

edge first_edge() {
  const gram &g = gram::ring();
  return {"a", "b", g.ww, g.w1, g.g11};
}

} // namespace

std::vector<claim> corner_claims(const decision &d) {
  const gram &g = gram::ring();
  std::vector<claim> out;
  for (const auto &[name, distance] : {std::pair("a", g.ww), std::pair("b", g.wb), std::pair("c", g.wc)})
    if (const way *w = d.find(std::string("corner ") + name))
      out.push_back({std::string("corner ") + name + " hit, yet out of reach",
                     with(d, *w, {above("out", distance - g.R)}),
                     {{1, {std::string(name) + " near"}}, {1, {"out"}}},
                     {}});
  return out;
}

std::vector<claim> segment_claims(const decision &d) {
  return edge_claims(d, {first_edge()});
}

std::vector<claim> triangle_edge_claims(const decision &d) {
  const gram &g = gram::ring();
  return edge_claims(d, {first_edge(), {"b", "c", g.wb, g.w3, g.g33}, {"a", "c", g.ww, g.w2, g.g22}});
}

std::vector<claim> far_claims(const decision &d, bool triangle) {
  const gram &g = gram::ring();
  struct corner {
    std::string name;
    polynomial weight, distance;
  };
  std::vector<corner> corners = {{"a", g.one - g.s, g.ww}, {"b", g.s, g.wb}};
  std::vector<product> spread = {{1, {"weight a", "weight b", "ab"}}};
  std::vector<fact> squares = {at_least("ab", g.g11)};
  polynomial at = g.zero;
  if (triangle) {
    corners[0].weight = g.one - g.s - g.t;
    corners.push_back({"c", g.t, g.wc});
    spread.push_back({1, {"weight a", "weight c", "ac"}});
    spread.push_back({1, {"weight b", "weight c", "bc"}});
    squares.push_back(at_least("ac", g.g22));
    squares.push_back(at_least("bc", g.g33));
    at = g.t;
  }
  std::vector<claim> out;
  // Far enough by the decision: that corner is a point at R or more.
  std::vector<fact> all_inside;
  for (const corner &c : corners)
    all_inside.push_back(above(c.name + " inside", g.R - c.distance));
  if (d.far.empty() || !d.bounded_below)
    out.push_back({"no far corner, yet the decision asks for none", all_inside, {}, {}});
  for (const literal &l : d.far) {
    claim c{l.name + ", yet all corners are inside", all_inside, {{1, {l.name}}}, {}};
    c.facts.push_back(holds(d, l));
    c.products.push_back({1, {l.name.substr(0, 1) + " inside"}});
    out.push_back(c);
  }
  // A point at R or more, yet no corner: f is convex. One claim for each weight that may be the positive one.
  for (const corner &positive : corners) {
    claim c{"a point far, yet no corner; of " + positive.name + " a part", squares, spread, {}};
    c.facts.push_back(at_least("far point", g.reach(g.s, at) - g.R));
    c.products.push_back({1, {"far point"}});
    for (const corner &each : corners) {
      const bool strict = each.name == positive.name;
      c.facts.push_back({"weight " + each.name, each.weight, strict ? relation::above : relation::at_least});
      c.products.push_back({1, {"weight " + each.name, "not " + each.name + " far"}});
    }
    for (const literal &l : d.far)
      c.facts.push_back(fails(d, l));
    out.push_back(c);
  }
  return out;
}

} // namespace meetc::decisions_round
