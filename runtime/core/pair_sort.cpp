#include "core/pair_sort.hpp"

#include "core/memory.hpp"
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

// Sorts pairs of one a from `from` to `to`.
void sort_run(const index_pair *from, index_pair *to, std::size_t n) {
  constexpr std::size_t few = 24;
  if (n > few) {
    std::copy(from, from + n, to);
    std::sort(to, to + n, [](index_pair x, index_pair y) { return x.b < y.b; });
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t at = i;
    for (; at > 0 && from[i].b < to[at - 1].b; --at)
      to[at] = to[at - 1];
    to[at] = from[i];
  }
}

// The a of all pairs differ in their low `bits` bits alone.
void sort_by_counting(index_pair *pairs, std::size_t n, int bits, sort_scratch &scratch) {
  const std::size_t values = std::size_t{1} << bits;
  scratch.ends.assign(values + 1, 0);
  std::uint32_t *const ends = scratch.ends.data();
  for (std::size_t i = 0; i < n; ++i)
    ++ends[low_bits(pairs[i].a, bits) + 1];
  for (std::size_t v = 1; v <= values; ++v)
    ends[v] += ends[v - 1];
  index_pair *const dealt = scratch.pairs.data();
  for (std::size_t i = 0; i < n; ++i)
    dealt[ends[low_bits(pairs[i].a, bits)]++] = pairs[i];
  for (std::size_t v = 0, begin = 0; v < values; begin = ends[v++])
    sort_run(dealt + begin, pairs + begin, ends[v] - begin);
}

constexpr std::size_t buckets = 256;
using counts = std::array<std::size_t, buckets>;

// A vector's constructor writes zeros on one thread. The system clears pages when they are touched first, which takes
// longer, so all threads do that before.
std::vector<index_pair> room_for(std::size_t n, int threads) {
  std::vector<index_pair> out;
  out.reserve(n);
  wish_for_large_pages(out.data(), n * sizeof(index_pair));
  constexpr std::size_t page = 4096, chunk = std::size_t{1} << 21;
  auto *const bytes = reinterpret_cast<volatile std::byte *>(out.data());
  for_chunks(threads, n * sizeof(index_pair), chunk, [bytes](int, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; i += page)
      bytes[i] = std::byte{0};
  });
  out.resize(n);
  return out;
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
  if (n < small && std::size_t{1} << vary.a <= 4 * n)
    sort_by_counting(pairs, n, vary.a, scratch);
  else if (n < small)
    sort_by_comparison(pairs, n);
  else
    sort_by_digits(pairs, scratch.pairs.data(), n, vary);
}

void add_pairs(std::vector<index_pair> &to, const index_pair *pairs, std::size_t n) {
  if (n > to.capacity() - to.size()) {
    std::vector<index_pair> larger;
    larger.reserve(2 * (to.size() + n));
    wish_for_large_pages(larger.data(), larger.capacity() * sizeof(index_pair));
    larger.insert(larger.end(), to.begin(), to.end());
    to.swap(larger);
  }
  to.insert(to.end(), pairs, pairs + n);
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
  std::vector<index_pair> out = room_for(total, threads);
  for_chunks(threads, from.size(), 1, [&](int, std::size_t i, std::size_t) {
    for (const index_pair p : from[i])
      out[starts[i][bucket(p)]++] = p;
    std::vector<index_pair>().swap(from[i]);
  });
  std::vector<sort_scratch> scratch(static_cast<std::size_t>(threads));
  for_chunks(threads, buckets, 1, [&](int worker, std::size_t k, std::size_t) {
    const std::size_t begin = k ? ends[k - 1] : 0;
    sort_pairs(out.data() + begin, ends[k] - begin, scratch[static_cast<std::size_t>(worker)]);
  });
  return out;
}

} // namespace meetc
