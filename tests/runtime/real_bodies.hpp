// Real meshes from a folder, and their places: for the tests that collide them on a CPU and on a device.
#ifndef MEETC_TESTS_RUNTIME_REAL_BODIES_HPP
#define MEETC_TESTS_RUNTIME_REAL_BODIES_HPP

#include "meet/core/views/pose.hpp"
#include "meet/io/read.hpp"

#include <algorithm>
#include <array>
#include <cga/cga_runtime.hpp>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace real_bodies {

struct body {
  std::string name;
  std::vector<float> corners; // 9 a face
  std::array<double, 3> middle{};
  double size = 0; // the largest side of its box
};

// All PLY files of the folder, by name; none where there is no such folder.
inline std::vector<body> load_all(const std::filesystem::path &folder) {
  std::vector<const meetc::kind_info *> kinds;
  for (int i = 0; i < cga::catalogue().kind_count; ++i)
    kinds.push_back(&cga::catalogue().kinds[i]);
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto &entry : std::filesystem::directory_iterator(folder, none))
    if (entry.path().extension() == ".ply")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<body> out;
  for (const auto &file : files) {
    const meetc::io::element_set set = meetc::io::read(file, kinds);
    body b{file.stem().string(), std::vector<float>(9 * set.elements)};
    for (std::size_t i = 0; i < set.elements; ++i)
      set.row(i, b.corners.data() + 9 * i);
    for (std::size_t k = 0; k < 3; ++k) {
      double lo = 1e300, hi = -1e300;
      for (std::size_t i = k; i < b.corners.size(); i += 3) {
        lo = std::min(lo, static_cast<double>(b.corners[i]));
        hi = std::max(hi, static_cast<double>(b.corners[i]));
      }
      b.middle[k] = (lo + hi) / 2;
      b.size = std::max(b.size, hi - lo);
    }
    out.push_back(std::move(b));
  }
  return out;
}

// Scaled and rotated about the body's middle, which moves to `to`.
inline meetc::pose placed(const body &b, double scale, bool rotated, const std::array<double, 3> &to) {
  constexpr double rotation[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
  meetc::pose p;
  p.length_scale = scale;
  for (std::size_t k = 0; k < 3; ++k) {
    double *const m = p.m + 4 * k;
    m[3] = to[k];
    for (std::size_t j = 0; j < 3; ++j) {
      m[j] = scale * (rotated ? rotation[k][j] : k == j ? 1.0 : 0.0);
      m[3] -= m[j] * b.middle[j];
    }
  }
  return p;
}

} // namespace real_bodies

#endif
