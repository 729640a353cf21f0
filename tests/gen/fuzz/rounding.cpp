#include "tests/gen/fuzz/rounding.hpp"

#include "gen/ir/fold.hpp"

#include <algorithm>
#include <cmath>

namespace meetc::fuzz {
namespace {

bool is_double(const rational &q) {
  const mpz_class &den = q.get_den(), &num = q.get_num();
  if (mpz_popcount(den.get_mpz_t()) != 1 || mpz_sizeinbase(den.get_mpz_t(), 2) > 900)
    return false;
  if (num == 0)
    return true;
  const std::size_t zeros = mpz_scan1(num.get_mpz_t(), 0), bits = mpz_sizeinbase(num.get_mpz_t(), 2);
  return bits - zeros <= 53 && bits < 900;
}

struct exactness {
  using value = rational;
  const std::vector<rational> &inputs;
  bool *exact;

  value seen(rational q) const {
    *exact = *exact && is_double(q);
    return q;
  }
  value input(const ir::node_ref &, int i) const { return seen(inputs[static_cast<std::size_t>(i)]); }
  value constant(const ir::node_ref &, const rational &q) const {
    *exact = *exact && is_double(q.get_num()) && is_double(q.get_den());
    return seen(q);
  }
  value negate(const ir::node_ref &, const value &x) const { return -x; }
  value add(const ir::node_ref &, const value &x, const value &y) const { return seen(x + y); }
  value subtract(const ir::node_ref &, const value &x, const value &y) const { return seen(x - y); }
  value multiply(const ir::node_ref &, const value &x, const value &y) const { return seen(x * y); }
  value fused(const ir::node_ref &, const value &x, const value &y, const value &z) const {
    return seen(seen(x * y) + z);
  }
};

// Above what a few roundings of these bounds themselves may lose.
constexpr double slack = 1 + 0x1p-40;

struct errors {
  using value = bounded;
  const std::vector<bounded> &inputs;
  precision of;

  value rounded(double size, double error) const {
    return {size * slack, (error + of.unit * (size + error) + of.lost) * slack};
  }
  value input(const ir::node_ref &, int i) const { return inputs[static_cast<std::size_t>(i)]; }
  value constant(const ir::node_ref &, const rational &q) const { // a quotient: its parts are rounded, and it is
    const double size = std::fabs(q.get_d()) * slack;
    return {size, 4 * of.unit * size};
  }
  value negate(const ir::node_ref &, const value &x) const { return x; }
  value add(const ir::node_ref &, const value &x, const value &y) const {
    return rounded(x.size + y.size, x.error + y.error);
  }
  value subtract(const ir::node_ref &at, const value &x, const value &y) const { return add(at, x, y); }
  value multiply(const ir::node_ref &, const value &x, const value &y) const {
    return rounded(x.size * y.size, x.size * y.error + y.size * x.error + x.error * y.error);
  }
  value fused(const ir::node_ref &at, const value &x, const value &y, const value &z) const {
    return add(at, multiply(at, x, y), z);
  }
};

} // namespace

bool is_exact(const ir::program &p, const std::vector<rational> &inputs) {
  bool exact = true;
  ir::fold_results(p, exactness{inputs, &exact});
  return exact;
}

std::vector<bounded> error_bounds(const ir::program &p, const std::vector<bounded> &inputs, const precision &of) {
  return ir::fold_results(p, errors{inputs, of});
}

} // namespace meetc::fuzz
