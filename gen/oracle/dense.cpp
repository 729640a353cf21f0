#include "gen/oracle/dense.hpp"

#include <bit>
#include <stdexcept>
#include <utility>

namespace meetc::oracle {
namespace {

void require_same_size(const multivector &a, const multivector &b) {
  if (a.size() != b.size())
    throw std::invalid_argument("multivectors of two algebras: their sizes differ");
}

// Whether an odd number of swaps sorts the vectors of blade a followed by those of blade b.
bool odd_swaps(std::size_t a, std::size_t b) {
  int swaps = 0;
  for (std::size_t rest = a >> 1; rest != 0; rest >>= 1)
    swaps += std::popcount(rest & b);
  return swaps % 2 != 0;
}

// A metric with the congruence that diagonalises g: the rows of `basis` are orthogonal vectors in terms of the declared
// ones.
struct congruence {
  matrix basis;
  std::vector<rational> squares;
};

congruence diagonalise(matrix g) {
  const std::size_t n = g.size();
  matrix p(n, std::vector<rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    p[i][i] = 1;
  // Adds f * vector j to vector i, in the basis and on both sides of the metric.
  const auto add_vector = [&](std::size_t i, std::size_t j, const rational &f) {
    for (std::size_t k = 0; k < n; ++k) {
      p[i][k] += f * p[j][k];
      g[i][k] += f * g[j][k];
    }
    for (std::size_t k = 0; k < n; ++k)
      g[k][i] += f * g[k][j];
  };
  for (std::size_t k = 0; k < n; ++k) {
    if (g[k][k] == 0) {
      // A later vector j gives a pivot: (k + j)² = 2 k·j + j², or (k - j)² where that vanishes too.
      for (std::size_t j = k + 1; j < n && g[k][k] == 0; ++j) {
        const rational sum = 2 * g[k][j] + g[j][j], difference = g[j][j] - 2 * g[k][j];
        if (sum != 0)
          add_vector(k, j, 1);
        else if (difference != 0)
          add_vector(k, j, -1);
      }
      if (g[k][k] == 0)
        continue; // k is orthogonal to itself and to all later vectors
    }
    for (std::size_t i = k + 1; i < n; ++i) {
      const rational factor = -g[i][k] / g[k][k];
      add_vector(i, k, factor);
    }
  }
  std::vector<rational> squares(n);
  for (std::size_t i = 0; i < n; ++i)
    squares[i] = g[i][i];
  return {std::move(p), std::move(squares)};
}

// Gauss-Jordan elimination. The matrices here are products of elementary ones, so none is singular.
matrix inverse_of(matrix a) {
  const std::size_t n = a.size();
  matrix r(n, std::vector<rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    r[i][i] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (a.at(pivot)[k] == 0)
      ++pivot;
    std::swap(a[k], a[pivot]);
    std::swap(r[k], r[pivot]);
    const rational d = a[k][k];
    for (std::size_t j = 0; j < n; ++j) {
      a[k][j] /= d;
      r[k][j] /= d;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const rational f = a[i][k];
      if (i == k || f == 0)
        continue;
      for (std::size_t j = 0; j < n; ++j) {
        a[i][j] -= f * a[k][j];
        r[i][j] -= f * r[k][j];
      }
    }
  }
  return r;
}

// The image of every blade under the linear map that sends vector i to row i.
std::vector<multivector> blade_images(const matrix &rows) {
  const std::size_t n = rows.size(), size = std::size_t{1} << n;
  std::vector<multivector> images(size, multivector(size));
  images[0][0] = 1;
  for (std::size_t m = 1; m < size; ++m) {
    const auto top = static_cast<std::size_t>(std::bit_width(m)) - 1;
    multivector v(size);
    for (std::size_t j = 0; j < n; ++j)
      v[std::size_t{1} << j] = rows[top][j];
    images[m] = outer(images[m ^ std::size_t{1} << top], v);
  }
  return images;
}

multivector image_of(const std::vector<multivector> &images, const multivector &a) {
  multivector r(a.size());
  for (std::size_t m = 0; m < a.size(); ++m)
    if (a[m] != 0)
      for (std::size_t k = 0; k < a.size(); ++k)
        r[k] += a[m] * images[m][k];
  return r;
}

} // namespace

multivector add(const multivector &a, const multivector &b) {
  require_same_size(a, b);
  multivector r(a);
  for (std::size_t m = 0; m < r.size(); ++m)
    r[m] += b[m];
  return r;
}

multivector subtract(const multivector &a, const multivector &b) {
  return add(a, scale(-1, b));
}

multivector scale(const rational &k, const multivector &a) {
  multivector r(a);
  for (rational &c : r)
    c *= k;
  return r;
}

multivector outer(const multivector &a, const multivector &b) {
  require_same_size(a, b);
  multivector r(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == 0)
      continue;
    for (std::size_t j = 0; j < b.size(); ++j)
      if ((i & j) == 0 && b[j] != 0) {
        const rational t = a[i] * b[j];
        r[i | j] += odd_swaps(i, j) ? -t : t;
      }
  }
  return r;
}

multivector grade_part(const multivector &a, int k) {
  multivector r(a.size());
  for (std::size_t m = 0; m < a.size(); ++m)
    if (std::popcount(m) == k)
      r[m] = a[m];
  return r;
}

rational scalar_part(const multivector &a) {
  return a.at(0);
}

bool is_zero(const multivector &a) {
  for (const rational &c : a)
    if (c != 0)
      return false;
  return true;
}

dense_algebra::dense_algebra(const matrix &metric) : n_(static_cast<int>(metric.size())) {
  if (metric.empty() || metric.size() > 8)
    throw std::invalid_argument("a dense algebra has 1 to 8 vectors");
  bool is_diagonal = true;
  for (std::size_t i = 0; i < metric.size(); ++i) {
    if (metric[i].size() != metric.size())
      throw std::invalid_argument("the metric is not square");
    for (std::size_t j = 0; j < i; ++j) {
      if (metric[i][j] != metric[j][i])
        throw std::invalid_argument("the metric is not symmetric");
      is_diagonal = is_diagonal && metric[i][j] == 0;
    }
  }
  if (is_diagonal) {
    for (std::size_t i = 0; i < metric.size(); ++i)
      squares_.push_back(metric[i][i]);
    return;
  }
  congruence c = diagonalise(metric);
  squares_ = std::move(c.squares);
  from_ = blade_images(c.basis);
  to_ = blade_images(inverse_of(std::move(c.basis)));
}

dense_algebra dense_algebra::diagonal(const std::vector<rational> &squares) {
  matrix g(squares.size(), std::vector<rational>(squares.size()));
  for (std::size_t i = 0; i < squares.size(); ++i)
    g[i][i] = squares[i];
  return dense_algebra(g);
}

multivector dense_algebra::scalar(const rational &k) const {
  multivector r = zero();
  r[0] = k;
  return r;
}

multivector dense_algebra::vector(int i) const {
  if (i < 0 || i >= n_)
    throw std::invalid_argument("no such basis vector");
  multivector r = zero();
  r[std::size_t{1} << i] = 1;
  return r;
}

multivector dense_algebra::pseudoscalar() const {
  multivector r = zero();
  r.back() = 1;
  return r;
}

multivector dense_algebra::orthogonal_product(const multivector &a, const multivector &b, bool contract) const {
  multivector r(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == 0)
      continue;
    for (std::size_t j = 0; j < b.size(); ++j) {
      // The product of orthogonal blades has grade s - r exactly where all vectors of i are in j.
      if (b[j] == 0 || (contract && (i & j) != i))
        continue;
      rational t = a[i] * b[j];
      for (std::size_t k = 0; k < squares_.size(); ++k)
        if ((i & j) >> k & 1)
          t *= squares_[k];
      r[i ^ j] += odd_swaps(i, j) ? -t : t;
    }
  }
  return r;
}

multivector dense_algebra::product(const multivector &a, const multivector &b, bool contract) const {
  if (a.size() != size() || b.size() != size())
    throw std::invalid_argument("a multivector of another algebra");
  if (to_.empty())
    return orthogonal_product(a, b, contract);
  return image_of(from_, orthogonal_product(image_of(to_, a), image_of(to_, b), contract));
}

multivector dense_algebra::geometric(const multivector &a, const multivector &b) const {
  return product(a, b, false);
}

multivector dense_algebra::left_contraction(const multivector &a, const multivector &b) const {
  return product(a, b, true);
}

multivector dense_algebra::meet(const multivector &x, const multivector &y) const {
  return meet(x, y, pseudoscalar());
}

multivector dense_algebra::meet(const multivector &x, const multivector &y, const multivector &pseudo) const {
  return left_contraction(geometric(pseudo, x), y);
}

} // namespace meetc::oracle
