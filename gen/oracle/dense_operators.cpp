// Operators by their definitions: reverses and complements by outer products, and the inverse by linear equations.
#include "gen/oracle/dense.hpp"

#include <algorithm>
#include <stdexcept>

namespace meetc::oracle {
namespace {

multivector basis_blade(std::size_t size, std::size_t b) {
  multivector out(size);
  out[b] = 1;
  return out;
}

// a with each basis blade b replaced by image(b).
template <class F> multivector with_images(const multivector &a, F image) {
  multivector out(a.size());
  for (std::size_t b = 0; b < a.size(); ++b)
    if (a[b] != 0)
      out = add(out, scale(a[b], image(b)));
  return out;
}

// The blade c with product(c, which is the multiple of the one blade that fits) = i.
template <class F> multivector complement(const multivector &a, const multivector &i, F product) {
  const std::size_t last = a.size() - 1;
  if (i.size() != a.size() || i[last] == 0 || !is_zero(subtract(i, scale(i[last], basis_blade(a.size(), last)))))
    throw std::invalid_argument("a complement needs a pseudoscalar");
  return with_images(a, [&](std::size_t b) {
    const multivector other = basis_blade(a.size(), last - b);
    const multivector whole = product(basis_blade(a.size(), b), other);
    return scale(i[last] / whole[last], other);
  });
}

} // namespace

multivector reverse(const multivector &a) {
  return with_images(a, [&](std::size_t b) {
    multivector out = basis_blade(a.size(), 0);
    for (std::size_t v = 1; v < a.size(); v *= 2)
      if ((b & v) != 0)
        out = outer(basis_blade(a.size(), v), out); // each later vector stands before those before it
    return out;
  });
}

multivector involute(const multivector &a) {
  return with_images(a, [&](std::size_t b) {
    multivector out = basis_blade(a.size(), 0);
    for (std::size_t v = 1; v < a.size(); v *= 2)
      if ((b & v) != 0)
        out = outer(out, scale(-1, basis_blade(a.size(), v)));
    return out;
  });
}

multivector right_complement(const multivector &a, const multivector &i) {
  return complement(a, i, [](const multivector &b, const multivector &c) { return outer(b, c); });
}

multivector left_complement(const multivector &a, const multivector &i) {
  return complement(a, i, [](const multivector &b, const multivector &c) { return outer(c, b); });
}

multivector dense_algebra::symmetric_dot(const multivector &a, const multivector &b) const {
  multivector out = zero();
  for (int r = 0; r <= n_; ++r)
    for (int s = 0; s <= n_; ++s)
      out = add(out, grade_part(geometric(grade_part(a, r), grade_part(b, s)), r > s ? r - s : s - r));
  return out;
}

multivector dense_algebra::inverse(const multivector &a) const {
  // Row k of the equations: the coefficient k of x a is that of 1.
  if (is_zero(subtract(a, scalar(scalar_part(a)))) && scalar_part(a) != 0)
    return scalar(1 / scalar_part(a));
  const std::size_t n = size();
  matrix rows(n, std::vector<rational>(n + 1));
  for (std::size_t j = 0; j < n; ++j) {
    const multivector column = geometric(basis_blade(n, j), a);
    for (std::size_t k = 0; k < n; ++k)
      rows[k][j] = column[k];
  }
  rows[0][n] = 1;
  for (std::size_t j = 0; j < n; ++j) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(j), rows.end(),
                                    [j](const auto &row) { return row[j] != 0; });
    if (pivot == rows.end())
      throw std::domain_error("a multivector without an inverse");
    std::swap(*pivot, rows[j]);
    const rational by = rows[j][j];
    for (rational &x : rows[j])
      x /= by;
    for (std::size_t k = 0; k < n; ++k)
      if (const rational f = rows[k][j]; k != j && f != 0)
        for (std::size_t c = j; c <= n; ++c)
          rows[k][c] -= f * rows[j][c];
  }
  multivector out(n);
  for (std::size_t j = 0; j < n; ++j)
    out[j] = rows[j][n];
  return out;
}

} // namespace meetc::oracle
