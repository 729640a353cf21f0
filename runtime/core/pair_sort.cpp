#include "core/pair_sort.hpp"

#include "core/radix_sort.hpp"
#include "core/threads.hpp"

#include <bit>

namespace meetc {
namespace {

std::uint64_t key(index_pair p) {
  return std::uint64_t{p.a} << 32 | p.b;
}
int width(std::uint32_t v) {
  return 32 - std::countl_zero(v);
}

constexpr std::size_t buckets = 256;
using counts = std::array<std::size_t, buckets>;

} // namespace

void sort_pairs(index_pair *pairs, std::size_t n, std::vector<index_pair> &scratch) {
  if (n < 2048) {
    std::sort(pairs, pairs + n, [](index_pair x, index_pair y) { return key(x) < key(y); });
    return;
  }
  // Bits that are the same in all pairs do not affect the order.
  std::uint32_t vary_a = 0, vary_b = 0;
  for (std::size_t i = 1; i < n; ++i) {
    vary_a |= pairs[i].a ^ pairs[0].a;
    vary_b |= pairs[i].b ^ pairs[0].b;
  }
  const int low = width(vary_b), high = width(vary_a);
  const auto mask = [](int bits) { return (std::uint64_t{1} << bits) - 1; };
  if (scratch.size() < n)
    scratch.resize(n);
  radix_sort(pairs, scratch.data(), n, low + high,
             [=](index_pair p) { return (p.a & mask(high)) << low | (p.b & mask(low)); });
}

void drop_repeats(std::vector<index_pair> &sorted) {
  const auto same = [](index_pair x, index_pair y) { return key(x) == key(y); };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
}

std::vector<index_pair> transposed(std::vector<index_pair> pairs) {
  for (index_pair &p : pairs)
    p = {p.b, p.a};
  std::vector<index_pair> scratch;
  sort_pairs(pairs.data(), pairs.size(), scratch);
  return pairs;
}

std::vector<index_pair> sort_together(std::vector<std::vector<index_pair>> &lists, int threads) {
  std::vector<std::vector<index_pair>> from(std::move(lists));
  lists.clear();
  std::size_t total = 0;
  for (const auto &list : from)
    total += list.size();
  if (total < 1 << 14) // starting threads would take longer than sorting
    threads = 1;
  std::vector<std::uint32_t> any_of(from.size(), 0);
  for_chunks(threads, from.size(), 1, [&](int, std::size_t i, std::size_t) {
    std::uint32_t any = 0;
    for (const index_pair p : from[i])
      any |= p.a;
    any_of[i] = any;
  });
  std::uint32_t any_a = 0;
  for (const std::uint32_t any : any_of)
    any_a |= any;
  const int shift = std::max(width(any_a) - width(buckets - 1), 0);
  const auto bucket = [shift](index_pair p) { return p.a >> shift; };

  std::vector<counts> starts(from.size(), counts{});
  for_chunks(threads, from.size(), 1, [&](int, std::size_t i, std::size_t) {
    for (const index_pair p : from[i])
      ++starts[i][bucket(p)];
  });
  std::size_t ends[buckets], sum = 0;
  for (std::size_t k = 0; k < buckets; ++k) {
    for (counts &c : starts) {
      const std::size_t n = c[k];
      c[k] = sum;
      sum += n;
    }
    ends[k] = sum;
  }
  std::vector<index_pair> out(total);
  for_chunks(threads, from.size(), 1, [&](int, std::size_t i, std::size_t) {
    for (const index_pair p : from[i])
      out[starts[i][bucket(p)]++] = p;
    std::vector<index_pair>().swap(from[i]);
  });
  std::vector<std::vector<index_pair>> scratch(static_cast<std::size_t>(threads));
  for_chunks(threads, buckets, 1, [&](int worker, std::size_t k, std::size_t) {
    const std::size_t begin = k ? ends[k - 1] : 0;
    sort_pairs(out.data() + begin, ends[k] - begin, scratch[static_cast<std::size_t>(worker)]);
  });
  return out;
}

} // namespace meetc
