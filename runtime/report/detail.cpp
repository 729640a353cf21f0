#include "meet/report/detail.hpp"

#include "meet/report/surface.hpp"

#include <bit>
#include <unordered_map>
#include <unordered_set>

namespace meetc::report {

namespace {

using point = std::array<float, 3>;
struct hash_of_point {
  std::size_t operator()(const point &p) const {
    std::uint64_t h = 0;
    for (const float x : p)
      h = (h ^ std::bit_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(h ^ h >> 32);
  }
};

// -0 counts as +0.
point point_at(const float *row) {
  return {row[0] + 0.0f, row[1] + 0.0f, row[2] + 0.0f};
}

} // namespace

listed_pairs list_pairs(const scene &s, const limits &most) {
  listed_pairs out;
  for (const shape &one : s.shapes)
    out.named.emplace_back(one.items, 0);
  if (s.pairs.empty())
    return out;
  std::vector<std::uint8_t> &a = out.named.front(), &b = out.named.back();
  std::size_t in_a = 0, in_b = 0;
  for (const index_pair p : s.pairs) {
    const bool new_a = !a[p.a], new_b = !b[p.b];
    if (out.count == most.pairs || in_a + new_a > most.items || in_b + new_b > most.items)
      break;
    ++out.count, in_a += new_a, in_b += new_b;
    a[p.a] = b[p.b] = 1;
  }
  return out;
}

std::vector<std::uint8_t> detailed(const shape &s, std::span<const std::uint8_t> named) {
  const picture::shape &d = s.drawn;
  const std::size_t n = picture::elements(d);
  if (d.what != picture::form::triangles)
    return std::vector<std::uint8_t>(n, 1);
  std::vector<std::uint8_t> out(n, 0);
  std::unordered_set<point, hash_of_point> corners;
  for (std::size_t e = 0; e < n; ++e)
    if (!named.empty() && named[s.item_of(e)]) {
      out[e] = 1;
      for (std::size_t k = 0; k < 3; ++k)
        corners.insert(point_at(corner(d, e, k)));
    }
  if (!corners.empty())
    for (std::size_t e = 0; e < n; ++e)
      for (std::size_t k = 0; k < 3 && !out[e]; ++k)
        out[e] = corners.contains(point_at(corner(d, e, k)));
  return out;
}

detail detail_of(const shape &s, std::span<const std::uint8_t> chosen, const placing &at) {
  const picture::shape &d = s.drawn;
  detail out;
  std::unordered_map<point, std::uint32_t, hash_of_point> numbers;
  const auto add_point = [&](const float *row) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      out.numbers.push_back(at.coordinate(row[axis], axis));
  };
  for (std::size_t e = 0; e < chosen.size(); ++e) {
    if (!chosen[e])
      continue;
    out.elements.push_back(static_cast<std::uint32_t>(e));
    out.items.push_back(s.item_of(e));
    out.hit.push_back(is_hit(d, e));
    if (d.what == picture::form::triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [of, is_new] =
            numbers.try_emplace(point_at(corner(d, e, k)), static_cast<std::uint32_t>(numbers.size()));
        if (is_new)
          add_point(corner(d, e, k));
        out.index.push_back(of->second);
      }
    } else if (d.what == picture::form::spheres) {
      add_point(&d.rows[4 * e]);
      out.numbers.push_back(at.length(d.rows[4 * e + 3]));
    } else {
      add_point(&d.rows[6 * e]);
      add_point(&d.rows[6 * e + 3]);
    }
  }
  return out;
}

} // namespace meetc::report
