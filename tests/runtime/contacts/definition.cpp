#include "tests/runtime/contacts/definition.hpp"

#include <algorithm>
#include <optional>

namespace meetc::contacts_test {

exact_point operator-(const exact_point &x, const exact_point &y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
exact_point cross(const exact_point &x, const exact_point &y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
mpq_class dot(const exact_point &x, const exact_point &y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
exact_point point_at(const float *x) {
  return {mpq_class(x[0]), mpq_class(x[1]), mpq_class(x[2])};
}
exact_point normal_of(const float *row) {
  const exact_point at = point_at(row);
  return cross(point_at(row + 3) - at, point_at(row + 6) - at);
}
bool is_zero(const exact_point &x) {
  return x[0] == 0 && x[1] == 0 && x[2] == 0;
}

namespace {

struct carrier {
  int name;
  std::vector<exact_point> corners;
};

// The carriers of the hull of a row; corners of no extent are those of least index.
std::vector<carrier> carriers_of(const float *row, int corners) {
  std::vector<exact_point> at;
  for (int i = 0; i < corners; ++i)
    at.push_back(point_at(row + static_cast<std::ptrdiff_t>(3) * i));
  if (corners == 3 && !is_zero(normal_of(row)))
    return {{0, {at[0]}},        {1, {at[1]}},        {2, {at[2]}}, {3, {at[0], at[1]}},
            {4, {at[1], at[2]}}, {5, {at[2], at[0]}}, {6, at}};
  const auto least = std::min_element(at.begin(), at.end()); // the first of equal ones
  const auto most = std::max_element(at.begin(), at.end());
  const int i = static_cast<int>(least - at.begin()), j = static_cast<int>(most - at.begin());
  if (at[static_cast<std::size_t>(i)] == at[static_cast<std::size_t>(j)])
    return {{0, {at[0]}}};
  const int edge = corners == 2 ? 3 : (i + 1) % 3 == j ? 3 + i : 3 + j;
  return {{i, {*least}}, {j, {*most}}, {edge, {*least, *most}}};
}

// The one solution of the rows, whose last number is the right side; none if there is no solution or more than one.
std::optional<std::vector<mpq_class>> solution(std::vector<std::vector<mpq_class>> rows, std::size_t unknowns) {
  for (std::size_t c = 0; c < unknowns; ++c) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(std::min(c, rows.size())), rows.end(),
                                    [c](const auto &r) { return r[c] != 0; });
    if (pivot == rows.end())
      return std::nullopt;
    std::swap(rows[c], *pivot);
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (r != c && rows[r][c] != 0) {
        const mpq_class factor = rows[r][c] / rows[c][c];
        for (std::size_t k = c; k <= unknowns; ++k)
          rows[r][k] -= factor * rows[c][k];
      }
  }
  for (std::size_t r = unknowns; r < rows.size(); ++r)
    if (rows[r][unknowns] != 0)
      return std::nullopt;
  std::vector<mpq_class> out;
  for (std::size_t c = 0; c < unknowns; ++c)
    out.emplace_back(rows[c][unknowns] / rows[c][c]);
  return out;
}

// The one point that the lines or planes of both carriers share, if it lies inside both.
std::optional<exact_point> shared_point(const carrier &s, const carrier &t, bool closed) {
  const std::size_t n = s.corners.size(), m = t.corners.size();
  std::vector<std::vector<mpq_class>> rows(5, std::vector<mpq_class>(n + m + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      rows[k][i] = s.corners[i][k];
    rows[3][i] = 1;
  }
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      rows[k][n + i] = -t.corners[i][k];
    rows[4][n + i] = 1;
  }
  rows[3][n + m] = rows[4][n + m] = 1;
  const auto weights = solution(rows, n + m);
  if (!weights ||
      std::any_of(weights->begin(), weights->end(), [closed](const mpq_class &w) { return closed ? w < 0 : w <= 0; }))
    return std::nullopt;
  exact_point x;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      x[k] += (*weights)[i] * s.corners[i][k];
  return x;
}

} // namespace

std::vector<exact_label> labels_by_definition(const float *a, int corners_a, const float *b, int corners_b,
                                              bool closed) {
  const std::vector<carrier> of_a = carriers_of(a, corners_a), of_b = carriers_of(b, corners_b);
  std::vector<exact_label> out;
  for (const carrier &s : of_a)
    for (const carrier &t : of_b)
      if (const auto x = shared_point(s, t, closed))
        out.push_back({s.name, t.name, *x});
  std::sort(out.begin(), out.end(),
            [](const exact_label &x, const exact_label &y) { return x.b != y.b ? x.b < y.b : x.a < y.a; });
  return out;
}

} // namespace meetc::contacts_test
