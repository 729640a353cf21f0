// Polygons of every shape against an oracle in integers: a point of the plane is in a polygon if it is on an edge or if the
// polygon winds around it.
#include "tests/catch.hpp"

#include "meet/io/polygon/triangulate.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace {

struct point {
  long x, y;
  bool operator==(const point &) const = default;
};
using polygon = std::vector<point>;

long turn(point a, point b, point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
int sign(long n) {
  return (n > 0) - (n < 0);
}
bool on_segment(point a, point b, point p) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}
bool on_edge(const polygon &g, point p) {
  for (std::size_t i = 0; i < g.size(); ++i)
    if (on_segment(g[i], g[(i + 1) % g.size()], p))
      return true;
  return false;
}
int winding(const polygon &g, point p) {
  int w = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const point a = g[i], b = g[(i + 1) % g.size()];
    if (a.y <= p.y && b.y > p.y && turn(a, b, p) > 0)
      ++w;
    if (a.y > p.y && b.y <= p.y && turn(a, b, p) < 0)
      --w;
  }
  return w;
}
long area(const polygon &g) {
  long sum = 0;
  for (std::size_t i = 0; i < g.size(); ++i)
    sum += g[i].x * g[(i + 1) % g.size()].y - g[i].y * g[(i + 1) % g.size()].x;
  return sum;
}
bool in_triangle(point a, point b, point c, point p) {
  if (turn(a, b, c) == 0)
    return on_segment(a, b, p) || on_segment(b, c, p) || on_segment(c, a, p);
  const int s = sign(turn(a, b, c));
  return sign(turn(a, b, p)) * s >= 0 && sign(turn(b, c, p)) * s >= 0 && sign(turn(c, a, p)) * s >= 0;
}
bool segments_meet(point a, point b, point c, point d) {
  if (on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b))
    return true;
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

class dice {
public:
  explicit dice(std::uint32_t seed) : engine_(seed) {}
  long below(long n) { return static_cast<long>(engine_() % static_cast<unsigned long>(n)); }
  std::size_t index(std::size_t n) { return engine_() % n; }

private:
  std::mt19937 engine_;
};

constexpr long side = 12; // of the lattice

// Grown from a triangle by corners whose two edges meet no other.
polygon simple(dice &roll, std::size_t corners) {
  polygon g;
  do
    g = {{roll.below(side), roll.below(side)},
         {roll.below(side), roll.below(side)},
         {roll.below(side), roll.below(side)}};
  while (area(g) == 0);
  for (int tries = 0; g.size() < corners && tries < 400; ++tries) {
    const std::size_t i = roll.index(g.size()), j = (i + 1) % g.size();
    const point p{roll.below(side), roll.below(side)};
    bool free = !on_edge(g, p);
    for (std::size_t k = 0; free && k < g.size(); ++k) {
      const point a = g[k], b = g[(k + 1) % g.size()];
      if (k == i)
        continue;
      free = (a == g[i] || b == g[i]) ? !on_segment(g[i], p, a == g[i] ? b : a) && !on_segment(a, b, p)
                                      : !segments_meet(g[i], p, a, b);
      free =
          free && ((a == g[j] || b == g[j]) ? !on_segment(g[j], p, a == g[j] ? b : a) : !segments_meet(g[j], p, a, b));
    }
    if (free)
      g.insert(g.begin() + static_cast<std::ptrdiff_t>(i) + 1, p);
  }
  return g;
}

// A hole of three corners in general position, if one fits, joined by a bridge that meets no edge on its way.
void add_hole(polygon &g, dice &roll) {
  for (int tries = 0; tries < 200; ++tries) {
    const point c{roll.below(side), roll.below(side)};
    polygon hole{c, {c.x + 1 + roll.below(2), c.y}, {c.x, c.y + 1 + roll.below(2)}};
    if ((area(hole) > 0) == (area(g) > 0))
      std::swap(hole[1], hole[2]);
    const int inside = sign(area(g));
    bool free = true;
    for (std::size_t k = 0; free && k < g.size(); ++k)
      for (std::size_t i = 0; free && i < 3; ++i)
        free = !segments_meet(hole[i], hole[(i + 1) % 3], g[k], g[(k + 1) % g.size()]) && winding(g, hole[i]) == inside;
    if (!free)
      continue;
    const std::size_t at = roll.index(g.size()), start = roll.index(3);
    const point from = g[at], to = hole[start];
    for (std::size_t k = 0; free && k < g.size(); ++k) {
      const point a = g[k], b = g[(k + 1) % g.size()];
      free =
          a == from || b == from ? !on_segment(from, to, a == from ? b : a) || a == b : !segments_meet(from, to, a, b);
    }
    for (std::size_t i = 0; free && i < 3; ++i)
      free = i == start || !on_segment(from, to, hole[i]);
    if (free && segments_meet(from, to, hole[(start + 1) % 3], hole[(start + 2) % 3]))
      free = false;
    // The bridge must leave its corner into the inside.
    const point middle2{from.x + to.x, from.y + to.y};
    polygon twice = g;
    for (point &p : twice)
      p = {2 * p.x, 2 * p.y};
    if (!free || on_edge(twice, middle2) || winding(twice, middle2) != inside)
      continue;
    polygon joined(g.begin(), g.begin() + static_cast<std::ptrdiff_t>(at) + 1);
    for (std::size_t i = 0; i <= 3; ++i)
      joined.push_back(hole[(start + i) % 3]);
    joined.insert(joined.end(), g.begin() + static_cast<std::ptrdiff_t>(at), g.end());
    g = joined;
    return;
  }
}

void decorate(polygon &g, dice &roll) {
  for (long n = roll.below(4); n > 0; --n) {
    const std::size_t i = roll.index(g.size());
    const auto after = g.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const point a = g[i], b = g[(i + 1) % g.size()];
    switch (roll.below(3)) {
    case 0: // a repeated corner
      g.insert(after, a);
      break;
    case 1: { // a spike
      const point tip{roll.below(side), roll.below(side)};
      g.insert(after, {tip, a});
      break;
    }
    default: { // corners along an edge
      const long d = std::gcd(b.x - a.x, b.y - a.y);
      if (d > 1)
        g.insert(after, {a.x + (b.x - a.x) / d, a.y + (b.y - a.y) / d});
    }
    }
  }
}

struct cut {
  std::vector<std::uint32_t> index;
  bool crossing = false;
};

// Cuts it in a plane that is not along the axes, but whose lattice float32 holds.
cut cut_of(const polygon &g, const long (&u)[3], const long (&v)[3]) {
  meetc::io::element_set set;
  meetc::io::vertex_lists faces;
  for (std::size_t i = 0; i < g.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      set.data.push_back(static_cast<float>(g[i].x * u[k] + g[i].y * v[k] + 100));
    faces.vertices.push_back(static_cast<std::uint32_t>(i));
  }
  faces.end_list(g.size());
  meetc::io::cut_polygons("test", std::move(faces), 1, set);
  cut out;
  out.index = set.index.empty() ? std::vector<std::uint32_t>{} : set.index;
  for (const std::string &note : set.notes) {
    CHECK(note.find("not planar") == std::string::npos);
    out.crossing = out.crossing || note.find("crosses itself") != std::string::npos;
  }
  return out;
}

// Whether the triangles are the polygon's closed set, at all points of a lattice twice as fine. `inside`: the sign of the
// winding numbers that count.
bool covers(const polygon &g, const cut &c, int inside) {
  if (c.index.size() != 3 * (g.size() - 2))
    return false;
  polygon fine;
  for (const point p : g)
    fine.push_back({2 * p.x, 2 * p.y});
  for (long x = -1; x <= 2 * side; ++x)
    for (long y = -1; y <= 2 * side; ++y) {
      const point p{x, y};
      const bool want = on_edge(fine, p) || winding(fine, p) * inside > 0;
      bool found = false;
      for (std::size_t t = 0; !found && t < c.index.size(); t += 3)
        found = in_triangle(fine[c.index[t]], fine[c.index[t + 1]], fine[c.index[t + 2]], p);
      if (want != found)
        return false;
    }
  return true;
}

std::string text_of(const polygon &g) {
  std::string out;
  for (const point p : g)
    out += "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ") ";
  return out;
}

const long planes[][2][3] = {{{1, 0, 0}, {0, 1, 0}},  {{0, 1, 0}, {0, 0, 1}},   {{0, 0, 1}, {1, 0, 0}},
                             {{1, 2, 1}, {-1, 1, 3}}, {{3, -1, 2}, {1, 5, -4}}, {{0, 1, 0}, {1, 0, 0}}};

} // namespace

TEST_CASE("polygons with notches, holes, bridges, spikes and repeated corners are cut to their closed set",
          "[polygon]") {
  dice roll(1);
  std::size_t holes = 0;
  for (int i = 0; i < 1500; ++i) {
    polygon g = simple(roll, 3 + roll.index(12));
    const std::size_t before = g.size();
    if (i % 2)
      add_hole(g, roll);
    holes += g.size() > before;
    if (i % 3)
      decorate(g, roll);
    if (g.size() == 3)
      continue;
    std::rotate(g.begin(), g.begin() + static_cast<std::ptrdiff_t>(roll.index(g.size())), g.end());
    if (i % 5 == 0)
      std::reverse(g.begin(), g.end());
    const auto &[u, v] = planes[roll.index(std::size(planes))];
    const cut c = cut_of(g, u, v);
    INFO(text_of(g));
    REQUIRE_FALSE(c.crossing);
    REQUIRE(covers(g, c, sign(area(g))));
    long sum = 0; // nothing is covered twice
    for (std::size_t t = 0; t < c.index.size(); t += 3)
      sum += std::abs(turn(g[c.index[t]], g[c.index[t + 1]], g[c.index[t + 2]]));
    REQUIRE(sum == std::abs(area(g)));
  }
  CHECK(holes > 300);
}

TEST_CASE("any closed chain is cut to what it winds around, or is said to cross itself", "[polygon]") {
  dice roll(2);
  std::size_t crossing = 0, whole = 0;
  for (int i = 0; i < 3000; ++i) {
    polygon g;
    for (std::size_t n = 4 + roll.index(5); n > 0; --n)
      g.push_back({roll.below(4 + i % 8), roll.below(4 + i % 8)});
    const auto &[u, v] = planes[roll.index(std::size(planes))];
    const cut c = cut_of(g, u, v);
    INFO(text_of(g));
    REQUIRE(c.index.size() == 3 * (g.size() - 2));
    (c.crossing ? crossing : whole) += 1;
    if (!c.crossing)
      REQUIRE(covers(g, c, area(g) == 0 ? 1 : sign(area(g))));
  }
  CHECK(crossing > 500);
  CHECK(whole > 500);
}

TEST_CASE("a convex polygon is fanned from its first corner", "[polygon]") {
  const polygon ring{{3, 0}, {6, 0}, {9, 2}, {10, 5}, {9, 8}, {6, 10}, {3, 10}, {1, 8}, {0, 5}, {1, 2}};
  for (std::size_t first = 0; first < ring.size(); ++first) {
    polygon g = ring;
    std::rotate(g.begin(), g.begin() + static_cast<std::ptrdiff_t>(first), g.end());
    g.insert(g.begin() + 4, g[4]); // twice
    std::vector<std::uint32_t> fan;
    for (std::uint32_t i = 2; i < g.size(); ++i)
      fan.insert(fan.end(), {0, i - 1, i});
    for (const auto &[u, v] : planes)
      CHECK(cut_of(g, u, v).index == fan);
  }
}

TEST_CASE("how far a polygon is from its plane", "[polygon]") {
  const auto notes = [](const std::vector<float> &xyz, std::size_t corners) {
    meetc::io::element_set set;
    set.data = xyz;
    meetc::io::vertex_lists faces;
    for (std::uint32_t i = 0; i < xyz.size() / 3; ++i) {
      faces.vertices.push_back(i);
      if ((i + 1) % corners == 0)
        faces.end_list(corners);
    }
    meetc::io::cut_polygons("test", std::move(faces), 2, set);
    std::string all;
    for (const std::string &n : set.notes)
      all += n + "\n";
    return all;
  };
  // The unit square with one corner lifted by 1: the normal is (-1, -1, 2), and its neighbours are 1/sqrt(6) away.
  CHECK(notes({0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 0}, 4) == "1 of 1 polygons is not planar: a corner is 0.408 from the "
                                                          "plane through the first one at most; more than 2^-20 of "
                                                          "the longest side: face 0\n");
  // A step of float32 at one corner, which is less than 2^-20 of the side; and a plane that float32 holds exactly.
  const float step = 0x1p-149F;
  CHECK(notes({0, 0, 0, 1, 0, 0, 1, 1, step, 0, 1, 0, 0, 0, 5, 1, 0, 6, 1, 1, 7, 0, 1, 6}, 4) ==
        "1 of 2 polygons is not planar: a corner is 7.01e-46 from the plane through the first one at most\n");
  CHECK(notes({1e8F, 1e8F, 0, 3e8F, 1e8F, 1, 3e8F, 3e8F, 2, 1e8F, 3e8F, 1}, 4).empty());
}
