#include "meet/core/contacts/names.hpp"

#include "meet/core/sets/prepared.hpp"
#include "meet/core/views/numbered.hpp"
#include "meet/core/views/rows.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace meetc {

touched_rows touched_by(const view &elements, const kind_info &kind, const pose &at, std::span<const index_pair> pairs,
                        bool side_b, std::vector<std::uint32_t> &in, const execution &on) {
  touched_rows out;
  out.corners = kind.points, out.fields = kind.fields;
  std::vector<std::uint32_t> row_of(elements.elements, no_element);
  const auto element = [&](const index_pair &p) { return side_b ? p.b : p.a; };
  for_strips(on, pairs.size(), [&](std::size_t begin, std::size_t end) {
    for (const index_pair &p : pairs.subspan(begin, end - begin)) {
      if (element(p) >= elements.elements)
        throw std::out_of_range("contacts: a pair has element " + std::to_string(element(p)) + " of " +
                                std::to_string(elements.elements));
      row_of[element(p)] = 0;
    }
  });
  for_strips(on, row_of.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (row_of[i] != no_element) {
        row_of[i] = static_cast<std::uint32_t>(out.elements.size());
        out.elements.push_back(static_cast<std::uint32_t>(i));
      }
  });
  const auto fields = static_cast<std::size_t>(kind.fields);
  out.rows.resize(out.elements.size() * fields);
  for_strips(on, out.elements.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (gather(elements, kind, at, out.elements[i], out.elements[i] + 1, out.rows.data() + i * fields) != status::ok)
        throw input_error(check(elements, kind, at), kind, side_b ? "the second set: " : "the first set: ");
  });
  in.reserve(pairs.size());
  for_strips(on, pairs.size(), [&](std::size_t begin, std::size_t end) {
    for (const index_pair &p : pairs.subspan(begin, end - begin))
      in.push_back(row_of[element(p)]);
  });
  return out;
}

namespace {
// By row, the first one with the same key.
template <std::size_t N, class Key>
std::vector<std::uint32_t> first_equal(std::size_t rows, const execution &on, const Key &key) {
  numbered<std::uint32_t, N> keys(rows, on);
  std::vector<std::uint32_t> first_of, out; // by key; by row
  for_strips(on, rows, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
      const std::uint32_t k = keys.number(key(i));
      if (k == first_of.size())
        first_of.push_back(i);
      out.push_back(first_of[k]);
    }
  });
  return out;
}
} // namespace

part_names::part_names(const touched_rows &of, const execution &on) : of_(of) {
  if (of.corners == 0) {
    first_ = first_equal<4>(of.elements.size(), on, [&](std::uint32_t i) {
      const float *const ball = of.rows.data() + std::size_t{4} * i;
      const auto centre = key_of_point(ball);
      return std::array{centre[0], centre[1], centre[2], std::bit_cast<std::uint32_t>(ball[3] + 0.0F)};
    });
    return;
  }
  const auto corners = static_cast<std::size_t>(of.corners);
  const std::size_t n = of.elements.size() * corners;
  numbered<std::uint32_t, 3> points(n, on);
  vertices_.reserve(n);
  for_strips(on, n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      vertices_.push_back(points.number(key_of_point(of.rows.data() + 3 * i)));
  });
  if (corners == 3)
    first_ = first_equal<3>(of.elements.size(), on, [&](std::size_t i) {
      std::array<std::uint32_t, 3> key{vertices_[3 * i], vertices_[3 * i + 1], vertices_[3 * i + 2]};
      std::sort(key.begin(), key.end());
      return key;
    });
}

std::array<std::uint32_t, 2> part_names::ends(std::uint32_t row, int edge) const {
  const auto corners = static_cast<std::uint32_t>(of_.corners), first = static_cast<std::uint32_t>(edge - first_edge);
  const std::uint32_t *const v = vertices_.data() + std::size_t{corners} * row;
  return {v[first], v[(first + 1) % corners]};
}
bool part_names::runs_back(std::uint32_t row, int edge) const {
  const auto [x, y] = ends(row, edge);
  return x > y;
}

// Two bits for the dimension, and 31 for each of two numbers.
std::uint64_t part_names::name(std::uint32_t row, int carrier) const {
  if (of_.corners == 0)
    return std::uint64_t{carrier == in_ball ? 3U : 2U} << 62 | static_cast<std::uint64_t>(carrier) << 31 | first_[row];
  if (carrier == open_face)
    return std::uint64_t{2} << 62 | first_[row];
  if (carrier < of_.corners)
    return vertices_[static_cast<std::size_t>(of_.corners) * row + static_cast<std::size_t>(carrier)];
  const auto [x, y] = ends(row, carrier);
  return std::uint64_t{1} << 62 | std::uint64_t{std::min(x, y)} << 31 | std::max(x, y);
}

} // namespace meetc
