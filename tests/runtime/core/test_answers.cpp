// Counts, flags and any, for every element, by both layers, with owners and without, against brute force.
#include "tests/catch.hpp"
#include "toy.hpp"

#include "meet/core/answers/pair_list.hpp"

#include <set>

using namespace meetc;
using namespace toy;

namespace {

struct wanted {
  std::vector<index_pair> pairs;
  std::vector<std::uint64_t> counts_a, counts_b;
  std::vector<std::uint8_t> flags_a, flags_b;
};

// The answers that distinct pairs give for each of n elements or items.
wanted from(std::vector<index_pair> pairs, std::size_t a, std::size_t b) {
  wanted w{std::move(pairs), std::vector<std::uint64_t>(a), std::vector<std::uint64_t>(b), {}, {}};
  for (const index_pair p : w.pairs)
    ++w.counts_a[p.a], ++w.counts_b[p.b];
  for (const std::uint64_t n : w.counts_a)
    w.flags_a.push_back(n > 0);
  for (const std::uint64_t n : w.counts_b)
    w.flags_b.push_back(n > 0);
  return w;
}

void agree(const prepared &x, const prepared &y, const predicate_info &p, const wanted &want, collide_options o) {
  for (const int threads : {1, 2, 7}) {
    o.threads = threads;
    const auto ask = [&](answer_kind kind) {
      o.want = kind;
      return collide(x, y, p, rung::fp32, o);
    };
    const result pairs = ask(answer_kind::pairs), count = ask(answer_kind::count), counts = ask(answer_kind::counts),
                 flags = ask(answer_kind::flags), any = ask(answer_kind::any);
    CHECK(same(pairs.pairs, want.pairs));
    CHECK(counts.counts.a == want.counts_a);
    CHECK(counts.counts.b == want.counts_b);
    CHECK(flags.flags.a == want.flags_a);
    CHECK(flags.flags.b == want.flags_b);
    for (const result *r : {&pairs, &count, &counts, &flags})
      CHECK(r->count == want.pairs.size());
    CHECK(any.count == (want.pairs.empty() ? 0 : 1));
    // All else is empty.
    for (const result *r : {&count, &counts, &flags, &any})
      CHECK(r->pairs.empty());
    for (const result *r : {&pairs, &count, &counts, &any})
      CHECK((r->flags.a.empty() && r->flags.b.empty()));
    for (const result *r : {&pairs, &count, &flags, &any})
      CHECK((r->counts.a.empty() && r->counts.b.empty()));
  }
}

void agree(const rows &a, const rows &b, const predicate_info &p) {
  const prepared x = prepare(view_of(a, *p.a), *p.a), y = prepare(view_of(b, *p.b), *p.b);
  agree(x, y, p, from(brute(a, b, p).pairs, x.elements(), y.elements()), {});
}

} // namespace

TEST_CASE("every kind of answer is that of brute force, on any number of threads") {
  const rows a = some_boxes(900, 1, 0.2f, 110), b = some_boxes(700, 1, 0.2f, 111);
  agree(a, b, box_box_hit);
  agree(a, a, box_box_hit);
  agree(some_balls(500, 1, 0.2f, 112), some_balls(800, 1, 0.2f, 113), ball_ball_hit);
  agree(some_boxes(400, 0, 1, 114), some_boxes(300, 0, 1, 115), box_box_hit); // all touch all
  agree({}, b, box_box_hit);
  agree(a, {}, box_box_hit);
  rows away = b;
  for (std::size_t i = 0; i < away.size(); i += 3)
    away[i] += 100;
  agree(a, away, box_box_hit); // nothing touches
}

TEST_CASE("answers are of items where there are owners") {
  const rows a = some_boxes(800, 1, 0.2f, 116), b = some_boxes(600, 1, 0.2f, 117);
  std::mt19937 g(118);
  std::vector<std::uint32_t> owner_a(800), owner_b(600);
  for (auto &o : owner_a)
    o = static_cast<std::uint32_t>(g() % 90);
  for (auto &o : owner_b)
    o = static_cast<std::uint32_t>(g() % 200);
  owner_a[17] = 95; // items without elements lie between
  std::set<std::pair<std::uint32_t, std::uint32_t>> both, left;
  for (const index_pair p : brute(a, b, box_box_hit).pairs) {
    both.emplace(owner_a[p.a], owner_b[p.b]);
    left.emplace(owner_a[p.a], p.b);
  }
  const auto list = [](const auto &set) {
    std::vector<index_pair> out;
    for (const auto &[x, y] : set)
      out.push_back({x, y});
    return out;
  };
  const prepared x = prepare(view_of(a, boxes), boxes), y = prepare(view_of(b, boxes), boxes);
  CHECK(items(owner_a, 800) == 96);
  CHECK(items({}, 800) == 800);
  collide_options o;
  o.owner_a = owner_a;
  agree(x, y, box_box_hit, from(list(left), 96, 600), o);
  o.owner_b = owner_b;
  agree(x, y, box_box_hit, from(list(both), 96, items(owner_b, 600)), o);
}

TEST_CASE("flags and counts in the caller's memory") {
  const rows a = some_boxes(900, 1, 0.2f, 119), b = some_boxes(700, 1, 0.2f, 120);
  const wanted want = from(brute(a, b, box_box_hit).pairs, 900, 700);
  for (const int threads : {1, 4}) {
    std::vector<std::byte> work(workspace(box_box_hit, 900, 700, threads));
    std::vector<std::uint64_t> counts_a(900, 7), counts_b(700, 7);
    std::vector<std::uint8_t> flags_a(900, 7), flags_b(700, 7);
    std::vector<index_pair> list(want.pairs.size());
    std::uint64_t count = 0;
    pairs_out out{list.data(), list.size(), &count};
    out.flags_a = flags_a.data(), out.flags_b = flags_b.data();
    out.counts_a = counts_a.data(), out.counts_b = counts_b.data();
    const auto ask = [&](const pairs_options &options) {
      return pairs(box_box_hit, rung::fp32, view_of(a, boxes), {}, view_of(b, boxes), {}, out,
                   {work.data(), work.size()}, options);
    };
    REQUIRE(ask({.threads = threads}) == status::ok);
    CHECK(same(list, want.pairs));
    CHECK(count == want.pairs.size());
    CHECK((counts_a == want.counts_a && counts_b == want.counts_b));
    CHECK((flags_a == want.flags_a && flags_b == want.flags_b));
    // Only one side, without a list.
    std::fill(flags_b.begin(), flags_b.end(), std::uint8_t{7});
    out = {nullptr, 0, &count};
    out.flags_b = flags_b.data();
    REQUIRE(ask({.threads = threads}) == status::ok);
    CHECK(count == want.pairs.size());
    CHECK(flags_b == want.flags_b);
    // The first pair sets no flag and no count.
    REQUIRE(ask({.threads = threads, .stop_at_first = true}) == status::ok);
    CHECK(count == 1);
    CHECK(flags_b == std::vector<std::uint8_t>(700));
    // A refused call leaves them unchanged.
    flags_b[3] = 9;
    work.resize(8);
    CHECK(ask({.threads = threads}) == status::workspace_too_small);
    CHECK(flags_b[3] == 9);
  }
}

TEST_CASE("a transposed list") {
  const std::vector<index_pair> list{{0, 5}, {1, 2}, {1, 9}, {4, 0}, {4, 5}};
  CHECK(same(transposed(list), {{0, 4}, {2, 1}, {5, 0}, {5, 4}, {9, 1}}));
  CHECK(transposed({}).empty());
}
