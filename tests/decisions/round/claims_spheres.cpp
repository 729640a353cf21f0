// Two spheres or balls, and a sphere and a point. The squared distance dd and the squared radius R
// are written out, as d d and r1 r1, since here d and the radii themselves are compared.
#include "tests/decisions/round/facts.hpp"

namespace meetc::decisions_round {
namespace {

polynomial written_out(const polynomial &p) {
  const gram &g = gram::ring();
  std::vector<polynomial> images;
  for (int v = 0; v < g.numbers.size(); ++v)
    images.push_back(polynomial::variable(g.numbers, v));
  images[static_cast<std::size_t>(g.numbers.find("dd"))] = square(g.d);
  images[static_cast<std::size_t>(g.numbers.find("R"))] = square(g.r1);
  return p.substitute(images, g.numbers);
}

std::vector<fact> lengths() {
  const gram &g = gram::ring();
  return {at_least("d", g.d), at_least("r1", g.r1), at_least("r2", g.r2)};
}

} // namespace

std::vector<claim> sphere_claims(const decision &any, bool surface) {
  const gram &g = gram::ring();
  decision d = any;
  for (polynomial &p : d.atoms)
    p = written_out(p);
  std::vector<claim> out;
  const polynomial sum = g.r1 + g.r2, difference = g.r1 - g.r2;
  const way &touch = d.near.front();
  {
    claim c{"hit, yet apart", with(d, touch, lengths()), {}, {}};
    c.facts.push_back(above("gap", g.d - sum));
    c.products = {{1, {"reach"}}, {1, {"gap", "gap"}}, {2, {"gap", "r1"}}, {2, {"gap", "r2"}}};
    if (surface) // with v0 = gap^2 + 2 gap (r1 + r2) and v1 = v0 + 4 r1 r2, v0 v1 = v0^2 + 4 r1 r2 v0 written
                 // out
      c.products = {{1, {"reach"}},
                    {1, {"gap", "gap", "gap", "gap"}},
                    {4, {"gap", "gap", "gap", "r1"}},
                    {4, {"gap", "gap", "gap", "r2"}},
                    {4, {"gap", "gap", "r1", "r1"}},
                    {12, {"gap", "gap", "r1", "r2"}},
                    {4, {"gap", "gap", "r2", "r2"}},
                    {8, {"gap", "r1", "r1", "r2"}},
                    {8, {"gap", "r1", "r2", "r2"}}};
    out.push_back(c);
  }
  std::vector<fact> met = lengths();
  met.push_back(at_least("outer", sum - g.d));
  if (surface) {
    // With gap = r1 - r2 - d, v1 = -gap (gap + 2 d) and v0 = v1 - 4 r1 r2; and the same with r1 and r2
    // exchanged.
    for (const bool first : {true, false}) {
      claim c{first ? "hit, yet the second lies within the first" : "hit, yet the first lies within the second",
              with(d, touch, lengths()),
              {{1, {"reach"}},
               {1, {"gap", "gap", "gap", "gap"}},
               {4, {"gap", "gap", "gap", "d"}},
               {4, {"gap", "gap", "d", "d"}},
               {4, {"gap", "gap", "r1", "r2"}},
               {8, {"gap", "d", "r1", "r2"}}},
              {}};
      c.facts.push_back(above("gap", first ? difference - g.d : -difference - g.d));
      out.push_back(c);
    }
    met.push_back(at_least("inner", g.d - difference));
    met.push_back(at_least("other inner", g.d + difference));
  }
  add_failures(d, "touch", "the surfaces or balls meet", met, out, [&](const std::string &, claim &c) {
    if (surface) // v0 v1 = -(r1 + r2 - d) (r1 + r2 + d) (d - r1 + r2) (d + r1 - r2)
      c.products = {{1, {"not reach"}},
                    {1, {"outer", "inner", "other inner", "d"}},
                    {1, {"outer", "inner", "other inner", "r1"}},
                    {1, {"outer", "inner", "other inner", "r2"}}};
    else
      c.products = {{1, {"not reach"}}, {1, {"outer", "d"}}, {1, {"outer", "r1"}}, {1, {"outer", "r2"}}};
  });
  return out;
}

std::vector<claim> side_claims() {
  const gram &g = gram::ring();
  const polynomial value = written_out(stated_side());
  const std::vector<fact> lengths = {at_least("d", g.d), at_least("r", g.r1)};
  const auto given = [&](std::vector<fact> more) {
    more.insert(more.begin(), lengths.begin(), lengths.end());
    return more;
  };
  const fact within = above("within", g.r1 - g.d), beyond = above("beyond", g.d - g.r1);
  return {{"within the ball, yet the sign is not that",
           given({within, at_least("atom", value)}),
           {{1, {"atom"}}, {1, {"within", "within"}}, {2, {"within", "d"}}},
           {}},
          {"beyond the ball, yet the sign is not that",
           given({beyond, at_least("atom", -value)}),
           {{1, {"atom"}}, {1, {"beyond", "beyond"}}, {2, {"beyond", "r"}}},
           {}},
          {"on the sphere, yet the sign is positive",
           given({equal("on", g.d - g.r1), above("atom", value)}),
           {{1, {"atom"}}},
           {{"on", -(g.d + g.r1)}}},
          {"on the sphere, yet the sign is negative",
           given({equal("on", g.d - g.r1), above("atom", -value)}),
           {{1, {"atom"}}},
           {{"on", g.d + g.r1}}}};
}

} // namespace meetc::decisions_round
