#include "meet/core/query/chunks.hpp"

#include "meet/core/answers/answers_for.hpp"
#include "meet/core/query/touching_query.hpp"
#include "meet/core/sets/set_part.hpp"

#include <chrono>
#include <optional>

namespace meetc {
namespace {

struct no_room {};

// Hands hits on to another answer, and throws no_room when they become more than it has room for.
class bounded_answer final : public query_answer {
public:
  bounded_answer(query_answer &to, std::uint64_t room) : to_(to), room_(room) {}
  void start(const queried_sets &sets) override { to_.start(sets); }
  void take(int worker, const index_pair *hits, std::size_t n) override {
    if (taken_.fetch_add(n, std::memory_order_relaxed) + n > room_)
      throw no_room();
    to_.take(worker, hits, n);
  }
  void finish(result &r) override { to_.finish(r); }

private:
  query_answer &to_;
  std::uint64_t room_;
  std::atomic<std::uint64_t> taken_{0};
};

// Cuts a list that comes in pieces into chunks.
class chunk_cutter {
public:
  chunk_cutter(std::size_t chunk, const take_pairs &take, const execution &on) : chunk_(chunk), take_(take), on_(on) {}
  void add(std::span<const index_pair> pairs) {
    if (!rest_.empty()) {
      const std::size_t some = std::min(chunk_ - rest_.size(), pairs.size());
      rest_.insert(rest_.end(), pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(some));
      pairs = pairs.subspan(some);
      if (rest_.size() == chunk_)
        finish();
    }
    for (; pairs.size() >= chunk_; pairs = pairs.subspan(chunk_))
      give(pairs.first(chunk_));
    rest_.insert(rest_.end(), pairs.begin(), pairs.end());
  }
  void finish() {
    if (!rest_.empty())
      give(rest_);
    rest_.clear();
  }

private:
  void give(std::span<const index_pair> pairs) {
    on_.go_on();
    take_(pairs);
  }
  std::size_t chunk_;
  const take_pairs &take_;
  const execution &on_;
  std::vector<index_pair> rest_;
};

class chunked_query {
public:
  chunked_query(const touching_query &query, const predicate_info &predicate, const collide_options &options,
                std::uint64_t items, std::uint64_t room)
      : query_(query), predicate_(predicate), options_(options), items_(items), room_(room) {}

  // Adds what it counts to r.
  void run(chunk_cutter &to, result &r) {
    for (std::uint64_t first = 0, some = items_; first < items_;) {
      some = std::min(some, items_ - first);
      result found;
      if (!ask(first, some, found)) {
        some = std::max<std::uint64_t>(some / 4, 1);
        continue;
      }
      to.add(found.pairs);
      r.count += found.pairs.size(), r.candidates += found.candidates;
      for (int i = 0; i < bounded_rungs; ++i)
        r.rungs.unsure[i] += found.rungs.unsure[i];
      first += some;
      // The next items are expected to have as many pairs each; half of the room is left for those that have more.
      const std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
      some = std::clamp<std::uint64_t>(some * (room_ / 2) / std::max<std::uint64_t>(found.pairs.size(), 1), 1, most);
    }
    to.finish();
  }

private:
  // The pairs of these items of a; false: there is no room for them. The pairs of one item are never too many.
  bool ask(std::uint64_t first, std::uint64_t some, result &found) {
    const bool all = some == items_;
    std::optional<set_part> part, walked_part;
    if (!all)
      part.emplace(query_.a(), options_.owner_a, first, first + some, query_.on());
    const bool normal = &query_.a() != &query_.walked_a();
    if (!all && normal)
      walked_part.emplace(query_.walked_a(), options_.owner_a, first, first + some, query_.on());
    const element_set &of = all ? query_.a() : part->set();
    const element_set &walked = all ? query_.walked_a() : normal ? walked_part->set() : of;
    const stored_operand stored = all ? query_.stored_a() : part->stored(query_.by().stored_a, *predicate_.a);
    const auto answers = answers_for(predicate_, answer_kind::pairs, false, options_.owner_a, options_.owner_b);
    bounded_answer bounded(*answers.front(), some > 1 ? room_ : std::numeric_limits<std::uint64_t>::max());
    query_answer *const taker[] = {&bounded};
    query_.start(bounded, of);
    const double begin = static_cast<double>(first) / static_cast<double>(items_),
                 share = static_cast<double>(some) / static_cast<double>(items_);
    const std::function<void(double)> progress = [&](double f) { options_.progress(begin + share * f); };
    try {
      const tally total = query_.run(walked, of, stored, all && query_.half(), taker,
                                     options_.progress ? progress : std::function<void(double)>());
      bounded.finish(found);
      found.candidates = total.candidates;
      found.rungs = total.rungs;
    } catch (const no_room &) {
      return false;
    }
    return true;
  }

  const touching_query &query_;
  const predicate_info &predicate_;
  const collide_options &options_;
  std::uint64_t items_, room_;
};

} // namespace

result collide_in_chunks(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
                         std::size_t chunk, const take_pairs &take, const collide_options &options) {
  return under_standard_word([&] {
    const auto start = std::chrono::steady_clock::now();
    require(chunk > 0, "a chunk has one pair or more");
    require(options.want == answer_kind::pairs && !options.first_met, "chunks are of the list of pairs alone");
    const touching_query query(a, b, predicate, precision, options);
    constexpr std::size_t least_room = std::size_t{1} << 14;
    chunk_cutter to(chunk, take, query.on());
    result r;
    r.rungs = query.by().start;
    for (std::uint64_t &unsure : r.rungs.unsure)
      unsure = 0;
    chunked_query(query, predicate, options, a.elements() > 0 ? items(options.owner_a, a.elements()) : 0,
                  std::max({chunk, a.elements() + b.elements(), least_room}))
        .run(to, r);
    r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return r;
  });
}

} // namespace meetc
