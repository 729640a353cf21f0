#include "meet/core/query/self_pairs.hpp"

#include "meet/core/answers/pair_list.hpp"
#include "meet/core/query/common_corners.hpp"
#include "meet/core/query/corner_numbers.hpp"
#include "meet/core/query/decide.hpp"
#include "meet/core/query/touching_query.hpp"
#include "meet/core/views/collinear.hpp"
#include "meet/core/views/usage_error.hpp"

#include <chrono>
#include <cstring>
#include <mutex>

namespace meetc {
namespace {

using corners_of = std::array<std::uint32_t, 3>;

// The mesh as the search sees it.
struct mesh_view {
  const element_set &set;
  const corner_numbers &corners; // by slot
  std::span<const std::uint32_t> owner;
  execution on;

  bool one_item(std::uint32_t s, std::uint32_t t) const {
    return !owner.empty() && owner[set.order[s]] == owner[set.order[t]];
  }
  index_pair elements(index_pair slots) const {
    const std::uint32_t a = set.order[slots.a], b = set.order[slots.b];
    return a < b ? index_pair{a, b} : index_pair{b, a};
  }
};

bool any_common(const corners_of &a, const corners_of &b) {
  bool any = false;
  for (const std::uint32_t x : a)
    any |= (x == b[0]) | (x == b[1]) | (x == b[2]);
  return any;
}

// ---- pairs without a common corner, by the hierarchy ----

class strangers final : public candidate_filter {
public:
  explicit strangers(const mesh_view &mesh) : mesh_(mesh) {}
  std::size_t keep(index_pair *slots, std::size_t n) const override {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; ++i) { // a slot has its own corners in common with itself
      const index_pair p = slots[i];
      slots[kept] = p;
      kept += !any_common(mesh_.corners[p.a], mesh_.corners[p.b]) && !mesh_.one_item(p.a, p.b);
    }
    return kept;
  }

private:
  const mesh_view &mesh_;
};

// Each pair once, with the lesser element first.
class rising_pairs final : public query_answer {
public:
  rising_pairs(const mesh_view &mesh, std::vector<pair_list> &to) : mesh_(mesh), to_(to) {}
  void start(const queried_sets &) override {}
  void take(int worker, const index_pair *hits, std::size_t n) override {
    for (std::size_t i = 0; i < n; ++i) {
      const index_pair p = mesh_.elements(hits[i]);
      to_[static_cast<std::size_t>(worker)].add(&p, 1);
    }
  }
  void finish(result &) override {}
  bool by_slots() const override { return true; }

private:
  const mesh_view &mesh_;
  std::vector<pair_list> &to_;
};

// ---- neighbours, by their common corners ----

// Pairs with so many common corners, whose predicate is asked of some at a time.
class neighbour_batch {
public:
  neighbour_batch(const mesh_view &mesh, const cascade &by, pair_list &to) : mesh_(mesh), by_(by), to_(to) {}

  // Corner order_s[i] of s is corner order_t[i] of t, for the common ones, which come first.
  void add(std::uint32_t s, const std::uint8_t *order_s, std::uint32_t t, const std::uint8_t *order_t) {
    write(rows_a_ + 9 * size_, s, order_s);
    write(rows_b_ + 9 * size_, t, order_t);
    pairs_[size_] = {static_cast<std::uint32_t>(size_), static_cast<std::uint32_t>(size_)};
    slots_[size_] = {s, t};
    if (++size_ == room)
      decide();
  }
  void decide() {
    mesh_.on.go_on();
    answer said[room];
    by_.decide({rows_a_}, {rows_b_}, pairs_, size_, said, false,
               [this](int at, std::span<const index_pair> left) { unsure[at] += left.size(); });
    for (std::size_t i = 0; i < size_; ++i)
      if (said[i] == answer::yes) {
        const index_pair p = mesh_.elements(slots_[i]);
        to_.add(&p, 1);
      }
    size_ = 0;
  }

  std::uint64_t unsure[bounded_rungs] = {};

private:
  static constexpr std::size_t room = 512;

  void write(float *to, std::uint32_t slot, const std::uint8_t *order) const {
    const float *const row = mesh_.set.rows + std::size_t{9} * slot;
    for (int c = 0; c < 3; ++c, to += 3)
      std::memcpy(to, row + std::size_t{3} * order[c], 3 * sizeof(float));
  }

  const mesh_view &mesh_;
  const cascade &by_;
  pair_list &to_;
  std::size_t size_ = 0;
  float rows_a_[9 * room], rows_b_[9 * room];
  index_pair pairs_[room], slots_[room];
};

// By bits of first corners.
constexpr std::array<common_order, 512> common_orders = [] {
  std::array<common_order, 512> all{};
  for (unsigned bits = 0; bits < 512; ++bits)
    all[bits] = order_by(bits);
  return all;
}();

// The neighbours of one slot after it, each where its first common corner leads to it.
class neighbour_search {
public:
  neighbour_search(const mesh_view &mesh, const corner_stars &stars, const cascade &one, const cascade &two,
                   pair_list &to)
      : mesh_(mesh), stars_(stars), batches_{{mesh, one, to}, {mesh, two, to}}, to_(to) {}

  void visit(std::uint32_t s) {
    const corners_of &mine = mesh_.corners[s];
    const unsigned first = bits_of_first(mine.data());
    for (unsigned c = 0; c < 3; ++c) {
      if ((first >> (3 * c) & 1) == 0)
        continue;
      const std::span<const std::uint32_t> around = stars_.of(mine[c]);
      for (std::size_t i = around.size(); i-- > 0 && around[i] > s;) {
        if ((i & 0xfff) == 0xfff)
          mesh_.on.go_on();
        meet(s, c, around[i], first);
      }
    }
  }
  void finish(self_result &r) {
    for (neighbour_batch &b : batches_) {
      b.decide();
      for (int i = 0; i < bounded_rungs; ++i)
        r.rungs.unsure[i] += b.unsure[i];
    }
    for (int k = 0; k < 3; ++k)
      r.neighbours[k] += found_[k];
  }

private:
  // They have corner c of s in common.
  void meet(std::uint32_t s, unsigned c, std::uint32_t t, unsigned first) {
    const common_order &o = common_orders[common_bits(mesh_.corners[s].data(), mesh_.corners[t].data()) & first];
    if (o.mine[0] < c || mesh_.one_item(s, t)) // it was met there
      return;
    ++found_[o.common - 1];
    if (o.common < 3)
      return batches_[o.common - 1].add(s, o.mine, t, o.theirs);
    const index_pair p = mesh_.elements({s, t});
    to_.add(&p, 1);
  }

  const mesh_view &mesh_;
  const corner_stars &stars_;
  neighbour_batch batches_[2];
  pair_list &to_;
  std::uint64_t found_[3] = {};
};

void search_neighbours(const mesh_view &mesh, const self_predicates &by, std::vector<pair_list> &to, self_result &r) {
  const corner_stars stars(mesh.corners, mesh.on);
  const cascade one(by.one_common, rung::certified), two(by.two_common, rung::certified);
  std::mutex hold;
  chunk_counter counter(mesh.set.elements, 1024);
  auto body = [&](int worker) {
    const auto search = std::make_unique<neighbour_search>(mesh, stars, one, two, to[static_cast<std::size_t>(worker)]);
    for (std::size_t slot, end; counter.take(slot, end);)
      for (; slot < end; ++slot) {
        if ((slot & 0x3f) == 0)
          mesh.on.go_on();
        search->visit(static_cast<std::uint32_t>(slot));
      }
    const std::scoped_lock lock(hold);
    search->finish(r);
  };
  run_workers(counter.workers(mesh.on.threads), counter, body);
}

void search_others(const mesh_view &mesh, const query_operand &of, const self_predicates &by,
                   const self_options &options, std::vector<pair_list> &to, self_result &r) {
  const cascade apart(by.apart, rung::certified);
  const tree_pairs source(of.given.set(), of.given.set(), what_rules_out(rung::certified), true);
  const strangers only(mesh);
  rising_pairs answer(mesh, to);
  query_answer *const answers[] = {&answer};
  const auto report = [](void *context, double fraction) {
    (*static_cast<const std::function<void(double)> *>(context))(fraction);
  };
  const std::unique_ptr<std::byte[]> batches(new std::byte[batch_bytes(mesh.on.threads)]);
  const tally total =
      decide_all({of.set(), of.set(), of.stored(apart.stored_a, *by.apart.a), of.stored(apart.stored_b, *by.apart.b),
                  apart, source, mesh.on, options.progress ? +report : nullptr,
                  const_cast<std::function<void(double)> *>(&options.progress), answers, false, &only},
                 {batches.get(), batch_bytes(mesh.on.threads)});
  r.candidates = total.candidates;
  for (int i = 0; i < bounded_rungs; ++i)
    r.rungs.unsure[i] += total.rungs.unsure[i];
}

std::vector<std::uint32_t> without_extent(const element_set &set, const execution &on) {
  std::vector<std::uint8_t> flat(set.elements);
  for_chunks(on, set.elements, 4096, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      flat[set.order[slot]] = collinear(set.rows + 9 * slot);
  });
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < flat.size(); ++i)
    if (flat[i])
      out.push_back(static_cast<std::uint32_t>(i));
  return out;
}

self_result find_self_pairs(const prepared &set, const view &elements, const self_predicates &by,
                            const self_options &options) {
  const auto start = std::chrono::steady_clock::now();
  bool scales = true;
  for (const predicate_info *p : {&by.apart, &by.one_common, &by.two_common}) {
    require(p->a->points == 3 && p->a->fields == 9 && same_kind(*p->a, set.kind()) && same_kind(*p->b, set.kind()),
            "the predicates of a mesh with itself take two elements of its kind, with three points");
    require(cascade(*p, rung::certified).count > 0, text(status::no_such_rung));
    scales = scales && p->scales;
  }
  require(set.whole(), "a mesh with itself is prepared without a counterpart");
  require(elements.elements == set.elements(), "the view is not the one from which the mesh was prepared");
  require(options.owner.empty() || options.owner.size() == set.elements(),
          "an owner map needs one item for each element");
  query_operand of{set, nullptr}, same{set, nullptr};
  if (scales)
    normalise(of, same, options.stop);
  const execution on = execution_on(options.threads, options.stop);
  const corner_numbers corners = numbers_of_corners(set.set(), elements, options.merge, on);
  const mesh_view mesh{of.set(), corners, options.owner, on};
  std::vector<pair_list> found(static_cast<std::size_t>(on.threads));
  self_result r;
  search_neighbours(mesh, by, found, r);
  search_others(mesh, of, by, options, found, r);
  r.pairs = sorted(std::move(found), on);
  r.degenerate = without_extent(of.set(), on);
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace

self_result self_pairs(const prepared &set, const view &elements, const self_predicates &predicates,
                       const self_options &options) {
  return under_standard_word([&] { return find_self_pairs(set, elements, predicates, options); });
}

} // namespace meetc
