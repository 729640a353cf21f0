#include "core/pair_sort.hpp"

#include "core/radix_sort.hpp"

#include <bit>

namespace meetc {
namespace {

std::uint64_t key(index_pair p) {
  return std::uint64_t{p.a} << 32 | p.b;
}
int width(std::uint32_t v) {
  return 32 - std::countl_zero(v);
}

// Bits that are the same in all pairs do not affect the order.
struct varying_bits {
  int a, b; // the low bits that vary, at most

  varying_bits(const index_pair *pairs, std::size_t n) {
    std::uint32_t vary_a = 0, vary_b = 0;
    for (std::size_t i = 1; i < n; ++i) {
      vary_a |= pairs[i].a ^ pairs[0].a;
      vary_b |= pairs[i].b ^ pairs[0].b;
    }
    a = width(vary_a), b = width(vary_b);
  }
};
std::uint64_t low_bits(std::uint64_t of, int bits) {
  return of & ((std::uint64_t{1} << bits) - 1);
}

void sort_by_comparison(index_pair *pairs, std::size_t n) {
  std::sort(pairs, pairs + n, [](index_pair x, index_pair y) { return key(x) < key(y); });
}
void sort_by_digits(index_pair *pairs, index_pair *scratch, std::size_t n, varying_bits vary) {
  radix_sort(pairs, scratch, n, vary.a + vary.b,
             [=](index_pair p) { return low_bits(p.a, vary.a) << vary.b | low_bits(p.b, vary.b); });
}

// The a of all pairs differ in their low `bits` bits alone.
void sort_by_counting(index_pair *pairs, std::size_t n, int bits, sort_scratch &scratch) {
  std::copy(pairs, pairs + n, scratch.pairs.data());
  deal_out([&](const auto &visit) { visit(scratch.pairs.data(), n); }, pairs, bits, scratch.ends);
}

} // namespace

void sort_pairs(index_pair *pairs, std::size_t n, sort_scratch &scratch) {
  if (n < 64) {
    sort_by_comparison(pairs, n);
    return;
  }
  if (scratch.pairs.size() < n)
    scratch.pairs.resize(n);
  const varying_bits vary(pairs, n);
  constexpr std::size_t small = 2048; // from here on digits are faster, whose loops have no branches
  if (n < small && may_be_dealt_out(n, vary.a))
    sort_by_counting(pairs, n, vary.a, scratch);
  else if (n < small)
    sort_by_comparison(pairs, n);
  else
    sort_by_digits(pairs, scratch.pairs.data(), n, vary);
}

void sort_each(index_pair *pairs, std::span<const std::uint32_t> ends, std::uint32_t most) {
  constexpr std::uint32_t few = 24;
  std::uint32_t begin = 0;
  if (most > few)
    for (const std::uint32_t end : ends) {
      if (end - begin > few)
        std::sort(pairs + begin, pairs + end, [](index_pair x, index_pair y) { return x.b < y.b; });
      begin = end;
    }
  // By insertion, which leaves what is sorted as it is.
  for (std::size_t i = 1; i < (ends.empty() ? 0 : ends.back()); ++i) {
    const index_pair p = pairs[i];
    std::size_t at = i;
    for (; at > 0 && key(p) < key(pairs[at - 1]); --at)
      pairs[at] = pairs[at - 1];
    pairs[at] = p;
  }
}

void drop_repeats(std::vector<index_pair> &sorted) {
  const auto same = [](index_pair x, index_pair y) { return key(x) == key(y); };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
}

std::vector<index_pair> transposed(std::vector<index_pair> pairs) {
  for (index_pair &p : pairs)
    p = {p.b, p.a};
  sort_scratch scratch;
  sort_pairs(pairs.data(), pairs.size(), scratch);
  return pairs;
}

} // namespace meetc
