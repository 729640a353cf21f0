#include "meet/core/query/decide.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>

namespace meetc {
namespace {

// A batch is flushed at about this number of pairs. A run that began just before can still add its whole length.
constexpr std::size_t flush_at = 4096, early_flush_at = 128;
constexpr std::size_t batch_capacity = flush_at + pair_sink::longest_run;
// So many pairs are decided by a rung that has all to itself, before it is asked whether to go on.
constexpr std::size_t decided_at_once = 1024;

bool takes_elements(const query_answer *a) {
  return a->needs_pairs() && !a->by_slots();
}

struct shared_state {
  const decision_job &job;
  const bool stops_early, takes_elements; // all answers, and any
  std::atomic<std::uint64_t> candidates{0}, hits{0}, unsure[bounded_rungs]{};

  explicit shared_state(const decision_job &j)
      : job(j), stops_early(!j.answers.empty() && std::ranges::all_of(j.answers, &query_answer::stops_early)),
        takes_elements(std::ranges::any_of(j.answers, meetc::takes_elements)) {}
  bool done() const { return stops_early && std::ranges::all_of(job.answers, &query_answer::done); }
};

class batch final : public pair_sink {
public:
  batch(shared_state &shared, int worker, index_pair *pairs, answer *answers)
      : shared_(shared), worker_(worker), answers_(answers) {
    pairs_ = pairs;
    full_ = shared.stops_early ? early_flush_at : flush_at;
  }
  batch(const batch &) = delete;
  batch &operator=(const batch &) = delete;

  bool flush() override {
    shared_.job.on.go_on();
    if (shared_.job.only)
      size_ = shared_.job.only->keep(pairs_, size_);
    candidates_ += meant({pairs_, size_});
    const std::size_t n = decide();
    hits_ += meant({pairs_, n});
    size_ = 0;
    if (n > 0)
      give(n);
    return !shared_.done();
  }

  void finish() {
    flush();
    shared_.candidates.fetch_add(candidates_, std::memory_order_relaxed);
    shared_.hits.fetch_add(hits_, std::memory_order_relaxed);
    for (int r = 0; r < bounded_rungs; ++r)
      shared_.unsure[r].fetch_add(unsure_[r], std::memory_order_relaxed);
  }

private:
  // How many pairs these candidates stand for.
  std::size_t meant(std::span<const index_pair> pairs) const {
    if (!shared_.job.both_ways)
      return pairs.size();
    return 2 * pairs.size() -
           static_cast<std::size_t>(std::ranges::count_if(pairs, [](index_pair p) { return p.a == p.b; }));
  }
  // Gives the first n pairs, which are hits, to the answers.
  void give(std::size_t n) {
    const decision_job &job = shared_.job;
    for (query_answer *const to : job.answers)
      if (!takes_elements(to))
        to->take(worker_, pairs_, n);
    if (!shared_.takes_elements)
      return;
    for (std::size_t i = 0; i < n; ++i)
      pairs_[i] = {job.a.order[pairs_[i].a], job.b.order[pairs_[i].b]};
    give_elements(n);
    if (job.both_ways)
      give_elements(turn(n));
  }
  void give_elements(std::size_t n) {
    for (query_answer *const to : shared_.job.answers)
      if (takes_elements(to))
        to->take(worker_, pairs_, n);
  }
  // Turns the first n pairs round, without those of an element with itself, and returns how many there are.
  std::size_t turn(std::size_t n) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const index_pair p = pairs_[i];
      pairs_[kept] = {p.b, p.a};
      kept += p.a != p.b;
    }
    return kept;
  }

  // Moves the hits to the front of the batch and returns their number. Whether a pair is one is as good as random, so pairs
  // are moved without a branch.
  std::size_t decide() {
    const decision_job &job = shared_.job;
    const row_array a{job.a.rows, job.stored_a.after(size_, job.a, job.on)},
        b{job.b.rows, job.stored_b.after(size_, job.b, job.on)};
    const auto handed_on = [this](int at, std::span<const index_pair> left) {
      shared_.job.on.go_on();
      unsure_[at] += meant(left);
    };
    const std::size_t at_once = job.by.count > 1 ? batch_capacity : decided_at_once;
    for (std::size_t begin = 0; begin < size_; begin += at_once) {
      job.on.go_on();
      job.by.decide(a, b, pairs_ + begin, std::min(at_once, size_ - begin), answers_ + begin, shared_.stops_early,
                    handed_on);
    }
    std::size_t hits = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      pairs_[hits] = pairs_[i];
      hits += answers_[i] == answer::yes;
    }
    return hits;
  }

  shared_state &shared_;
  int worker_;
  answer *answers_;
  std::uint64_t candidates_ = 0, hits_ = 0, unsure_[bounded_rungs] = {};
};

class progress_report {
public:
  explicit progress_report(const decision_job &job) : job_(job) {}
  void at(double fraction) {
    using namespace std::chrono_literals;
    if (!job_.progress || clock::now() < next_)
      return;
    job_.progress(job_.progress_context, fraction);
    next_ = clock::now() + 100ms;
  }

private:
  using clock = std::chrono::steady_clock;
  const decision_job &job_;
  clock::time_point next_ = clock::now() + std::chrono::milliseconds(100);
};

} // namespace

std::size_t batch_bytes(int threads) {
  bump_allocator need;
  need.take<index_pair>(static_cast<std::size_t>(threads) * batch_capacity);
  need.take<answer>(static_cast<std::size_t>(threads) * batch_capacity);
  return need.bytes();
}

tally decide_all(const decision_job &job, memory batches) {
  bump_allocator from(batches);
  auto *pairs = from.take<index_pair>(static_cast<std::size_t>(job.on.threads) * batch_capacity);
  auto *answers = from.take<answer>(static_cast<std::size_t>(job.on.threads) * batch_capacity);

  // Chunks are small enough to share out, and large enough that the counter is not the bottleneck.
  const std::size_t units = job.source.units();
  const std::size_t chunk = std::clamp<std::size_t>(units / (static_cast<std::size_t>(job.on.threads) * 64), 1, 64);
  chunk_counter counter(units, chunk);
  shared_state shared(job);
  auto body = [&](int worker) {
    const std::size_t at = static_cast<std::size_t>(worker) * batch_capacity;
    batch mine(shared, worker, pairs + at, answers + at);
    progress_report progress(job);
    for (std::size_t unit, end; counter.take(unit, end);) {
      for (; unit < end; ++unit) {
        job.on.go_on();
        if (shared.done() || !job.source.yield(unit, mine)) {
          counter.close();
          break;
        }
      }
      if (worker == 0)
        progress.at(counter.fraction());
    }
    mine.finish();
  };
  run_workers(counter.workers(job.on.threads), counter, body);
  tally total{shared.candidates, shared.hits, job.by.start};
  for (int r = 0; r < bounded_rungs; ++r)
    total.rungs.unsure[r] = shared.unsure[r];
  return total;
}

} // namespace meetc
