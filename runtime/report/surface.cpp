#include "meet/report/surface.hpp"

#include "meet/core/hierarchy/spatial_order.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace meetc::report {

namespace {

std::uint64_t key_of(const std::array<std::uint16_t, 3> &p) {
  return std::uint64_t{p[0]} << 32 | std::uint64_t{p[1]} << 16 | p[2];
}

// The faces that stay, in the order of their middles, those that are hit last.
std::vector<std::uint32_t> order_of(const picture::shape &mesh, std::span<const std::uint8_t> left_out) {
  std::vector<std::uint32_t> faces;
  std::vector<centre> middles;
  centre_extent all;
  for (std::size_t f = 0; f < picture::elements(mesh); ++f) {
    if (left_out[f])
      continue;
    box around{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float x[] = {corner(mesh, f, 0)[axis], corner(mesh, f, 1)[axis], corner(mesh, f, 2)[axis]};
      around.lo[axis] = std::min({x[0], x[1], x[2]});
      around.hi[axis] = std::max({x[0], x[1], x[2]});
    }
    faces.push_back(static_cast<std::uint32_t>(f));
    middles.emplace_back(around);
    all.add(middles.back());
  }
  std::vector<std::uint64_t> keys(faces.size()), scratch(faces.size());
  spatial_order(middles.data(), nullptr, all, faces.size(), keys.data(), scratch.data(), 1);
  std::vector<std::uint32_t> out;
  out.reserve(faces.size());
  for (const std::uint64_t k : keys)
    out.push_back(faces[static_cast<std::uint32_t>(k)]);
  std::stable_partition(out.begin(), out.end(), [&mesh](std::uint32_t f) { return !is_hit(mesh, f); });
  return out;
}

} // namespace

surface surface_of(const picture::shape &mesh, std::span<const std::uint8_t> left_out) {
  surface out;
  const std::vector<std::uint32_t> faces = order_of(mesh, left_out);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double least = 0, greatest = 0;
    for (std::size_t i = 0; i < 3 * faces.size(); ++i) {
      const double x = corner(mesh, faces[i / 3], i % 3)[axis];
      least = i == 0 ? x : std::min(least, x);
      greatest = i == 0 ? x : std::max(greatest, x);
    }
    out.lo[axis] = least;
    out.step[axis] = (greatest - least) / 65535;
  }
  std::unordered_map<std::uint64_t, std::uint32_t> numbers;
  numbers.reserve(faces.size());
  for (const std::uint32_t f : faces) {
    out.hits += is_hit(mesh, f);
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<std::uint16_t, 3> p{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (out.step[axis] > 0)
          p[axis] = static_cast<std::uint16_t>(
              std::clamp(std::round((corner(mesh, f, k)[axis] - out.lo[axis]) / out.step[axis]), 0.0, 65535.0));
      const auto [at, is_new] = numbers.try_emplace(key_of(p), static_cast<std::uint32_t>(out.points.size()));
      if (is_new)
        out.points.push_back(p);
      out.index.push_back(at->second);
    }
  }
  return out;
}

} // namespace meetc::report
