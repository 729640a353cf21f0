#include "gen/ir/count.hpp"

#include "gen/ir/fold.hpp"

#include <algorithm>

namespace meetc::ir {
namespace {

bool is_power_of_two(const rational &q) {
  if (q == 0)
    return false;
  const mpz_class n = abs(q.get_num()), &d = q.get_den();
  return mpz_popcount(n.get_mpz_t()) == 1 && mpz_popcount(d.get_mpz_t()) == 1;
}

// The value only says whether a multiplication by it is free.
struct counter {
  using value = bool;
  counts &into;
  const std::vector<node_id> &known;
  std::optional<residency> only = {};

  std::optional<value> given(const node_ref &at) const {
    return std::binary_search(known.begin(), known.end(), at.id) ? std::optional(false) : std::nullopt;
  }
  value made(const node_ref &at, int &kind) const {
    kind += !only || at.where() == *only;
    return false;
  }
  value input(const node_ref &, int) { return false; }
  value constant(const node_ref &, const rational &q) { return is_power_of_two(q); }
  value negate(const node_ref &at, value x) {
    made(at, into.negations);
    return x;
  }
  value add(const node_ref &at, value, value) { return made(at, into.additions); }
  value subtract(const node_ref &at, value, value) { return made(at, into.additions); }
  value multiply(const node_ref &at, value x, value y) {
    return made(at, x || y ? into.scalings : into.multiplications);
  }
  value fused(const node_ref &at, value x, value y, value) {
    if (x || y)
      made(at, into.scalings);
    return made(at, x || y ? into.additions : into.fused);
  }
};

} // namespace

counts count(const arena &nodes, const std::vector<node_id> &results, const std::vector<node_id> &given) {
  counts out;
  counter d{out, given};
  fold(nodes, d, needed(nodes, results, given));
  return out;
}

counts count(const arena &nodes, const std::vector<node_id> &results, residency where) {
  counts out;
  const std::vector<node_id> none;
  counter d{out, none, where};
  fold(nodes, d, needed(nodes, results));
  return out;
}

counts count(const program &p, residency where) {
  return count(p.nodes, p.results, where);
}

counts count_object(const program &p, residency object) {
  return count(p.nodes, stored_of(p, object));
}

counts count_pair(const program &p) {
  return count(p.nodes, p.results, p.stored);
}

std::string mul_add(const counts &c) {
  return std::to_string(c.multiplications + c.fused) + '/' + std::to_string(c.additions + c.fused);
}

} // namespace meetc::ir
