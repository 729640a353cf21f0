#include "tests/runtime/contacts/families.hpp"

#include <cmath>

namespace meetc::contacts_test {
namespace {

using numbers = std::vector<float>;

int below(std::mt19937 &random, int n) {
  return static_cast<int>(random() % static_cast<unsigned>(n));
}
numbers lattice(std::mt19937 &random, int corners, int size) {
  numbers out;
  for (int i = 0; i < 3 * corners; ++i)
    out.push_back(static_cast<float>(below(random, size)));
  return out;
}
numbers general(std::mt19937 &random, int corners, float size) {
  std::uniform_real_distribution<float> number(-size, size);
  numbers out;
  for (int i = 0; i < 3 * corners; ++i)
    out.push_back(number(random));
  return out;
}
// Points of one plane of the lattice: of three, the last coordinate is a sum of the others.
void flatten(numbers &row, int u, int v, int w) {
  for (std::size_t i = 0; i < row.size(); i += 3)
    row[i + 2] = static_cast<float>(u) * row[i] + static_cast<float>(v) * row[i + 1] + static_cast<float>(w);
}
void share(std::mt19937 &random, pair_rows &p) {
  for (int n = below(random, 3); n >= 0; --n) {
    const auto i = static_cast<std::size_t>(below(random, static_cast<int>(p.a.size() / 3))),
               j = static_cast<std::size_t>(below(random, 3));
    for (std::size_t k = 0; k < 3; ++k)
      p.b[3 * j + k] = p.a[3 * i + k];
  }
}
template <class F> void each(pair_rows &p, const F &f) {
  for (numbers *const row : {&p.a, &p.b})
    for (float &x : *row)
      x = f(x);
}

} // namespace

std::vector<family> families(int n) {
  const auto on_lattice = [n](int size) {
    return [n, size](std::mt19937 &r) { return pair_rows{lattice(r, n, size), lattice(r, 3, size)}; };
  };
  return {
      {"lattice of 2", on_lattice(2)},
      {"lattice of 3", on_lattice(3)},
      {"lattice of 4", on_lattice(4)},
      {"lattice of 8", on_lattice(8)},
      {"in one plane",
       [n](std::mt19937 &r) {
         pair_rows p{lattice(r, n, 5), lattice(r, 3, 5)};
         const int u = below(r, 3) - 1, v = below(r, 3) - 1, w = below(r, 5);
         flatten(p.a, u, v, w), flatten(p.b, u, v, w);
         return p;
       }},
      {"corners in common",
       [n](std::mt19937 &r) {
         pair_rows p{lattice(r, n, 4), lattice(r, 3, 4)};
         share(r, p);
         return p;
       }},
      {"without area",
       [n](std::mt19937 &r) {
         pair_rows p{lattice(r, n, 4), lattice(r, 3, 4)};
         numbers &flat =
             below(r, 2) != 0 || n == 2 ? p.b : p.a; // its third corner on the line of the others, or a copy
         const int t = below(r, 4) - 1;
         for (std::size_t k = 0; k < 3; ++k)
           flat[6 + k] = flat[k] + static_cast<float>(t) * (flat[3 + k] - flat[k]);
         if (below(r, 4) == 0)
           flat[3] = flat[0], flat[4] = flat[1], flat[5] = flat[2];
         return p;
       }},
      {"far from the origin",
       [n](std::mt19937 &r) {
         pair_rows p{lattice(r, n, 4), lattice(r, 3, 4)};
         each(p, [](float x) { return x + 8388608.0F; });
         return p;
       }},
      {"signed, of zeros and subnormal numbers",
       [n](std::mt19937 &r) {
         pair_rows p{lattice(r, n, 5), lattice(r, 3, 5)};
         each(p, [&r](float x) { return x == 2 && below(r, 2) != 0 ? -0.0F : (x - 2) * 0x1p-149F; });
         return p;
       }},
      {"planes through the origin",
       [n](std::mt19937 &r) {
         pair_rows p{general(r, n, 3), general(r, 3, 3)};
         for (std::size_t k = 0; k < 3; ++k) // the edge from 0 to 1 passes through the origin, in B's plane
           p.a[3 + k] = -2 * p.a[k], p.b[6 + k] = -(p.b[k] + p.b[3 + k]);
         each(p, [](float x) { return std::round(x * 64) / 64; });
         return p;
       }},
      {"general position",
       [n](std::mt19937 &r) {
         return pair_rows{general(r, n, 1), general(r, 3, 1)};
       }},
      {"far general position",
       [n](std::mt19937 &r) {
         pair_rows p{general(r, n, 1), general(r, 3, 1)};
         each(p, [](float x) { return x + 1e4F; });
         return p;
       }},
      {"of all sizes",
       [n](std::mt19937 &r) {
         pair_rows p{lattice(r, n, 7), lattice(r, 3, 7)};
         each(p, [&r](float x) { return std::ldexp(x - 3, below(r, 2) != 0 ? 0 : below(r, 240) - 140); });
         return p;
       }},
  };
}

} // namespace meetc::contacts_test
