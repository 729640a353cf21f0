#include "tests/gen/fuzz/space.hpp"

#include "tests/gen/oracle/random.hpp"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <stdexcept>

namespace meetc::fuzz {
namespace {

using numbers = std::vector<rational>;

// The blades that a kind by grades has, in the order of what it stores.
std::vector<std::size_t> blades_where(std::size_t all, const std::function<bool(int)> &grade) {
  std::vector<std::size_t> out;
  for (std::size_t b = 0; b < all; ++b)
    if (grade(std::popcount(b)))
      out.push_back(b);
  return out;
}

struct by_grades {
  std::string name;
  std::vector<std::size_t> blades;
};
std::vector<by_grades> kinds_by_grades(int vectors) {
  const std::size_t all = std::size_t{1} << vectors;
  std::vector<by_grades> out;
  for (int g = 1; g < vectors; ++g)
    out.push_back({fmt::format("g{}", g), blades_where(all, [g](int of) { return of == g; })});
  out.push_back({"even", blades_where(all, [](int of) { return of % 2 == 0; })});
  out.push_back({"odd", blades_where(all, [](int of) { return of % 2 == 1; })});
  out.push_back({"full", blades_where(all, [](int) { return true; })});
  return out;
}

// "e1^e2", "1".
std::string text_of(const std::vector<std::string> &vectors, std::size_t blade) {
  std::string out;
  for (std::size_t i = 0; i < vectors.size(); ++i)
    if (blade >> i & 1)
      out += (out.empty() ? "" : "^") + vectors[i];
  return out.empty() ? "1" : out;
}

multivector sum(std::initializer_list<std::pair<rational, multivector>> terms) {
  multivector out(terms.begin()->second.size());
  for (const auto &[c, m] : terms)
    out = oracle::add(out, oracle::scale(c, m));
  return out;
}

space conformal_plane() {
  space s("cga2", {"o", "e1", "e2", "n"}, {{0, 0, 0, -1}, {0, 1, 0, 0}, {0, 0, 1, 0}, {-1, 0, 0, 0}});
  s.add_by_grades();
  const auto point = [](const space &in, const numbers &x, std::size_t at) {
    return sum({{1, in.vector("o")},
                {x[at], in.vector("e1")},
                {x[at + 1], in.vector("e2")},
                {(x[at] * x[at] + x[at + 1] * x[at + 1]) / 2, in.vector("n")}});
  };
  s.add({"point", 2, [point](const space &in, const numbers &x) { return point(in, x, 0); }});
  s.add({"line", 4, [point](const space &in, const numbers &x) {
           return oracle::outer(oracle::outer(point(in, x, 0), point(in, x, 2)), in.vector("n"));
         }});
  return s;
}

space conformal_space() {
  oracle::matrix metric(5, std::vector<rational>(5));
  for (std::size_t i = 0; i < 5; ++i)
    metric[i][i] = i < 4 ? 1 : -1;
  space s("cga3", {"e1", "e2", "e3", "e", "eb"}, metric, {{"n", {0, 0, 0, 1, 1}}, {"nb", {0, 0, 0, 1, -1}}});
  s.add_by_grades();
  const auto point = [](const space &in, const numbers &x, std::size_t at) {
    const rational square = x[at] * x[at] + x[at + 1] * x[at + 1] + x[at + 2] * x[at + 2];
    return sum({{2 * x[at], in.vector("e1")},
                {2 * x[at + 1], in.vector("e2")},
                {2 * x[at + 2], in.vector("e3")},
                {square + 0, in.vector("n")},
                {-1, in.vector("nb")}});
  };
  s.add({"point", 3, [point](const space &in, const numbers &x) { return point(in, x, 0); }});
  s.add({"sphere", 4, [point](const space &in, const numbers &x) {
           const multivector dual = sum({{1, point(in, x, 0)}, {-x[3] * x[3], in.vector("n")}});
           return oracle::scale(-1, in.algebra().geometric(in.vector("I"), dual));
         }});
  s.add({"line", 6, [point](const space &in, const numbers &x) {
           return oracle::outer(oracle::outer(point(in, x, 0), point(in, x, 3)), in.vector("n"));
         }});
  return s;
}

space plane_based_space() {
  oracle::matrix metric(4, std::vector<rational>(4));
  for (std::size_t i = 1; i < 4; ++i)
    metric[i][i] = 1;
  space s("pga3", {"e0", "e1", "e2", "e3"}, metric);
  s.add_by_grades();
  s.add({"plane", 4, [](const space &in, const numbers &x) {
           return sum(
               {{x[0], in.vector("e1")}, {x[1], in.vector("e2")}, {x[2], in.vector("e3")}, {x[3], in.vector("e0")}});
         }});
  s.add({"point", 3, [](const space &in, const numbers &x) {
           return sum({{1, in.blade({"e1", "e2", "e3"})},
                       {-x[0], in.blade({"e0", "e2", "e3"})},
                       {-x[1], in.blade({"e0", "e3", "e1"})},
                       {-x[2], in.blade({"e0", "e1", "e2"})}});
         }});
  s.add({"motor", 8, [](const space &in, const numbers &x) {
           return sum({{x[0], in.blade({})},
                       {x[1], in.blade({"e2", "e3"})},
                       {x[2], in.blade({"e3", "e1"})},
                       {x[3], in.blade({"e1", "e2"})},
                       {x[4], in.blade({"e0", "e1"})},
                       {x[5], in.blade({"e0", "e2"})},
                       {x[6], in.blade({"e0", "e3"})},
                       {x[7], in.vector("I")}});
         }});
  return s;
}

space three_and_three() {
  oracle::matrix metric(6, std::vector<rational>(6));
  for (std::size_t i = 0; i < 6; ++i)
    metric[i][i] = i < 3 ? 1 : -1;
  space s("r33", {"e1", "e2", "e3", "f1", "f2", "f3"}, metric);
  s.add_by_grades();
  return s;
}

// A multivector on other vectors: vector i becomes row i.
multivector on_rows(const multivector &m, const std::vector<std::vector<rational>> &rows) {
  multivector out(m.size());
  for (std::size_t b = 0; b < m.size(); ++b) {
    if (m[b] == 0)
      continue;
    multivector term(m.size());
    term[0] = m[b];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!(b >> i & 1))
        continue;
      multivector v(m.size());
      for (std::size_t j = 0; j < rows.size(); ++j)
        v[std::size_t{1} << j] = rows[i][j];
      term = oracle::outer(term, v);
    }
    out = oracle::add(out, term);
  }
  return out;
}

} // namespace

space::space(std::string name, std::vector<std::string> vectors, const oracle::matrix &metric,
             std::vector<std::pair<std::string, std::vector<rational>>> null)
    : name_(std::move(name)), vectors_(std::move(vectors)), working_(vectors_), algebra_(metric), orthogonal_(true) {
  for (std::size_t i = 0; i < metric.size(); ++i)
    for (std::size_t j = 0; j < metric.size(); ++j)
      orthogonal_ = orthogonal_ && (i == j || metric[i][j] == 0);
  for (std::size_t i = 0; i < vectors_.size(); ++i)
    known_.emplace_back(vectors_[i], algebra_.vector(static_cast<int>(i)));
  known_.emplace_back("I", algebra_.pseudoscalar());
  if (null.empty())
    return;
  // The last two vectors become their sum s and their difference d, so that they are (s + d)/2 and (s - d)/2.
  const std::size_t n = vectors_.size();
  declared_in_working_.assign(n, std::vector<rational>(n));
  for (std::size_t i = 0; i + 2 < n; ++i)
    declared_in_working_[i][i] = 1;
  const rational half(1, 2);
  declared_in_working_[n - 2][n - 2] = declared_in_working_[n - 2][n - 1] = declared_in_working_[n - 1][n - 2] = half;
  declared_in_working_[n - 1][n - 1] = -half;
  for (std::size_t i = 0; i < 2; ++i) {
    multivector v = algebra_.zero();
    for (std::size_t j = 0; j < n; ++j)
      v[std::size_t{1} << j] = null[i].second[j];
    known_.emplace_back(null[i].first, v);
    null_.push_back(null[i].first);
    working_[n - 2 + i] = null[i].first;
  }
}

const kind &space::find(const std::string &name) const {
  const auto it = std::find_if(kinds_.begin(), kinds_.end(), [&](const kind &k) { return k.name == name; });
  if (it == kinds_.end())
    throw std::out_of_range("no kind " + name);
  return *it;
}

void space::add(kind k) {
  oracle_test::random_numbers random(7);
  k.support.assign(algebra_.size(), false);
  for (int round = 0; round < 3; ++round) {
    std::vector<rational> x;
    for (std::size_t i = 0; i < k.stored; ++i)
      x.push_back(random.fraction(50));
    const multivector m = k.blade(*this, x);
    for (std::size_t b = 0; b < m.size(); ++b)
      k.support[b] = k.support[b] || m[b] != 0;
  }
  for (std::size_t b = 0; b < k.support.size(); ++b)
    if (k.support[b])
      k.grade = k.grade == -1 || k.grade == std::popcount(b) ? std::popcount(b) : -2;
  k.grade = std::max(k.grade, -1);
  kinds_.push_back(std::move(k));
}

void space::add_by_grades() {
  for (const by_grades &k : kinds_by_grades(algebra_.dimension()))
    add({k.name, k.blades.size(), [blades = k.blades](const space &in, const numbers &x) {
           multivector m = in.algebra().zero();
           for (std::size_t i = 0; i < blades.size(); ++i)
             m[blades[i]] = x[i];
           return m;
         }});
}

const multivector &space::vector(const std::string &name) const {
  for (const auto &[known, value] : known_)
    if (known == name)
      return value;
  throw std::out_of_range("no vector " + name);
}

multivector space::blade(const std::vector<std::string> &vectors) const {
  multivector out = algebra_.scalar(1);
  for (const std::string &v : vectors)
    out = oracle::outer(out, vector(v));
  return out;
}

multivector space::in_working(const multivector &declared) const {
  return declared_in_working_.empty() ? declared : on_rows(declared, declared_in_working_);
}

std::size_t space::working_blade(const std::vector<std::string> &vectors) const {
  std::size_t out = 0;
  for (const std::string &v : vectors)
    out |= std::size_t{1} << (std::find(working_.begin(), working_.end(), v) - working_.begin());
  return out;
}

std::string space::general_text() const {
  std::string out;
  for (const by_grades &k : kinds_by_grades(algebra_.dimension())) {
    std::string store, blade;
    for (std::size_t i = 0; i < k.blades.size(); ++i) {
      store += fmt::format("{}'c{}: real'", i ? ", " : "", i);
      blade += fmt::format("{}c{}*({})", i ? " + " : "", i, text_of(vectors_, k.blades[i]));
    }
    out += fmt::format("[kinds.{}]\nstore = [{}]\nblade = '{}'\n", k.name, store, blade);
  }
  return out;
}

const std::vector<space> &spaces() {
  static const std::vector<space> all{conformal_plane(), conformal_space(), plane_based_space(), three_and_three()};
  return all;
}

} // namespace meetc::fuzz
