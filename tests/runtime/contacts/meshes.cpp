#include "tests/runtime/contacts/meshes.hpp"

#include <cmath>

namespace meetc::contacts_test {

std::vector<float> mesh::row(std::size_t i) const {
  std::vector<float> out;
  for (std::size_t c = 0; c < corners; ++c)
    for (std::size_t k = 0; k < 3; ++k)
      out.push_back(points[std::size_t{3} * index[corners * i + c] + k]);
  return out;
}

mesh sheet(int n, int m, const std::function<void(double u, double v, float *at)> &f) {
  mesh out;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) {
      out.points.resize(out.points.size() + 3);
      f(static_cast<double>(i) / n, static_cast<double>(j) / m, out.points.data() + out.points.size() - 3);
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const auto at = static_cast<std::uint32_t>(i * (m + 1) + j), next = at + static_cast<std::uint32_t>(m) + 1;
      for (const std::uint32_t v : {at, next, at + 1, at + 1, next, next + 1})
        out.index.push_back(v);
    }
  return out;
}

mesh cuboid(float x, float y, float z, float a, float b, float c) {
  mesh out;
  for (int i = 0; i < 8; ++i)
    for (const float v : {(i & 1) != 0 ? a : x, (i & 2) != 0 ? b : y, (i & 4) != 0 ? c : z})
      out.points.push_back(v);
  out.index = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
               2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return out;
}

mesh sphere(int n, int m, double radius, double x, double y, double z) {
  constexpr double pi = 3.14159265358979323846;
  return sheet(n, m, [=](double u, double v, float *at) {
    const double height = pi * u, turn = 2 * pi * (v == 1 ? 0 : v), around = u == 0 || u == 1 ? 0 : std::sin(height);
    at[0] = static_cast<float>(x + radius * around * std::cos(turn));
    at[1] = static_cast<float>(y + radius * around * std::sin(turn));
    at[2] = static_cast<float>(z + radius * std::cos(height));
  });
}

void append(mesh &to, const mesh &more) {
  const auto before = static_cast<std::uint32_t>(to.points.size() / 3);
  to.points.insert(to.points.end(), more.points.begin(), more.points.end());
  for (const std::uint32_t v : more.index)
    to.index.push_back(before + v);
}

} // namespace meetc::contacts_test
