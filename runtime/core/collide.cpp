// The owning layer.
#include "core/collide.hpp"

#include "core/decide.hpp"
#include "core/pair_sort.hpp"
#include "core/threads.hpp"

#include <chrono>
#include <cstring>

namespace meetc {
namespace {

// A list a worker. With owners it is compacted whenever it has doubled, so that it grows with the distinct
// pairs.
class collect final : public hit_taker {
public:
  collect(int workers, std::span<const std::uint32_t> owner_a, std::span<const std::uint32_t> owner_b)
      : lists_(static_cast<std::size_t>(workers)), owner_a_(owner_a), owner_b_(owner_b),
        owned_(!owner_a.empty() || !owner_b.empty()) {}

  bool owned() const { return owned_; }

  void take(int worker, const index_pair *hits, std::size_t n) override {
    list &mine = lists_[static_cast<std::size_t>(worker)];
    if (!owned_) {
      mine.pairs.insert(mine.pairs.end(), hits, hits + n);
      return;
    }
    for (std::size_t i = 0; i < n; ++i)
      mine.pairs.push_back(
          {owner_a_.empty() ? hits[i].a : owner_a_[hits[i].a], owner_b_.empty() ? hits[i].b : owner_b_[hits[i].b]});
    if (mine.pairs.size() >= mine.compact_at) {
      sort_pairs(mine.pairs.data(), mine.pairs.size(), mine.scratch);
      drop_repeats(mine.pairs);
      mine.compact_at = std::max(first_compaction, 2 * mine.pairs.size());
    }
  }

  std::vector<index_pair> all(int threads) {
    std::vector<std::vector<index_pair>> lists;
    for (list &l : lists_) {
      lists.push_back(std::move(l.pairs));
      std::vector<index_pair>().swap(l.scratch);
    }
    std::vector<index_pair> pairs = sort_together(lists, threads);
    if (owned_)
      drop_repeats(pairs);
    return pairs;
  }

private:
  static constexpr std::size_t first_compaction = std::size_t{1} << 18;
  struct alignas(64) list {
    std::vector<index_pair> pairs, scratch;
    std::size_t compact_at = first_compaction;
  };
  std::vector<list> lists_;
  std::span<const std::uint32_t> owner_a_, owner_b_;
  bool owned_;
};

bool same_kind(const kind_info &x, const kind_info &y) {
  return &x == &y || (x.fields == y.fields && std::strcmp(x.name, y.name) == 0);
}

void require(bool holds, const char *what) {
  if (!holds)
    throw std::invalid_argument(what);
}

bool owners_fit(std::span<const std::uint32_t> owners, const prepared &p) {
  return owners.empty() || owners.size() == p.elements();
}

} // namespace

prepared::prepared() = default;
prepared::prepared(prepared &&) noexcept = default;
prepared &prepared::operator=(prepared &&) noexcept = default;
prepared::~prepared() = default;
const kind_info &prepared::kind() const {
  return *set_->kind;
}
std::size_t prepared::elements() const {
  return set_->elements;
}

void prepared::bounds(float lo[3], float hi[3]) const {
  box b{{1, 1, 1}, {-1, -1, -1}};
  if (set_->boxes.depth > 0)
    b = set_->boxes.top().blocks[0].around();
  std::copy_n(b.lo, 3, lo);
  std::copy_n(b.hi, 3, hi);
}

prepared prepare(const view &elements, const kind_info &kind, const pose &at, int threads) {
  if (elements.elements > 0xffffffff)
    throw std::length_error(text(status::too_many_elements));
  const auto allocate = [](const arena &need) { return std::unique_ptr<std::byte[]>(new std::byte[need.bytes()]); };
  arena set_need, scratch_need;
  take_set(set_need, kind, elements.elements);
  take_scratch(scratch_need, kind, elements.elements);

  prepared p;
  p.bytes_ = allocate(set_need);
  const std::unique_ptr<std::byte[]> scratch_bytes = allocate(scratch_need);
  arena from({p.bytes_.get(), set_need.bytes()}), scratch_from({scratch_bytes.get(), scratch_need.bytes()});
  p.set_ = std::make_unique<element_set>(take_set(from, kind, elements.elements));
  const set_scratch scratch = take_scratch(scratch_from, kind, elements.elements);
  const status s = fill(*p.set_, elements, at, scratch, thread_count(threads));
  if (s == status::bad_index || s == status::bad_value)
    throw input_error(check(elements, kind, at), kind);
  require(s == status::ok, text(s));
  return p;
}

result collide(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
               const collide_options &options) {
  const auto start = std::chrono::steady_clock::now();
  require(same_kind(a.kind(), *predicate.a) && same_kind(b.kind(), *predicate.b),
          "the predicate is for other kinds of element");
  require(owners_fit(options.owner_a, a) && owners_fit(options.owner_b, b), "an owner map needs one item an element");
  ladder by(predicate, precision);
  require(by.count > 0, text(status::no_such_rung));
  require(options.box >= 0, "the scene's box is negative or not a number");
  by.enter_box(options.box, a.set(), b.set());

  const int threads = thread_count(options.threads);
  const all_pairs every(a.set(), b.set());
  const tree_pairs tree(a.set(), b.set());
  const candidate_source &source = options.all_pairs ? static_cast<const candidate_source &>(every) : tree;
  collect taker(threads, options.owner_a, options.owner_b);
  const bool keep = options.mode == collide_mode::list || (options.mode == collide_mode::count && taker.owned());
  const auto report = [](void *context, double fraction) {
    (*static_cast<const std::function<void(double)> *>(context))(fraction);
  };
  const std::unique_ptr<std::byte[]> batches(new std::byte[batch_bytes(threads)]);
  const tally total = decide_all(
      {a.set(), b.set(), by, source, threads, options.mode == collide_mode::any, options.progress ? +report : nullptr,
       const_cast<std::function<void(double)> *>(&options.progress), keep ? &taker : nullptr},
      {batches.get(), batch_bytes(threads)});
  result r;
  r.candidates = total.candidates;
  r.count = total.hits;
  r.rungs = total.rungs;
  if (keep) {
    r.pairs = taker.all(threads);
    r.count = r.pairs.size();
    if (options.mode == collide_mode::count)
      std::vector<index_pair>().swap(r.pairs);
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace meetc
