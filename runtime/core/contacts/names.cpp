#include "meet/core/contacts/names.hpp"

#include "meet/core/sets/prepared.hpp"
#include "meet/core/views/numbered.hpp"
#include "meet/core/views/rows.hpp"

#include <algorithm>

namespace meetc {

touched_rows touched_by(const view &elements, const kind_info &kind, const pose &at, std::span<const index_pair> pairs,
                        bool side_b, std::vector<std::uint32_t> &in) {
  touched_rows out;
  out.corners = kind.points;
  std::vector<std::uint32_t> row_of(elements.elements, no_element);
  const auto element = [&](const index_pair &p) { return side_b ? p.b : p.a; };
  for (const index_pair &p : pairs) {
    if (element(p) >= elements.elements)
      throw std::out_of_range("contacts: a pair has element " + std::to_string(element(p)) + " of " +
                              std::to_string(elements.elements));
    row_of[element(p)] = 0;
  }
  for (std::uint32_t i = 0; i < row_of.size(); ++i)
    if (row_of[i] != no_element) {
      row_of[i] = static_cast<std::uint32_t>(out.elements.size());
      out.elements.push_back(i);
    }
  const auto fields = static_cast<std::size_t>(kind.fields);
  out.rows.resize(out.elements.size() * fields);
  for (std::size_t i = 0; i < out.elements.size(); ++i)
    if (gather(elements, kind, at, out.elements[i], out.elements[i] + 1, out.rows.data() + i * fields) != status::ok)
      throw input_error(check(elements, kind, at), kind, side_b ? "the second set: " : "the first set: ");
  in.reserve(pairs.size());
  for (const index_pair &p : pairs)
    in.push_back(row_of[element(p)]);
  return out;
}

part_names::part_names(const touched_rows &of) : of_(of) {
  const auto corners = static_cast<std::size_t>(of.corners);
  const std::size_t n = of.elements.size() * corners;
  numbered<std::uint32_t, 3> points(n);
  vertices_.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
    vertices_.push_back(points.number(key_of_point(of.rows.data() + 3 * i)));
  if (corners != 3)
    return;
  numbered<std::uint32_t, 3> faces(of.elements.size());
  std::vector<std::uint32_t> first_of; // by face
  for (std::uint32_t i = 0; i < of.elements.size(); ++i) {
    std::array<std::uint32_t, 3> key{vertices_[3 * i], vertices_[3 * i + 1], vertices_[3 * i + 2]};
    std::sort(key.begin(), key.end());
    const std::uint32_t face = faces.number(key);
    if (face == first_of.size())
      first_of.push_back(i);
    first_.push_back(first_of[face]);
  }
}

// Two bits for the dimension, and 31 for each of two numbers.
std::uint64_t part_names::name(std::uint32_t row, int carrier) const {
  const auto corners = static_cast<std::uint32_t>(of_.corners);
  if (carrier == open_face)
    return std::uint64_t{2} << 62 | first_[row];
  const std::uint32_t *const v = vertices_.data() + std::size_t{corners} * row;
  if (carrier < of_.corners)
    return v[carrier];
  const auto edge = static_cast<std::uint32_t>(carrier - first_edge);
  const std::uint32_t x = v[edge], y = v[(edge + 1) % corners];
  return std::uint64_t{1} << 62 | std::uint64_t{std::min(x, y)} << 31 | std::max(x, y);
}

} // namespace meetc
