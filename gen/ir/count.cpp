#include "gen/ir/count.hpp"

#include "gen/ir/fold.hpp"

namespace meetc::ir {
namespace {

bool is_power_of_two(const rational &q) {
  if (q == 0)
    return false;
  const mpz_class n = abs(q.get_num()), &d = q.get_den();
  return mpz_popcount(n.get_mpz_t()) == 1 && mpz_popcount(d.get_mpz_t()) == 1;
}

// The value says only whether multiplying by it is free.
struct counter {
  using value = bool;
  counts &into;
  std::optional<residency> only;

  bool counted(const place &at) const { return !only || at.where() == *only; }
  value made(const place &at, int &kind) const {
    kind += counted(at);
    return false;
  }
  value input(const place &, int) { return false; }
  value constant(const place &, const rational &q) { return is_power_of_two(q); }
  value negate(const place &, value) { return false; }
  value add(const place &at, value, value) { return made(at, into.additions); }
  value subtract(const place &at, value, value) { return made(at, into.additions); }
  value multiply(const place &at, value x, value y) { return x || y ? false : made(at, into.multiplications); }
  value fused(const place &at, value x, value y, value) { return made(at, x || y ? into.additions : into.fused); }
};

} // namespace

counts count(const arena &nodes, const std::vector<node_id> &results) {
  counts out;
  counter d{out, std::nullopt};
  fold(nodes, d, needed(nodes, results));
  return out;
}

counts count(const program &p, residency where) {
  counts out;
  counter d{out, where};
  fold(p, d);
  return out;
}

} // namespace meetc::ir
