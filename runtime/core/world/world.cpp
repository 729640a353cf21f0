#include "meet/core/world/world.hpp"

#include "meet/core/sets/posed_blocks.hpp"
#include "meet/core/threads/threads.hpp"
#include "meet/core/views/usage_error.hpp"
#include "meet/core/world/nesting.hpp"

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

// The posed boxes of the parts of a set: those of the highest level that has eight or more, or its elements' boxes.
std::vector<box> parts_of(const element_set &set, const pose &at) {
  int level = set.boxes.depth - 1;
  while (level > 0 && set.boxes.levels[level].boxes < 8)
    --level;
  std::vector<box> out;
  for (std::size_t i = 0; i < set.boxes.levels[level].boxes; ++i)
    out.push_back(posed_box(at, set.boxes.levels[level].get(i), set.longest));
  return out;
}

// The winding number of a kind's elements, or null where none is generated.
auto winding_of(const catalogue &all, const kind_info &kind) {
  decltype(predicate_info::winding) found = nullptr;
  for (int i = 0; i < all.predicate_count && !found; ++i)
    if (all.predicates[i].b == &kind)
      found = all.predicates[i].winding;
  return found;
}

void require_movable(const std::string &name, const kind_info &kind, const pose &at) {
  if (const status s = movable(kind, at); s != status::ok)
    throw usage_error("body " + name + ": " + text(s));
}

} // namespace

touching_bodies near_bodies::told(result found) const {
  return {a, b, by.swapped ? turned(std::move(found)) : std::move(found)};
}

world::world(const catalogue &all, std::string_view mode) : all_(all), mode_(mode) {}

std::uint32_t world::add(std::string name, std::shared_ptr<const prepared> shape, const pose &at,
                         std::vector<std::uint32_t> owners) {
  if (name.empty())
    throw usage_error("a body needs a name");
  if (!shape || !shape->whole())
    throw usage_error("body " + name + ": it needs a set that was prepared for any other");
  if (!owners.empty() && owners.size() != shape->elements())
    throw usage_error("body " + name + ": an owner map needs one item for each element");
  require_movable(name, shape->kind(), at);
  const auto number = static_cast<std::uint32_t>(bodies_.size());
  if (!numbers_.try_emplace(name, number).second)
    throw usage_error("body " + name + ": the name is taken");
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
  throw usage_error("no predicate decides a " + std::string(kind_a.name) + " and a " + kind_b.name +
                    ", as of the bodies " + a.name + " and " + b.name + "; ignore the pair");
}

world_answer world::touching(const world_options &options) const {
  return under_standard_word([&] { return ask(options); });
}

std::vector<box> world::bounds() const {
  std::vector<box> out;
  for (const entry &b : bodies_)
    out.push_back(posed_box(b.at, b.shape->set().around, b.shape->set().longest));
  return out;
}

std::vector<near_bodies> world::near(std::span<const std::uint32_t> of) const {
  return under_standard_word([&] { return near_pairs(bounds(), of, 1); });
}

std::vector<near_bodies> world::near_pairs(std::span<const box> bounds, std::span<const std::uint32_t> of,
                                           const execution &on) const {
  std::vector<std::uint8_t> asked(bodies_.size(), 0);
  for (const std::uint32_t body : of)
    asked.at(body) = 1;
  std::vector<near_bodies> out;
  const bounds_of_bodies all(bounds);
  for (std::uint32_t a = 0; a < bodies_.size(); ++a) {
    on.go_on();
    all.after(a, [&](std::size_t other) {
      const auto b = static_cast<std::uint32_t>(other);
      const bool is_asked = of.empty() || asked[a] != asked[b];
      if (is_asked && bodies_[a].shape->elements() > 0 && bodies_[b].shape->elements() > 0 &&
          !ignored_.contains({a, b}))
        out.push_back({a, b, predicate_of(bodies_[a], bodies_[b])});
    });
  }
  return out;
}

// Poses each body that is near another, with the elements that lie near that one.
void world::pose_shapes(std::span<const box> bounds, std::span<const near_bodies> pairs, const execution &on,
                        std::vector<prepared> &shapes) const {
  std::vector<std::vector<std::uint32_t>> near(bodies_.size());
  for (const near_bodies &p : pairs)
    near[p.a].push_back(p.b), near[p.b].push_back(p.a);
  std::vector<std::vector<box>> parts(bodies_.size());
  for_chunks(on, bodies_.size(), 1, [&](int, std::size_t i, std::size_t) {
    if (!near[i].empty())
      parts[i] = parts_of(bodies_[i].shape->set(), bodies_[i].at);
  });
  shapes.resize(bodies_.size());
  for_chunks(on, bodies_.size(), 1, [&](int, std::size_t i, std::size_t) {
    if (near[i].empty())
      return;
    std::vector<box> to;
    for (const std::uint32_t other : near[i])
      std::ranges::copy_if(parts[other], std::back_inserter(to), [&](const box &b) { return !apart(b, bounds[i]); });
    try {
      shapes[i] = posed(*bodies_[i].shape, bodies_[i].at, to, std::move(shapes[i]), on.stop);
    } catch (const input_error &e) {
      throw input_error(e.where, bodies_[i].shape->kind(), "body " + bodies_[i].name + ", ");
    }
  });
}

result world::collide_pair(const near_bodies &p, std::span<const prepared> shapes, const world_options &options,
                           int threads) const {
  collide_options of_pair;
  of_pair.want = options.want;
  of_pair.threads = threads;
  of_pair.box = options.box;
  of_pair.stop = options.stop;
  of_pair.owner_a = bodies_[p.first()].owners, of_pair.owner_b = bodies_[p.second()].owners;
  return collide(shapes[p.first()], shapes[p.second()], *p.by.predicate, options.precision, of_pair);
}

void world::require_nesting(const world_options &options) const {
  if (mode_ != "solid")
    throw usage_error("nested: in the mode " + mode_ + " no body has an inside");
  if (!never_wrong(options.precision))
    throw usage_error("nested: it is told of bodies that do not touch for certain: exact or certified");
  for (int i = 0; i < all_.kind_count; ++i)
    if (winding_of(all_, all_.kinds[i]))
      return;
  throw usage_error("nested: the catalogue has no winding number");
}

std::vector<nested_bodies> world::nested(std::span<const near_bodies> apart, const world_options &options) const {
  return under_standard_word([&] {
    require_nesting(options);
    return nested_pairs(apart, options.first, execution_on(options.threads, options.stop));
  });
}

std::vector<nested_bodies> world::nested_pairs(std::span<const near_bodies> apart, bool first,
                                               const execution &on) const {
  std::vector<std::optional<nesting_found>> found(apart.size());
  for_chunks(on, apart.size(), 1, [&](int, std::size_t i, std::size_t) {
    const entry &a = bodies_[apart[i].a], &b = bodies_[apart[i].b];
    found[i] = nesting_of({a.name, *a.shape, a.at, a.owners, winding_of(all_, a.shape->kind())},
                          {b.name, *b.shape, b.at, b.owners, winding_of(all_, b.shape->kind())}, on);
  });
  std::vector<nested_bodies> out;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    if (!found[i])
      continue;
    out.push_back({apart[i].a, apart[i].b, found[i]->how, std::move(found[i]->why)});
    if (first && out.back().how != nesting::unknown)
      break;
  }
  return out;
}

world_answer world::ask(const world_options &options) const {
  const auto start = clock::now();
  const execution on = execution_on(options.threads, options.stop);
  if (options.nested)
    require_nesting(options);
  const std::vector<box> bounds = this->bounds();
  const std::vector<near_bodies> pairs = near_pairs(bounds, options.of, on);
  std::vector<prepared> shapes;
  {
    const std::scoped_lock hold(*lock_);
    shapes = std::move(spare_);
  }
  pose_shapes(bounds, pairs, on, shapes);
  world_answer out;
  out.near = pairs.size();
  out.pose_seconds = seconds_since(start);

  // Many pairs share the threads, and few have all of them each. Pairs are begun in their order, and those that were begun are
  // ended, so that the first to touch is the same for any number of threads.
  const bool together = pairs.size() >= 2 * static_cast<std::size_t>(on.threads);
  std::mutex lock;
  std::vector<std::uint8_t> touch(pairs.size(), 0);
  chunk_counter counter(pairs.size(), 1);
  auto next = clock::now();
  auto body = [&](int worker) {
    for (std::size_t i, end; counter.take(i, end);) {
      if (worker == 0 && options.progress && clock::now() >= next) {
        options.progress(counter.fraction());
        next = clock::now() + std::chrono::milliseconds(100);
      }
      result r = collide_pair(pairs[i], shapes, options, together ? 1 : on.threads);
      const std::scoped_lock hold(lock);
      out.candidates += r.candidates;
      if (r.count == 0)
        continue;
      touch[i] = 1;
      out.touching.push_back(pairs[i].told(std::move(r)));
      if (options.first)
        counter.close();
    }
  };
  run_workers(together ? counter.workers(on.threads) : 1, counter, body);
  std::ranges::sort(out.touching, {}, [](const touching_bodies &t) { return std::pair(t.a, t.b); });
  if (options.first && out.touching.size() > 1)
    out.touching.resize(1);
  if (options.nested && !(options.first && !out.touching.empty())) {
    std::vector<near_bodies> apart;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (touch[i] == 0)
        apart.push_back(pairs[i]);
    out.nested = nested_pairs(apart, options.first, on);
  }
  const std::scoped_lock hold(*lock_);
  spare_ = std::move(shapes);
  out.collide_seconds = seconds_since(start) - out.pose_seconds;
  return out;
}

} // namespace meetc
