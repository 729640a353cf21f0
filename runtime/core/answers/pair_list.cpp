#include "meet/core/answers/pair_list.hpp"

#include "meet/core/threads/radix_sort.hpp"

#include <bit>

namespace meetc {
namespace {

// A pair as a number, with as few bits as the largest a and b have.
struct pair_key {
  int bits_a = 0, bits_b = 0;

  int bits() const { return bits_a + bits_b; }
  std::uint64_t operator()(index_pair p) const { return std::uint64_t{p.a} << bits_b | p.b; }
};

pair_key key_of(pair_span pairs) {
  std::uint32_t any_a = 0, any_b = 0;
  for (const index_pair p : pairs)
    any_a |= p.a, any_b |= p.b;
  return {static_cast<int>(std::bit_width(any_a)), static_cast<int>(std::bit_width(any_b))};
}

// Equal parts of lists that follow one another.
class equal_parts {
public:
  explicit equal_parts(std::span<const pair_span> lists) : lists_(lists) {
    for (const pair_span l : lists)
      begins_.push_back(size_), size_ += l.size();
    constexpr std::size_t least = 4096;
    part_ = std::max(least, (size_ + most_sort_parts - 1) / most_sort_parts);
  }

  std::size_t size() const { return size_; }
  std::size_t count() const { return (size_ + part_ - 1) / part_; }
  template <class Visit> void each(std::size_t p, const Visit &visit) const {
    const std::size_t begin = p * part_, end = std::min(size_, begin + part_);
    auto list = static_cast<std::size_t>(std::upper_bound(begins_.begin(), begins_.end(), begin) - begins_.begin()) - 1;
    for (std::size_t at = begin; at < end; ++list) {
      const std::size_t stop = std::min(end, begins_[list] + lists_[list].size());
      visit(lists_[list].data() + (at - begins_[list]), stop - at);
      at = stop;
    }
  }

private:
  std::span<const pair_span> lists_;
  std::vector<std::size_t> begins_;
  std::size_t size_ = 0, part_ = 0;
};

} // namespace

void pair_list::add(const index_pair *pairs, std::size_t n) {
  constexpr std::size_t first = std::size_t{1} << 9, most = std::size_t{1} << 20; // 4 KiB to 8 MiB
  while (n > 0) {
    if (pieces_.empty() || pieces_.back().size == pieces_.back().room) {
      const std::size_t room = pieces_.empty() ? first : std::min(most, 4 * pieces_.back().room);
      pieces_.push_back({allocate(room * sizeof(index_pair)), 0, room});
    }
    piece &last = pieces_.back();
    const std::size_t some = std::min(n, last.room - last.size);
    std::copy_n(pairs, some, last.pairs() + last.size);
    last.size += some, pairs += some, n -= some;
  }
}

std::vector<index_pair> sorted(std::vector<pair_list> lists, const execution &on) {
  std::vector<pair_span> pieces;
  for (const pair_list &l : lists)
    for (const pair_list::piece &p : l.pieces_)
      pieces.emplace_back(p.pairs(), p.size);
  return sorted(pieces, on);
}

std::vector<index_pair> sorted(std::span<const pair_span> lists, const execution &on) {
  const equal_parts parts(lists);
  std::vector<index_pair> out;
  if (parts.size() < std::size_t{1} << 14) { // to start threads would take longer than to sort
    for (const pair_span l : lists)
      out.insert(out.end(), l.begin(), l.end());
    sort_pairs(out);
    return out;
  }
  std::vector<pair_key> keys(parts.count());
  for_chunks(on, parts.count(), 1, [&](int, std::size_t p, std::size_t) {
    parts.each(p, [&](const index_pair *pairs, std::size_t n) {
      const pair_key k = key_of({pairs, n});
      keys[p] = {std::max(keys[p].bits_a, k.bits_a), std::max(keys[p].bits_b, k.bits_b)};
    });
  });
  pair_key key;
  for (const pair_key &k : keys)
    key = {std::max(key.bits_a, k.bits_a), std::max(key.bits_b, k.bits_b)};
  out.reserve(parts.size());
  wish_for_large_pages(out.data(), parts.size() * sizeof(index_pair));
  for_strips(on, parts.size(), [&](std::size_t, std::size_t end) { out.resize(end); }); // which fills pages
  std::vector<owned_memory> rooms(static_cast<std::size_t>(on.threads));
  std::vector<std::size_t> sizes(rooms.size());
  radix_sort_parts(
      parts.count(), [&](std::size_t p, const auto &visit) { parts.each(p, visit); }, out.data(), key.bits(), on, key,
      [&](int worker, std::size_t, std::size_t n) {
        const auto w = static_cast<std::size_t>(worker);
        if (sizes[w] < n) {
          sizes[w] = std::min(2 * n, parts.size());
          rooms[w] = allocate(sizes[w] * sizeof(index_pair));
        }
        return static_cast<index_pair *>(rooms[w].get());
      },
      [](std::size_t, std::size_t, index_pair *) {});
  return out;
}

void sort_pairs(std::vector<index_pair> &pairs, const execution &on) {
  const pair_key key = key_of(pairs);
  const owned_memory room = allocate(pairs.size() * sizeof(index_pair));
  radix_sort(pairs.data(), static_cast<index_pair *>(room.get()), pairs.size(), key.bits(), key, on);
}

void drop_repeats(std::vector<index_pair> &sorted) {
  const auto same = [](index_pair x, index_pair y) { return x.a == y.a && x.b == y.b; };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
}

std::vector<index_pair> transposed(std::vector<index_pair> pairs) {
  for (index_pair &p : pairs)
    p = {p.b, p.a};
  sort_pairs(pairs);
  return pairs;
}

} // namespace meetc
