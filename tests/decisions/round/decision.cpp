#include "tests/decisions/round/decision.hpp"

#include <algorithm>

namespace meetc::decisions_round {
namespace {

constexpr int negative = 1, not_positive = 3, positive = 4, not_negative = 6;

void add_corner(decision &d, const std::string &name, int atom, bool surface) {
  d.near.push_back({"corner " + name, {{name + " near", {atom}, not_positive}}});
  if (surface)
    d.far.push_back({name + " far", {atom}, not_negative});
}
void add_edge(decision &d, const std::string &name, int close, int end, int other_end) {
  d.near.push_back(
      {"edge " + name, {{name + " close", {close}, not_positive}, {name + " between", {end, other_end}, negative}}});
}

// The distance of two spheres, from outside and from inside.
polynomial outside(const gram &g) {
  return g.dd - square(g.r1 + g.r2);
}
polynomial inside(const gram &g) {
  return g.dd - square(g.r1 - g.r2);
}

decision of_spheres(bool surface) {
  const gram &g = gram::ring();
  decision d;
  d.atoms = {outside(g)};
  d.near = {{"touch", {{"reach", {0}, not_positive}}}};
  if (surface) {
    d.atoms.push_back(inside(g));
    d.near = {{"touch", {{"reach", {0, 1}, not_positive}}}};
  }
  return d;
}

decision of_segment(bool surface) {
  const gram &g = gram::ring();
  decision d;
  d.bounded_below = surface;
  d.atoms = {g.ww - g.R, g.wb - g.R, g.ww * g.g11 - square(g.w1) - g.R * g.g11, -g.w1, g.g11 - g.w1};
  add_corner(d, "a", 0, surface);
  add_corner(d, "b", 1, surface);
  add_edge(d, "ab", 2, 3, 4);
  return d;
}

decision of_triangle(bool surface) {
  const gram &g = gram::ring();
  decision d;
  d.bounded_below = surface;
  d.atoms = {g.ww - g.R,
             g.wb - g.R,
             g.wc - g.R,
             g.ww * g.g11 - square(g.w1) - g.R * g.g11,
             -g.w1,
             g.g11 - g.w1,
             g.wb * g.g33 - square(g.w3) - g.R * g.g33,
             -g.w3,
             g.g33 - g.w3,
             g.ww * g.g22 - square(g.w2) - g.R * g.g22,
             g.g22 - g.w2,
             -g.w2,
             g.volume - g.R * g.area,
             g.mc,
             g.ma,
             -g.mb};
  add_corner(d, "a", 0, surface);
  add_corner(d, "b", 1, surface);
  add_corner(d, "c", 2, surface);
  add_edge(d, "ab", 3, 4, 5);
  add_edge(d, "bc", 6, 7, 8);
  add_edge(d, "ac", 9, 10, 11);
  d.near.push_back({"face",
                    {{"face close", {12}, not_positive},
                     {"a inside", {14}, positive},
                     {"b inside", {15}, negative},
                     {"c inside", {13}, positive}}});
  d.near.push_back({"reversed face",
                    {{"face close", {12}, not_positive},
                     {"a inside", {14}, negative},
                     {"b inside", {15}, positive},
                     {"c inside", {13}, negative}}});
  return d;
}

bool passes(const literal &l, const std::vector<int> &signs) {
  int s = 1;
  for (const int a : l.atoms)
    s *= signs[static_cast<std::size_t>(a)];
  return (l.mask >> (s + 1) & 1) != 0;
}

} // namespace

const way *decision::find(const std::string &name) const {
  const auto it = std::find_if(near.begin(), near.end(), [&](const way &w) { return w.name == name; });
  return it == near.end() ? nullptr : &*it;
}

decision::inequality decision::holds(const literal &l) const {
  polynomial p = gram::ring().one;
  for (const int a : l.atoms)
    p = p * atoms[static_cast<std::size_t>(a)];
  const bool below = (l.mask & negative) != 0;
  return {below ? -p : p, (l.mask & 2) == 0};
}
decision::inequality decision::fails(const literal &l) const {
  literal opposite = l;
  opposite.mask = 7 & ~l.mask;
  return holds(opposite);
}

bool decision::hit(const std::vector<int> &signs) const {
  const auto all = [&](const way &w) {
    return std::all_of(w.all.begin(), w.all.end(), [&](const literal &l) { return passes(l, signs); });
  };
  return std::any_of(near.begin(), near.end(), all) &&
         (!bounded_below || std::any_of(far.begin(), far.end(), [&](const literal &l) { return passes(l, signs); }));
}

std::uint64_t decision::hits(const std::vector<std::uint64_t> &below, const std::vector<std::uint64_t> &above) const {
  const auto cases = [&](const literal &l) {
    std::uint64_t n = 0, p = ~std::uint64_t{0};
    for (const int a : l.atoms) {
      const std::uint64_t an = below[static_cast<std::size_t>(a)], ap = above[static_cast<std::size_t>(a)];
      const std::uint64_t product = (n & ap) | (p & an);
      p = (n & an) | (p & ap);
      n = product;
    }
    return (l.mask & 1 ? n : 0) | (l.mask & 2 ? ~(n | p) : 0) | (l.mask & 4 ? p : 0);
  };
  std::uint64_t any_near = 0, any_far = bounded_below ? 0 : ~std::uint64_t{0};
  for (const way &w : near) {
    std::uint64_t all = ~std::uint64_t{0};
    for (const literal &l : w.all)
      all &= cases(l);
    any_near |= all;
  }
  for (const literal &l : far)
    any_far |= cases(l);
  return any_near & any_far;
}

decision stated(const emitted &e) {
  return e.second == other::sphere    ? of_spheres(e.surface)
         : e.second == other::segment ? of_segment(e.surface)
                                      : of_triangle(e.surface);
}

polynomial stated_side() {
  const gram &g = gram::ring();
  return g.dd - g.R;
}

} // namespace meetc::decisions_round
