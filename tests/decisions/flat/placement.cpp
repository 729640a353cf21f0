#include "tests/decisions/flat/placement.hpp"

#include <algorithm>

namespace meetc::decisions_test {
namespace {

place cross(const place &u, const place &v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Two integer vectors whose cross product is a positive multiple of n.
std::vector<place> across(const place &n) {
  const std::vector<place> units{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::size_t k = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
  const place u = cross(n, units[(k + 1) % 3]), v = cross(n, units[(k + 2) % 3]); // u x v = n n[k]
  return n[k] > 0 ? std::vector{u, v} : std::vector{v, u};
}

std::vector<place> directions() {
  std::vector<place> out;
  for (int x = 0; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x > 0 || y > 0 || (y == 0 && z > 0)) // the first non-zero coordinate is positive
          out.push_back({x, y, z});
  return out;
}

std::vector<placement> make(int d) {
  std::vector<placement> out;
  if (d == 3)
    return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}},
            {{{1, -3, 1}, {2, 1, -1}, {1, 2, 3}}, {}},
            {{{-19, 1, 12}, {1, 15, 2}, {-18, 16, 12}}, {}},
            {{{10, 10, -19}, {30, 0, -30}, {0, 30, -30}}, {}}};
  if (d == 0)
    return {{{}, {}}};
  for (const place &n : directions())
    out.push_back({d == 2 ? across(n) : std::vector{n}, n});
  return out;
}

} // namespace

const std::vector<placement> &placements(int d) {
  static const std::vector<placement> all[] = {make(0), make(1), make(2), make(3)};
  return all[d];
}

points placed(const points &x, const placement &p) {
  points out(x.size(), place{});
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < p.image.size(); ++j)
      for (std::size_t k = 0; k < 3; ++k)
        out[i][k] += x[i][j] * p.image[j][k];
  return out;
}

bool judge::touching(const points &x, std::size_t m) {
  const auto sorted = [](auto from, auto to) {
    points out(from, to);
    std::ranges::sort(out);
    return out;
  };
  const auto cut = x.begin() + static_cast<std::ptrdiff_t>(m);
  std::pair hulls(sorted(x.begin(), cut), sorted(cut, x.end()));
  if (hulls.second < hulls.first)
    std::swap(hulls.first, hulls.second);
  if (const auto known = answers_.find(hulls); known != answers_.end())
    return known->second;
  const auto hull_of = [](const points &corners) {
    oracle::hull out;
    for (const place &c : corners)
      out.push_back(oracle::at(c[0], c[1], c[2]));
    return out;
  };
  const bool touching = oracle::squared_distance(hull_of(hulls.first), hull_of(hulls.second)) == 0;
  return answers_.emplace(std::move(hulls), touching).first->second;
}

} // namespace meetc::decisions_test
