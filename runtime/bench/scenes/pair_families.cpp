#include "meet/bench/scenes/pair_families.hpp"

#include "meet/bench/truth/numbers.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>

namespace meetc::bench {

namespace {

using row = std::array<float, 9>;

row triangle(numbers &from) {
  row r;
  std::generate(r.begin(), r.end(), [&from] { return from.place(); });
  return r;
}

// In double, which is exact for the lattice of the coplanar family; elsewhere a zero is as improbable as it can be.
bool has_area(const row &t) {
  std::array<double, 3> u{}, v{};
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = static_cast<double>(t[3 + k]) - static_cast<double>(t[k]);
    v[k] = static_cast<double>(t[6 + k]) - static_cast<double>(t[k]);
  }
  return u[1] * v[2] != u[2] * v[1] || u[2] * v[0] != u[0] * v[2] || u[0] * v[1] != u[1] * v[0];
}

bool boxes_touch(const row &a, const row &b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low_a, high_a] = std::minmax({a[k], a[3 + k], a[6 + k]});
    const auto [low_b, high_b] = std::minmax({b[k], b[3 + k], b[6 + k]});
    if (high_a < low_b || high_b < low_a)
      return false;
  }
  return true;
}

using maker = std::function<void(numbers &, row &a, row &b)>;

pair_family family(std::string name, std::size_t n, std::uint64_t seed, const maker &make) {
  pair_family f{std::move(name), {}, {}};
  numbers from(seed);
  while (f.pairs() < n) {
    row a = triangle(from), b = triangle(from);
    make(from, a, b);
    if (!has_area(a) || !has_area(b) || !boxes_touch(a, b))
      continue;
    f.a.insert(f.a.end(), a.begin(), a.end());
    f.b.insert(f.b.end(), b.begin(), b.end());
  }
  return f;
}

void share(row &a, row &b, std::size_t corners) {
  std::copy_n(a.begin(), 3 * corners, b.begin());
}

// All corners at i u + j v for whole numbers: exact in float.
void make_coplanar(numbers &from, row &a, row &b) {
  std::array<int, 3> u{}, v{};
  for (std::size_t k = 0; k < 3; ++k)
    u[k] = from.whole(31), v[k] = from.whole(31);
  for (row *const t : {&a, &b})
    for (std::size_t p = 0; p < 9; p += 3) {
      const int i = from.whole(1000), j = from.whole(1000);
      for (std::size_t k = 0; k < 3; ++k)
        (*t)[p + k] = static_cast<float>(i * u[k] + j * v[k]) * 0x1p-16F;
    }
}

void put_on_plane(numbers &from, const row &a, row &b, std::size_t corners) {
  for (std::size_t p = 0; p < 3 * corners; p += 3) {
    const double s = static_cast<double>(from.place()), t = static_cast<double>(from.place());
    for (std::size_t k = 0; k < 3; ++k) {
      const double o = static_cast<double>(a[k]);
      b[p + k] =
          static_cast<float>(o + s * (static_cast<double>(a[3 + k]) - o) + t * (static_cast<double>(a[6 + k]) - o));
    }
  }
}

} // namespace

std::vector<pair_family> pair_families(std::size_t n) {
  std::vector<pair_family> out;
  out.push_back(family("random, overlapping boxes", n, 1, [](numbers &, row &, row &) {}));
  out.push_back(family("a shared corner", n, 2, [](numbers &, row &a, row &b) { share(a, b, 1); }));
  out.push_back(family("a shared edge", n, 3, [](numbers &, row &a, row &b) { share(a, b, 2); }));
  out.push_back(family("oblique coplanar", n, 4, make_coplanar));
  out.push_back(family("one corner rounded onto a plane", n, 5,
                       [](numbers &from, row &a, row &b) { put_on_plane(from, a, b, 1); }));
  out.push_back(family("three corners rounded onto a plane", n, 6,
                       [](numbers &from, row &a, row &b) { put_on_plane(from, a, b, 3); }));
  return out;
}

} // namespace meetc::bench
