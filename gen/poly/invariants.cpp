#include "gen/poly/invariants.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace meetc::poly {
namespace {

using vector_degrees = std::vector<int>;

class finder {
public:
  finder(const local_origin &f, const poly &p) : f_(f), p_(p) {}

  std::optional<vector_form> run() {
    if (!collect_vectors())
      return std::nullopt;
    // Groups terms by their bare numbers and by their degree in each vector.
    std::map<std::pair<monomial, vector_degrees>, std::vector<term>> classes;
    for (const term &t : p_.terms()) {
      monomial numbers, components;
      vector_degrees degrees(vectors_.size());
      for (const power &q : t.factors) {
        const int v = f_.info(q.variable).vector;
        if (v < 0) {
          numbers.push_back(q);
        } else {
          components.push_back(q);
          degrees[place(v)] += q.exponent;
        }
      }
      classes[{numbers, degrees}].push_back({t.coefficient, components});
    }
    std::vector<term> form;
    for (const auto &[key, terms] : classes)
      if (!solve(key.first, key.second, poly::from_terms(f_.local(), terms), form))
        return std::nullopt;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < invariants_.size(); ++i)
      names.push_back('q' + std::to_string(i));
    auto symbols = std::make_shared<ring>(names);
    return vector_form{symbols, invariants_, poly::from_terms(*symbols, form)};
  }

private:
  const local_origin &f_;
  const poly &p_;
  std::vector<int> vectors_;
  std::vector<invariant> invariants_;
  std::map<std::array<int, 4>, int> ids_;

  std::size_t place(int vector) const {
    return static_cast<std::size_t>(std::find(vectors_.begin(), vectors_.end(), vector) - vectors_.begin());
  }
  bool collect_vectors() {
    std::set<int> used;
    for (const int v : p_.variables())
      if (f_.info(v).vector >= 0)
        used.insert(f_.info(v).vector);
    vectors_.assign(used.begin(), used.end());
    return !vectors_.empty() && vectors_.size() <= 4;
  }
  int id_of(invariant::type kind, int i, int j, int k) {
    const auto [it, fresh] = ids_.try_emplace({static_cast<int>(kind), i, j, k}, static_cast<int>(invariants_.size()));
    if (fresh)
      invariants_.push_back({kind, i, j, k});
    return it->second;
  }
  poly component(std::size_t vector, std::size_t axis) const {
    return poly::variable(f_.local(), f_.vector(vectors_[vector])[axis]);
  }
  poly expand(const invariant &q) const {
    poly sum(f_.local());
    const auto at = [&](int v) { return place(v); };
    const std::size_t dimension = f_.vector(vectors_[0]).size();
    if (q.kind == invariant::type::dot) {
      for (std::size_t a = 0; a < dimension; ++a)
        sum = sum + component(at(q.i), a) * component(at(q.j), a);
      return sum;
    }
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      sum = sum + component(at(q.i), a) *
                      (component(at(q.j), b) * component(at(q.k), c) - component(at(q.j), c) * component(at(q.k), b));
    }
    return sum;
  }

  // All products of dot products (and at most one triple product) with the wanted degree in each vector.
  void products(vector_degrees left, std::size_t from_i, std::size_t from_j, std::vector<int> chosen,
                std::vector<std::vector<int>> &out) {
    std::size_t i = 0;
    while (i < left.size() && left[i] == 0)
      ++i;
    if (i == left.size()) {
      out.push_back(std::move(chosen));
      return;
    }
    for (std::size_t j = i; j < left.size(); ++j) {
      if (i == from_i && j < from_j)
        continue;
      if (left[j] < (i == j ? 2 : 1))
        continue;
      vector_degrees next = left;
      --next[i];
      --next[j];
      std::vector<int> more = chosen;
      more.push_back(id_of(invariant::type::dot, vectors_[i], vectors_[j], -1));
      products(std::move(next), i, j, std::move(more), out);
    }
  }

  bool solve(const monomial &numbers, const vector_degrees &degrees, const poly &target, std::vector<term> &form) {
    int total = 0;
    for (const int d : degrees)
      total += d;
    std::vector<std::vector<int>> candidates;
    if (total % 2 == 0) {
      products(degrees, 0, 0, {}, candidates);
    } else if (f_.vector(vectors_[0]).size() == 3) {
      for (std::size_t i = 0; i < degrees.size(); ++i)
        for (std::size_t j = i + 1; j < degrees.size(); ++j)
          for (std::size_t k = j + 1; k < degrees.size(); ++k)
            if (degrees[i] && degrees[j] && degrees[k]) {
              vector_degrees left = degrees;
              --left[i], --left[j], --left[k];
              products(left, 0, 0, {id_of(invariant::type::triple, vectors_[i], vectors_[j], vectors_[k])}, candidates);
            }
    }
    if (candidates.size() > 200)
      return false;
    // Columns are the candidates and then the target; rows are monomials.
    std::map<monomial, std::size_t> row_of;
    std::vector<std::vector<rational>> rows;
    const std::size_t width = candidates.size() + 1;
    const auto fill = [&](const poly &p, std::size_t column) {
      for (const term &t : p.terms()) {
        const auto [it, fresh] = row_of.try_emplace(t.factors, rows.size());
        if (fresh)
          rows.emplace_back(width);
        rows[it->second][column] += t.coefficient;
      }
    };
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      poly product(f_.local(), 1);
      for (const int q : candidates[c])
        product = product * expand(invariants_[static_cast<std::size_t>(q)]);
      fill(product, c);
    }
    fill(target, width - 1);
    std::vector<std::size_t> pivot_row(candidates.size(), rows.size());
    std::size_t next = 0;
    for (std::size_t c = 0; c < candidates.size() && next < rows.size(); ++c) {
      std::size_t r = next;
      while (r < rows.size() && rows[r][c] == 0)
        ++r;
      if (r == rows.size())
        continue;
      std::swap(rows[r], rows[next]);
      const rational inverse = 1 / rows[next][c];
      for (rational &x : rows[next])
        x *= inverse;
      for (std::size_t other = 0; other < rows.size(); ++other)
        if (other != next && rows[other][c] != 0) {
          const rational factor = rows[other][c];
          for (std::size_t k = c; k < width; ++k)
            if (rows[next][k] != 0)
              rows[other][k] -= factor * rows[next][k];
        }
      pivot_row[c] = next++;
    }
    for (std::size_t r = next; r < rows.size(); ++r)
      if (rows[r][width - 1] != 0)
        return false; // not a rotation invariant
    std::vector<power> prefix;
    for (const power &q : numbers)
      prefix.push_back({id_of(invariant::type::number, q.variable, -1, -1), q.exponent});
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (pivot_row[c] == rows.size() || rows[pivot_row[c]][width - 1] == 0)
        continue;
      std::map<int, int> powers;
      for (const power &q : prefix)
        powers[q.variable] += q.exponent;
      for (const int q : candidates[c])
        ++powers[q];
      term t{rows[pivot_row[c]][width - 1], {}};
      for (const auto &[v, e] : powers)
        t.factors.push_back({v, e});
      form.push_back(std::move(t));
    }
    return true;
  }
};

// Replaces every multiple of `lead` (a monomial) in f by the same multiple of `image`.
poly rewrite(poly f, const monomial &lead, const poly &image) {
  for (;;) {
    std::vector<term> kept, quotient;
    for (const term &t : f.terms()) {
      std::map<int, int> powers;
      for (const power &q : t.factors)
        powers[q.variable] = q.exponent;
      const bool divisible =
          std::all_of(lead.begin(), lead.end(), [&](const power &q) { return powers[q.variable] >= q.exponent; });
      if (!divisible) {
        kept.push_back(t);
        continue;
      }
      for (const power &q : lead)
        powers[q.variable] -= q.exponent;
      term rest{t.coefficient, {}};
      for (const auto &[v, e] : powers)
        if (e)
          rest.factors.push_back({v, e});
      quotient.push_back(std::move(rest));
    }
    if (quotient.empty())
      return f;
    f = poly::from_terms(f.in(), kept) + poly::from_terms(f.in(), quotient) * image;
  }
}

struct rule {
  monomial lead;
  poly image;
};

// The form in a ring with one more symbol for each added invariant, and the rules that introduce them.
vector_form with_symbols(const vector_form &v, const std::vector<invariant> &added) {
  std::vector<std::string> names = v.symbols->names();
  vector_form out{nullptr, v.invariants, poly(*v.symbols)};
  for (const invariant &q : added) {
    names.push_back('q' + std::to_string(names.size()));
    out.invariants.push_back(q);
  }
  out.symbols = std::make_shared<ring>(names);
  out.form = poly::from_terms(*out.symbols, v.form.terms());
  return out;
}

} // namespace

std::vector<vector_form> vector_forms(const local_origin &f, const poly &p) {
  const auto plain = finder(f, p).run();
  if (!plain)
    return {};
  std::vector<vector_form> out{*plain};
  std::set<int> used;
  const auto dot = [&](const vector_form &v, int i, int j) {
    for (std::size_t s = 0; s < v.invariants.size(); ++s) {
      const invariant &q = v.invariants[s];
      if (q.kind == invariant::type::dot && q.i == std::min(i, j) && q.j == std::max(i, j))
        return static_cast<int>(s);
    }
    return -1;
  };
  for (const invariant &q : plain->invariants)
    if (q.kind == invariant::type::dot)
      used.insert({q.i, q.j});
  const std::vector<int> vectors(used.begin(), used.end());
  if (vectors.empty() || f.vector(vectors[0]).size() != 3)
    return out;
  const auto symbol = [](const vector_form &v, int s) { return poly::variable(*v.symbols, s); };
  // (v_i . v_j)^2 = v_i^2 v_j^2 - |v_i x v_j|^2
  const auto cross = [&](const vector_form &base, int i, int j) -> std::optional<vector_form> {
    if (dot(base, i, j) < 0 || dot(base, i, i) < 0 || dot(base, j, j) < 0)
      return std::nullopt;
    vector_form v = with_symbols(base, {{invariant::type::cross_squared, i, j, -1}});
    const poly image =
        symbol(v, dot(v, i, i)) * symbol(v, dot(v, j, j)) - symbol(v, static_cast<int>(v.invariants.size()) - 1);
    v.form = rewrite(v.form, {{dot(v, i, j), 2}}, image);
    return v;
  };
  // v_i^2 v_j^2 v_k^2 = [v_i v_j v_k]^2 - 2 (ij)(jk)(ik) + v_i^2 (jk)^2 + v_j^2 (ik)^2 + v_k^2 (ij)^2
  const auto triple = [&](const vector_form &base, int i, int j, int k) -> std::optional<vector_form> {
    const int ii = dot(base, i, i), jj = dot(base, j, j), kk = dot(base, k, k);
    const int ij = dot(base, i, j), jk = dot(base, j, k), ik = dot(base, i, k);
    if (std::min({ii, jj, kk, ij, jk, ik}) < 0)
      return std::nullopt;
    vector_form v = with_symbols(base, {{invariant::type::triple, i, j, k}});
    const poly t = symbol(v, static_cast<int>(v.invariants.size()) - 1);
    const poly image = t * t - (symbol(v, ij) * symbol(v, jk) * symbol(v, ik)).scaled(2) +
                       symbol(v, ii) * symbol(v, jk) * symbol(v, jk) + symbol(v, jj) * symbol(v, ik) * symbol(v, ik) +
                       symbol(v, kk) * symbol(v, ij) * symbol(v, ij);
    monomial lead{{ii, 1}, {jj, 1}, {kk, 1}};
    std::sort(lead.begin(), lead.end());
    v.form = rewrite(v.form, lead, image);
    return v;
  };
  std::vector<vector_form> starts{*plain};
  for (std::size_t a = 0; a < vectors.size(); ++a)
    for (std::size_t b = a + 1; b < vectors.size(); ++b)
      for (std::size_t c = b + 1; c < vectors.size(); ++c)
        if (auto v = triple(*plain, vectors[a], vectors[b], vectors[c]))
          starts.push_back(*v);
  for (const vector_form &start : starts) {
    if (&start != &starts.front())
      out.push_back(start);
    for (std::size_t a = 0; a < vectors.size(); ++a)
      for (std::size_t b = a + 1; b < vectors.size(); ++b)
        if (auto v = cross(start, vectors[a], vectors[b]))
          out.push_back(*v);
  }
  return out;
}

} // namespace meetc::poly
