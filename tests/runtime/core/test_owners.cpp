// Several elements form one item: each pair of items counts once.
#include "tests/catch.hpp"
#include "toy.hpp"

#include <set>

using namespace meetc;
using namespace toy;

TEST_CASE("pairs of items, each once, sorted") {
  const rows a = some_boxes(800, 1, 0.2f, 30), b = some_boxes(600, 1, 0.2f, 31);
  std::vector<std::uint32_t> owner_a(800), owner_b(600);
  std::mt19937 g(32);
  for (auto &o : owner_a)
    o = static_cast<std::uint32_t>(g() % 90) * 40'000'000u; // items need not be dense
  for (auto &o : owner_b)
    o = static_cast<std::uint32_t>(g() % 200);

  std::set<std::pair<std::uint32_t, std::uint32_t>> both, left, right;
  for (const index_pair p : brute(a, b, box_box_hit).pairs) {
    both.emplace(owner_a[p.a], owner_b[p.b]);
    left.emplace(owner_a[p.a], p.b);
    right.emplace(p.a, owner_b[p.b]);
  }
  const prepared x = prepare(view_of(a, boxes), boxes), y = prepare(view_of(b, boxes), boxes);
  const auto check = [&](const auto &want, bool use_a, bool use_b) {
    for (const int threads : {1, 4}) {
      collide_options o;
      o.threads = threads;
      if (use_a)
        o.owner_a = owner_a;
      if (use_b)
        o.owner_b = owner_b;
      const result r = collide(x, y, box_box_hit, rung::fp32, o);
      REQUIRE(r.pairs.size() == want.size());
      CHECK(std::equal(want.begin(), want.end(), r.pairs.begin(),
                       [](const auto &w, index_pair p) { return w.first == p.a && w.second == p.b; }));
      CHECK(r.count == want.size());
      o.want = answer_kind::count;
      const result counted = collide(x, y, box_box_hit, rung::fp32, o);
      CHECK(counted.count == want.size());
      CHECK(counted.pairs.empty());
    }
  };
  check(both, true, true);
  check(left, true, false);
  check(right, false, true);
}

TEST_CASE("many elements of few items stay few") { // past the first compaction of a list
  const rows a = some_boxes(1500, 0, 1, 33);
  std::vector<std::uint32_t> owner(1500);
  for (std::size_t i = 0; i < owner.size(); ++i)
    owner[i] = static_cast<std::uint32_t>(i % 7);
  const prepared x = prepare(view_of(a, boxes), boxes);
  collide_options o;
  o.owner_a = o.owner_b = owner;
  const result r = collide(x, x, box_box_hit, rung::fp32, o);
  CHECK(r.count == 49);
  CHECK(r.pairs.size() == 49);
  CHECK(r.candidates == 1500u * 1500u);
}
