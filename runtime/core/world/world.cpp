#include "meet/core/world/world.hpp"

#include "meet/core/answers/pair_list.hpp"
#include "meet/core/sets/posed_blocks.hpp"
#include "meet/core/threads/threads.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace meetc {
namespace {

using clock = std::chrono::steady_clock;

double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

// Sixteen boxes at a time, so that few bodies touch many in little time.
class bounds_of_bodies {
public:
  explicit bounds_of_bodies(std::span<const box> boxes) : boxes_(boxes), blocks_((boxes.size() + lanes - 1) / lanes) {
    for (box_block &block : blocks_)
      block.clear();
    for (std::size_t i = 0; i < boxes.size(); ++i)
      blocks_[i / lanes].set(static_cast<int>(i % lanes), boxes[i]);
  }
  // Calls visit(b) for each b > a whose box touches that of a.
  template <class Visit> void after(std::size_t a, const Visit &visit) const {
    for (std::size_t block = (a + 1) / lanes; block < blocks_.size(); ++block)
      for (std::uint32_t mask = meetc::touching(blocks_[block], boxes_[a]); mask != 0; mask &= mask - 1)
        if (const std::size_t b = block * lanes + static_cast<std::size_t>(std::countr_zero(mask)); b > a)
          visit(b);
  }

private:
  std::span<const box> boxes_;
  std::vector<box_block> blocks_;
};

// The answer with the sets exchanged.
result exchanged(result r) {
  r.pairs = transposed(std::move(r.pairs));
  std::swap(r.flags.a, r.flags.b);
  std::swap(r.counts.a, r.counts.b);
  std::swap(r.rungs.left_box_a, r.rungs.left_box_b);
  return r;
}

void require_movable(const std::string &name, const kind_info &kind, const pose &at) {
  if (const status s = movable(kind, at); s != status::ok)
    throw std::invalid_argument("body " + name + ": " + text(s));
}

} // namespace

world::world(const catalogue &all, std::string_view mode) : all_(all), mode_(mode) {}

std::uint32_t world::add(std::string name, std::shared_ptr<const prepared> shape, const pose &at,
                         std::vector<std::uint32_t> owners) {
  if (name.empty())
    throw std::invalid_argument("a body needs a name");
  if (!shape || !shape->whole())
    throw std::invalid_argument("body " + name + ": it needs a set that was prepared for any other");
  if (!owners.empty() && owners.size() != shape->elements())
    throw std::invalid_argument("body " + name + ": an owner map needs one item for each element");
  require_movable(name, shape->kind(), at);
  const auto number = static_cast<std::uint32_t>(bodies_.size());
  if (!numbers_.try_emplace(name, number).second)
    throw std::invalid_argument("body " + name + ": the name is taken");
  bodies_.push_back({std::move(name), std::move(shape), at, std::move(owners)});
  return number;
}

void world::move(std::uint32_t number, const pose &at) {
  entry &b = bodies_.at(number);
  require_movable(b.name, b.shape->kind(), at);
  b.at = at;
}

void world::ignore(std::uint32_t a, std::uint32_t b, bool ignored) {
  static_cast<void>(bodies_.at(std::max(a, b)));
  const std::pair key(std::min(a, b), std::max(a, b));
  if (ignored)
    ignored_.insert(key);
  else
    ignored_.erase(key);
}

std::optional<std::uint32_t> world::find(std::string_view name) const {
  const auto found = numbers_.find(std::string(name));
  return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

choice world::predicate_of(const entry &a, const entry &b) const {
  const kind_info &kind_a = a.shape->kind(), &kind_b = b.shape->kind();
  if (const std::optional<choice> c = first_for(fitting(all_, kind_a, kind_b), mode_))
    return *c;
  throw std::invalid_argument("no predicate decides a " + std::string(kind_a.name) + " and a " + kind_b.name +
                              ", as of the bodies " + a.name + " and " + b.name + "; ignore the pair");
}

world_answer world::touching(const world_options &options) const {
  return under_standard_word([&] { return ask(options); });
}

world_answer world::ask(const world_options &options) const {
  struct pair_of_bodies {
    std::uint32_t a, b;
    choice by;
  };
  const auto start = clock::now();
  const int threads = thread_count(options.threads);
  std::vector<box> bounds;
  for (const entry &b : bodies_)
    bounds.push_back(posed_box(b.at, b.shape->set().around, b.shape->set().longest));

  world_answer out;
  std::vector<pair_of_bodies> pairs;
  std::vector<std::vector<box>> near(bodies_.size());
  const bounds_of_bodies all(bounds);
  for (std::uint32_t a = 0; a < bodies_.size(); ++a)
    all.after(a, [&](std::size_t other) {
      const auto b = static_cast<std::uint32_t>(other);
      if (bodies_[a].shape->elements() == 0 || bodies_[b].shape->elements() == 0 || ignored_.contains({a, b}))
        return;
      pairs.push_back({a, b, predicate_of(bodies_[a], bodies_[b])});
      near[a].push_back(bounds[b]), near[b].push_back(bounds[a]);
    });
  out.near = pairs.size();

  std::vector<std::optional<prepared>> sets(bodies_.size());
  for_chunks(threads, bodies_.size(), 1, [&](int, std::size_t i, std::size_t) {
    if (near[i].empty())
      return;
    try {
      sets[i] = posed(*bodies_[i].shape, bodies_[i].at, near[i]);
    } catch (const input_error &e) {
      throw input_error(e.where, bodies_[i].shape->kind(), "body " + bodies_[i].name + ", ");
    }
  });
  out.pose_seconds = seconds_since(start);

  // Many pairs share the threads, and few have all of them each. Pairs are begun in their order, and those that were begun are
  // ended, so that the first to touch is the same for any number of threads.
  const bool together = pairs.size() >= 2 * static_cast<std::size_t>(threads);
  std::mutex lock;
  chunk_counter counter(pairs.size(), 1);
  auto body_pairs = [&](int) {
    for (std::size_t i, end; counter.take(i, end);) {
      const pair_of_bodies &p = pairs[i];
      collide_options of_pair;
      of_pair.want = options.want;
      of_pair.threads = together ? 1 : threads;
      of_pair.box = options.box;
      const std::uint32_t first = p.by.swapped ? p.b : p.a, second = p.by.swapped ? p.a : p.b;
      of_pair.owner_a = bodies_[first].owners, of_pair.owner_b = bodies_[second].owners;
      result r = collide(*sets[first], *sets[second], *p.by.predicate, options.precision, of_pair);
      const std::scoped_lock hold(lock);
      out.candidates += r.candidates;
      if (r.count == 0)
        continue;
      out.touching.push_back({p.a, p.b, p.by.swapped ? exchanged(std::move(r)) : std::move(r)});
      if (options.first)
        counter.close();
    }
  };
  run_workers(together ? counter.workers(threads) : 1, counter, body_pairs);
  std::ranges::sort(out.touching, {}, [](const touching_bodies &t) { return std::pair(t.a, t.b); });
  if (options.first && out.touching.size() > 1)
    out.touching.resize(1);
  out.collide_seconds = seconds_since(start) - out.pose_seconds;
  return out;
}

} // namespace meetc
