#include "gen/lower/expand/model.hpp"
#include "gen/lower/expand/expand.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::lower {
namespace {

using matrix = std::vector<std::vector<rational>>;

matrix identity(std::size_t n) {
  matrix m(n, std::vector<rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    m[i][i] = 1;
  return m;
}

matrix parse_metric(const lang::algebra &a) {
  matrix m(a.vectors.size());
  for (std::size_t i = 0; i < m.size(); ++i)
    for (const std::string &text : a.metric[i]) {
      m[i].emplace_back(text);
      m[i].back().canonicalize();
    }
  return m;
}

matrix multiply(const matrix &a, const matrix &b, bool transposed) {
  const std::size_t n = a.size();
  matrix out(n, std::vector<rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k)
        out[i][j] += a[i][k] * (transposed ? b[j][k] : b[k][j]);
  return out;
}

// Gauss-Jordan elimination. Returns false where m is singular.
bool invert(matrix m, matrix &out) {
  const std::size_t n = m.size();
  out = identity(n);
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && m[pivot][c] == 0)
      ++pivot;
    if (pivot == n)
      return false;
    std::swap(m[c], m[pivot]);
    std::swap(out[c], out[pivot]);
    const rational inverse = 1 / m[c][c];
    for (std::size_t j = 0; j < n; ++j) {
      m[c][j] *= inverse;
      out[c][j] *= inverse;
    }
    for (std::size_t r = 0; r < n; ++r)
      if (r != c && m[r][c] != 0) {
        const rational f = m[r][c];
        for (std::size_t j = 0; j < n; ++j) {
          m[r][j] -= f * m[c][j];
          out[r][j] -= f * out[c][j];
        }
      }
  }
  return true;
}

// The blades of the algebra's `order` that are made of these vectors, by their numbers.
std::vector<std::vector<int>> order_of(const lang::algebra &a, const std::vector<std::string> &vectors) {
  std::vector<std::vector<int>> out;
  for (const lang::ordered_blade &b : a.order) {
    std::vector<int> numbers;
    for (const std::string &v : b.vectors) {
      const auto at = std::find(vectors.begin(), vectors.end(), v);
      if (at != vectors.end())
        numbers.push_back(static_cast<int>(at - vectors.begin()));
    }
    if (numbers.size() == b.vectors.size())
      out.push_back(std::move(numbers));
  }
  return out;
}

} // namespace

model::model(const lang::algebra &a)
    : spec_(a), declared_(a.vectors, parse_metric(a), order_of(a, a.vectors)), working_(declared_),
      to_working_(identity(a.vectors.size())), to_declared_(to_working_) {
  if (a.null.empty())
    return;
  // The null vectors, in the declared basis. They replace the declared vectors that they use.
  const poly::ring none({});
  decision unused;
  expander declared(*this, none, unused, declared_, identity(a.vectors.size()));
  const std::size_t n = a.vectors.size();
  std::vector<bool> used(n);
  matrix rows;
  std::vector<std::string> names;
  matrix null_rows;
  for (const lang::named_expr &v : a.null) {
    const multivector m = declared.evaluate_multivector(*v.body, {});
    std::vector<rational> row(n);
    for (const auto &[at, c] : m.terms()) {
      if (algebra::grade(at) != 1)
        throw spec_error(v.where, fmt::format("null vector '{}' is not a vector", v.name));
      for (std::size_t i = 0; i < n; ++i)
        if (at == blade{1} << i) {
          row[i] = c.constant();
          used[i] = true;
        }
    }
    null_rows.push_back(row);
  }
  for (std::size_t i = 0; i < n; ++i)
    if (!used[i]) {
      rows.push_back(identity(n)[i]);
      names.push_back(a.vectors[i]);
    }
  for (std::size_t i = 0; i < null_rows.size(); ++i) {
    rows.push_back(null_rows[i]);
    names.push_back(a.null[i].name);
  }
  if (rows.size() != n || !invert(rows, to_working_))
    throw spec_error(a.null.front().where, "the null vectors and the vectors that they leave are not a basis");
  to_declared_ = rows;
  for (const lang::ordered_blade &b : a.order)
    for (const std::string &v : b.vectors)
      if (std::find(names.begin(), names.end(), v) == names.end())
        throw spec_error(b.where, fmt::format("'{}' is none of the vectors that blades are made of, since null vectors "
                                              "replace it; 'order' lists blades of {}",
                                              v, join(names, ", ")));
  working_ = metric(names, multiply(multiply(rows, parse_metric(a), false), rows, true), order_of(a, names));
}

std::vector<basis_blade> named(const metric &m, const std::vector<blade> &blades) {
  std::vector<basis_blade> out;
  for (const blade b : blades) {
    basis_blade of;
    for (const int i : m.factors(b))
      of.vectors.push_back(m.names()[static_cast<std::size_t>(i)]);
    out.push_back(std::move(of));
  }
  return out;
}

multivector model::in_working(const multivector &m) const {
  return algebra::outermorphism(declared_, m, working_, to_working_);
}
multivector model::in_declared(const multivector &m) const {
  return algebra::outermorphism(working_, m, declared_, to_declared_);
}

kind_layout model::layout(const lang::kind &k) const {
  kind_layout out{&k, {}, 0, 0};
  for (const lang::field &f : k.store) {
    if (f.type == "real") {
      out.reals.push_back({f.name, -1, 0, false});
      continue;
    }
    const lang::kind &part = *spec_.find_kind(f.type);
    const kind_layout inner = layout(part);
    for (stored_real r : inner.reals) {
      r.path = f.name + '.' + r.path;
      if (r.group >= 0)
        r.group += out.groups;
      out.reals.push_back(std::move(r));
    }
    out.groups += inner.groups;
    out.points += inner.points;
  }
  // A kind that is nothing but one real for each axis of space is one group: a point or a direction.
  const lang::named_expr *axes = spec_.find_constant("axes");
  const std::size_t dimension = axes && axes->body->kind == lang::op::list ? axes->body->args.size() : 0;
  bool bare = k.position || (k.store.size() == dimension && dimension > 0);
  for (const lang::field &f : k.store)
    bare = bare && f.type == "real";
  if (bare) {
    for (std::size_t i = 0; i < out.reals.size(); ++i) {
      out.reals[i].group = 0;
      out.reals[i].axis = static_cast<int>(i);
      out.reals[i].position = k.position;
    }
    out.groups = 1;
    out.points = k.position ? 1 : 0;
  }
  return out;
}

const lang::kind &model::kind(const std::string &name, const location &where) const {
  if (const lang::kind *k = spec_.find_kind(name))
    return *k;
  throw spec_error(where, fmt::format("no kind '{}'; kinds: {}{}", name, join(spec_.kind_names(), ", "),
                                      nearest(name, spec_.kind_names())));
}

} // namespace meetc::lower
