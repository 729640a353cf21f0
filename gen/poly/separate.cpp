#include "gen/poly/separate.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace meetc::poly {
namespace {

using row = std::map<std::size_t, rational>; // by column, without zeros
using matrix = std::vector<row>;

// FLINT's order of terms: higher degree first, then higher power of the earlier variable.
bool precedes(const monomial &a, const monomial &b) {
  const auto degree = [](const monomial &m) {
    return std::accumulate(m.begin(), m.end(), 0, [](int sum, const power &f) { return sum + f.exponent; });
  };
  if (degree(a) != degree(b))
    return degree(a) > degree(b);
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i].variable != b[i].variable)
      return a[i].variable < b[i].variable;
    if (a[i].exponent != b[i].exponent)
      return a[i].exponent > b[i].exponent;
  }
  return a.size() > b.size();
}

void subtract(row &from, const rational &factor, const row &what) {
  for (const auto &[column, c] : what) {
    const auto it = from.try_emplace(column, 0).first;
    it->second -= factor * c;
    if (it->second == 0)
      from.erase(it);
  }
}

// Independent rows of a matrix, and every row as a combination of them.
struct skeleton {
  std::vector<std::size_t> kept; // ascending
  std::vector<row> combination;  // by row: coefficients by the index of the kept row
};

skeleton skeleton_of(const matrix &m) {
  struct pivot {
    row rest, made_of; // rest = the combination made_of of rows of m
  };
  std::map<std::size_t, pivot> pivots; // by the first column of rest
  std::vector<std::size_t> order(m.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Rows with few monomials are kept first.
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return m[a].size() < m[b].size(); });
  skeleton out{{}, std::vector<row>(m.size())};
  for (const std::size_t i : order) {
    pivot p{m[i], {{i, 1}}};
    while (!p.rest.empty()) {
      const auto known = pivots.find(p.rest.begin()->first);
      if (known == pivots.end())
        break;
      const rational factor = p.rest.begin()->second / known->second.rest.begin()->second;
      subtract(p.rest, factor, known->second.rest);
      subtract(p.made_of, factor, known->second.made_of);
    }
    if (p.rest.empty()) {
      p.made_of.erase(i);
      subtract(out.combination[i], 1, p.made_of);
      continue;
    }
    out.kept.push_back(i);
    out.combination[i] = {{i, 1}};
    pivots.emplace(p.rest.begin()->first, std::move(p));
  }
  std::sort(out.kept.begin(), out.kept.end());
  return out;
}

std::size_t rank(const matrix &m) {
  return skeleton_of(m).kept.size();
}

matrix transposed(const matrix &m, std::size_t columns) {
  matrix out(columns);
  for (std::size_t i = 0; i < m.size(); ++i)
    for (const auto &[column, c] : m[i])
      out[column].emplace(i, c);
  return out;
}

// m as the sum over k of (column k of `left`) times (row k of `right`).
struct factored {
  matrix left, right; // both indexed by k

  std::size_t monomials() const {
    std::size_t sum = 0;
    for (const matrix *side : {&left, &right})
      for (const row &r : *side)
        sum += r.size();
    return sum;
  }
};

factored by_rows(const matrix &m) {
  const skeleton s = skeleton_of(m);
  factored out;
  for (const std::size_t k : s.kept) {
    out.right.push_back(m[k]);
    row column;
    for (std::size_t i = 0; i < m.size(); ++i)
      if (const auto it = s.combination[i].find(k); it != s.combination[i].end())
        column.emplace(i, it->second);
    out.left.push_back(std::move(column));
  }
  return out;
}

// Monomials of one side, sorted.
std::vector<monomial> sorted(std::vector<monomial> all) {
  std::sort(all.begin(), all.end(), precedes);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

poly over(const ring &r, const std::vector<monomial> &monomials, const row &coefficients) {
  std::vector<term> terms;
  for (const auto &[i, c] : coefficients)
    terms.push_back({c, monomials[i]});
  return poly::from_terms(r, terms);
}

} // namespace

separation separate(const poly &p, int first_of_y) {
  const ring &r = p.in();
  const std::vector<term> terms = p.terms();
  std::vector<std::pair<monomial, monomial>> split;
  std::vector<monomial> xs, ys;
  for (const term &t : terms) {
    const auto border =
        std::find_if(t.factors.begin(), t.factors.end(), [&](const power &f) { return f.variable >= first_of_y; });
    split.emplace_back(monomial(t.factors.begin(), border), monomial(border, t.factors.end()));
    xs.push_back(split.back().first);
    ys.push_back(split.back().second);
  }
  xs = sorted(std::move(xs));
  ys = sorted(std::move(ys));
  const auto place = [](const std::vector<monomial> &all, const monomial &m) {
    return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), m, precedes) - all.begin());
  };
  matrix m(xs.size());
  for (std::size_t i = 0; i < terms.size(); ++i)
    m[place(xs, split[i].first)].emplace(place(ys, split[i].second), terms[i].coefficient);

  separation out{{}, poly(r), poly(r)};
  // The monomial 1 comes last. Its column is an additive term if the rank is one less without it; the same goes for its
  // row.
  std::size_t least = rank(m);
  if (!ys.empty() && ys.back().empty()) {
    matrix without = m;
    row column;
    for (std::size_t i = 0; i < m.size(); ++i)
      if (const auto it = without[i].find(ys.size() - 1); it != without[i].end()) {
        column.emplace(i, it->second);
        without[i].erase(it);
      }
    if (rank(without) < least) {
      out.of_x = over(r, xs, column);
      m = std::move(without);
      --least;
    }
  }
  if (!xs.empty() && xs.back().empty()) {
    matrix without = m;
    without.back().clear();
    if (rank(without) < least) {
      out.of_y = over(r, ys, m.back());
      m = std::move(without);
    }
  }

  factored rows = by_rows(m), columns = by_rows(transposed(m, ys.size()));
  std::swap(columns.left, columns.right);
  const factored &best = rows.monomials() <= columns.monomials() ? rows : columns;
  for (std::size_t k = 0; k < best.left.size(); ++k) {
    const auto [content, f] = over(r, xs, best.left[k]).primitive();
    out.products.push_back({f, over(r, ys, best.right[k]).scaled(content)});
  }
  return out;
}

poly to_poly(const separation &s) {
  poly sum = s.of_x + s.of_y;
  for (const product &k : s.products)
    sum = sum + k.f * k.g;
  return sum;
}

} // namespace meetc::poly
