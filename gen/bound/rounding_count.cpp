#include "gen/bound/rounding_count.hpp"

#include "gen/bound/bound.hpp"
#include "gen/ir/fold.hpp"

#include <algorithm>

namespace meetc::bound {
namespace {

constexpr std::size_t significand = 24; // of binary32; wider formats round less

bool rounds(mpz_class integer) {
  if (integer == 0)
    return false;
  integer = abs(integer);
  integer >>= mpz_scan1(integer.get_mpz_t(), 0);
  return mpz_sizeinbase(integer.get_mpz_t(), 2) > significand;
}

struct counting {
  using value = int;

  value input(const ir::node_ref &, int) const { return 0; }
  value constant(const ir::node_ref &, const ir::rational &q) const {
    const bool dyadic = mpz_popcount(q.get_den_mpz_t()) == 1;
    return static_cast<int>(rounds(q.get_num())) + (dyadic ? 0 : 1 + static_cast<int>(rounds(q.get_den())));
  }
  value negate(const ir::node_ref &, value x) const { return x; }
  value add(const ir::node_ref &, value x, value y) const { return std::max(x, y) + 1; }
  value subtract(const ir::node_ref &, value x, value y) const { return std::max(x, y) + 1; }
  value multiply(const ir::node_ref &at, value x, value y) const {
    return x + y + (scales_exactly(at.nodes, at.id) ? 0 : 1);
  }
  value fused(const ir::node_ref &, value x, value y, value z) const { return std::max(x + y + 1, z) + 1; }
};

} // namespace

int rounding_count(const ir::program &p) {
  const std::vector<int> all = ir::fold_results(p, counting{});
  return all.empty() ? 0 : *std::max_element(all.begin(), all.end());
}

} // namespace meetc::bound
