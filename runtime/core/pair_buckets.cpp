#include "core/pair_buckets.hpp"

#include "core/pair_sort.hpp"
#include "core/threads.hpp"

#include <array>
#include <bit>

namespace meetc {

pair_buckets::pair_buckets(std::uint32_t most_a) : shift_(std::max(static_cast<int>(std::bit_width(most_a)) - 8, 0)) {
  static_assert(count == 1 << 8);
}

void pair_buckets::add(const index_pair *pairs, std::size_t n) {
  constexpr std::size_t enough = 4096; // for half a mebibyte of blocks
  if (buckets_.empty() && few_.size() + n <= enough) {
    few_.insert(few_.end(), pairs, pairs + n);
    return;
  }
  if (buckets_.empty())
    deal_few();
  deal(pairs, n);
}

void pair_buckets::deal_few() {
  buckets_.resize(count);
  deal(few_.data(), few_.size());
  few_ = {};
}

void pair_buckets::deal(const index_pair *pairs, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    bucket &in = buckets_[pairs[i].a >> shift_];
    if (in.in_last == block::most)
      begin_block(in);
    in.last->pairs[in.in_last++] = pairs[i];
  }
}

void pair_buckets::begin_block(bucket &in) {
  static_assert(sizeof(block) <= 2048);
  if (free_ == end_) {
    // Enough for a block in each bucket, and then large pages.
    const std::size_t blocks = memory_.empty() ? count : 8 * count;
    memory_.push_back(allocate(blocks * sizeof(block)));
    free_ = static_cast<block *>(memory_.back().get());
    end_ = free_ + blocks;
  }
  free_->before = in.last;
  in.last = free_++;
  in.in_last = 0;
  ++in.blocks;
}

namespace {

// Memory for a list. A vector writes zeros on one thread, and the system clears pages when they are touched first, which
// takes longer. So all threads touch the pages, and the calling thread alone then makes the list longer, piece by piece,
// while the others fill what there is.
class growing_list {
public:
  explicit growing_list(std::size_t size) : size_(size), pages_(size * sizeof(index_pair), std::size_t{1} << 21) {
    list.reserve(size);
    wish_for_large_pages(list.data(), size * sizeof(index_pair));
    data_ = list.data();
  }

  // Every worker calls it.
  void touch() {
    constexpr std::size_t page = 4096;
    auto *const bytes = reinterpret_cast<volatile std::byte *>(data_);
    for (std::size_t begin, end; pages_.take(begin, end);) {
      for (std::size_t i = begin; i < end; i += page)
        bytes[i] = std::byte{0};
      touched_.fetch_add(end - begin, std::memory_order_release);
      touched_.notify_all();
    }
  }
  // The calling thread calls it after that.
  void grow() {
    // Copied, since a long copy does not first read the lines that it writes, which lie in the caches of other cores.
    static constexpr std::array<index_pair, std::size_t{1} << 12> zeros{};
    for (std::size_t n; (n = touched_.load(std::memory_order_acquire)) < size_ * sizeof(index_pair);)
      touched_.wait(n, std::memory_order_acquire);
    while (list.size() < size_) {
      for (const std::size_t next = std::min(list.size() + 8 * zeros.size(), size_); list.size() < next;)
        list.insert(list.end(), zeros.data(), zeros.data() + std::min(zeros.size(), next - list.size()));
      ready_.store(list.size(), std::memory_order_release);
      ready_.notify_all();
    }
  }
  // Waits until the list has n pairs.
  index_pair *with(std::size_t n) {
    for (std::size_t ready; (ready = ready_.load(std::memory_order_acquire)) < n;)
      ready_.wait(ready, std::memory_order_acquire);
    return data_;
  }

  std::vector<index_pair> list;

private:
  std::size_t size_;
  index_pair *data_;
  chunk_counter pages_;
  std::atomic<std::size_t> touched_{0}, ready_{0};
};

} // namespace

class bucket_sort {
public:
  explicit bucket_sort(std::vector<pair_buckets> &from) : from_(from) {}

  std::vector<index_pair> run(int threads) {
    std::size_t total = 0;
    for (const pair_buckets &b : from_) {
      total += b.few_.size();
      for (const auto &in : b.buckets_)
        total += in.size();
    }
    return total < 1 << 14 ? few(total) : many(total, threads); // starting threads would take longer than sorting
  }

private:
  std::vector<index_pair> few(std::size_t total) {
    std::vector<index_pair> out;
    out.reserve(total);
    const auto add = [&out](const index_pair *pairs, std::size_t n) { out.insert(out.end(), pairs, pairs + n); };
    for (const pair_buckets &b : from_) {
      add(b.few_.data(), b.few_.size());
      for (std::size_t k = 0; k < b.buckets_.size(); ++k)
        b.visit(k, add);
    }
    sort_scratch scratch;
    sort_pairs(out.data(), total, scratch);
    return out;
  }

  std::vector<index_pair> many(std::size_t total, int threads) {
    std::size_t ends[pair_buckets::count] = {};
    for (pair_buckets &b : from_) {
      if (b.buckets_.empty())
        b.deal_few();
      for (std::size_t k = 0; k < pair_buckets::count; ++k)
        ends[k] += b.buckets_[k].size();
    }
    for (std::size_t k = 1; k < pair_buckets::count; ++k)
      ends[k] += ends[k - 1];

    growing_list out(total);
    std::vector<sort_scratch> scratch(static_cast<std::size_t>(threads));
    chunk_counter parts(pair_buckets::count, 1);
    auto body = [&](int worker) {
      out.touch();
      if (worker == 0)
        out.grow();
      for (std::size_t k, next; parts.take(k, next);) {
        const std::size_t begin = k ? ends[k - 1] : 0;
        sort(k, out.with(ends[k]) + begin, ends[k] - begin, scratch[static_cast<std::size_t>(worker)]);
      }
    };
    run_workers(parts.workers(threads), parts, body);
    return std::move(out.list);
  }

  void sort(std::size_t k, index_pair *to, std::size_t n, sort_scratch &scratch) const {
    const auto each = [&](const auto &visit) {
      for (const pair_buckets &b : from_)
        b.visit(k, visit);
    };
    constexpr std::size_t many = 4; // of one a, whose order by insertion takes longer than digits
    const int bits = from_.front().shift_;
    if (may_be_dealt_out(n, bits) && n <= many << bits) {
      deal_out(each, to, bits, scratch.ends);
      return;
    }
    index_pair *end = to;
    each([&end](const index_pair *pairs, std::size_t some) { end = std::copy(pairs, pairs + some, end); });
    sort_pairs(to, n, scratch);
  }

  std::vector<pair_buckets> &from_;
};

std::vector<index_pair> sort_together(std::vector<pair_buckets> from, int threads) {
  return bucket_sort(from).run(threads);
}

std::vector<index_pair> sort_together(std::vector<std::vector<index_pair>> &lists, int threads) {
  std::vector<std::vector<index_pair>> from(std::move(lists));
  lists.clear();
  std::uint32_t any_a = 0;
  for (const auto &list : from)
    for (const index_pair p : list)
      any_a |= p.a;
  std::vector<pair_buckets> buckets;
  for (std::size_t i = 0; i < from.size(); ++i)
    buckets.emplace_back(any_a);
  for_chunks(threads, from.size(), 1, [&](int, std::size_t i, std::size_t) {
    buckets[i].add(from[i].data(), from[i].size());
    std::vector<index_pair>().swap(from[i]);
  });
  return sort_together(std::move(buckets), threads);
}

} // namespace meetc
