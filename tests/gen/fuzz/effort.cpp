// How long a formula becomes: numbers of terms by blade, from above.
#include "tests/gen/fuzz/draw.hpp"
#include "tests/gen/fuzz/evaluate.hpp"

#include <algorithm>
#include <bit>
#include <map>

namespace meetc::fuzz {
namespace {

// For each pair of blades, those in their product.
class table {
public:
  explicit table(const space &s) : in_(s), of_(s.algebra().size() * s.algebra().size()), known_(of_.size(), false) {}
  const std::vector<std::size_t> &product(std::size_t a, std::size_t b) {
    const std::size_t at = a * in_.algebra().size() + b;
    if (!known_[at]) {
      multivector x = in_.algebra().zero(), y = x;
      x[a] = y[b] = 1;
      const multivector z = in_.algebra().geometric(x, y);
      for (std::size_t c = 0; c < z.size(); ++c)
        if (z[c] != 0)
          of_[at].push_back(c);
      known_[at] = true;
    }
    return of_[at];
  }

private:
  const space &in_;
  std::vector<std::vector<std::size_t>> of_;
  std::vector<bool> known_;
};

table &table_of(const space &s) {
  static std::map<const space *, table> all;
  return all.try_emplace(&s, s).first->second;
}

// Numbers of terms by blade, as if nothing cancelled.
class sizes {
public:
  using value = std::vector<double>;
  explicit sizes(const space &s) : space_(s), table_(table_of(s)), blades_(s.algebra().size()) {}
  effort spent{0, 0};

  value number(const rational &) const { return one(0); }
  value blade(const std::vector<std::string> &vectors) const {
    const multivector m = space_.blade(vectors);
    value out(blades_);
    for (std::size_t b = 0; b < blades_; ++b)
      out[b] = m[b] != 0;
    return out;
  }
  value add(const value &a, const value &b) const {
    value out = a;
    for (std::size_t i = 0; i < blades_; ++i)
      out[i] += b[i];
    return out;
  }
  value subtract(const value &a, const value &b) const { return add(a, b); }
  value scale(const rational &, const value &a) const { return a; }
  value geometric(const value &a, const value &b) {
    return product(a, b, [](int, int, int) { return true; });
  }
  value outer(const value &a, const value &b) {
    return product(a, b, [](int x, int y, int z) { return z == x + y; });
  }
  value inner(const value &a, const value &b) {
    return product(a, b, [](int x, int y, int z) { return z == y - x; });
  }
  value reverse(const value &a) const { return a; }
  value involute(const value &a) const { return a; }
  value inverse(const value &a) const { return a; }
  value grade_part(value a, int k) const {
    for (std::size_t b = 0; b < blades_; ++b)
      if (std::popcount(b) != k)
        a[b] = 0;
    return a;
  }
  value complement(const value &a, bool) const { return {a.rbegin(), a.rend()}; }
  value dual(const value &a, bool) const { return complement(a, true); }
  value dot(const value &a, const value &b) {
    return product(a, b, [](int x, int y, int z) { return z == y - x || z == x - y; });
  }
  value versor(const value &v, const value &x) { return geometric(geometric(v, x), v); }
  value scalar_part(const value &a) const { return one(0, a[0]); }
  value coefficient(const value &a, const value &along) const {
    double most = 0;
    for (std::size_t b = 0; b < blades_; ++b)
      if (along[b] != 0)
        most = std::max(most, a[b]);
    return one(0, most);
  }
  value meet(const value &a, const value &b) {
    return space_.name() == "pga3" ? outer(a, b) : inner(geometric(one(blades_ - 1), a), b);
  }

private:
  const space &space_;
  table &table_;
  std::size_t blades_;

  value one(std::size_t blade, double terms = 1) const {
    value out(blades_);
    out[blade] = terms;
    return out;
  }
  template <class Keep> value product(const value &a, const value &b, Keep keep) {
    value out(blades_);
    double longest_a = 0, longest_b = 0;
    for (std::size_t x = 0; x < blades_; ++x)
      for (std::size_t y = 0; y < blades_; ++y)
        if (a[x] != 0 && b[y] != 0)
          for (const std::size_t z : table_.product(x, y))
            if (keep(std::popcount(x), std::popcount(y), std::popcount(z)))
              out[z] += a[x] * b[y], spent.products += 1;
    for (const double x : a)
      longest_a += x;
    for (const double x : b)
      longest_b += x;
    spent.terms = std::max(spent.terms, longest_a * longest_b);
    return out;
  }
};

} // namespace

effort effort_of(const formula &f) {
  sizes of(*f.in);
  std::vector<sizes::value> operands, arguments;
  for (const std::string &k : f.kinds) {
    const std::vector<bool> &support = f.in->find(k).support;
    operands.emplace_back(support.begin(), support.end());
  }
  for (const expression_ptr &a : f.arguments)
    arguments.push_back(evaluate(of, *a, operands));
  evaluate(of, *f.body, arguments);
  return of.spent;
}

} // namespace meetc::fuzz
