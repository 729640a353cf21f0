// The values that a set stores for a predicate: once, when that pays, from its own rows, and only where it can be stored.
#include "tests/catch.hpp"
#include "toy.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

using namespace meetc;
using namespace toy;

namespace {

std::atomic<std::size_t> computed{0};
std::atomic<bool> refuses{false};

// The low x of a box, twice.
bool store_boxes(const float *rows, std::size_t n, float *out) {
  if (refuses)
    return false;
  computed += n;
  for (std::size_t i = 0; i < n; ++i)
    out[2 * i] = out[2 * i + 1] = rows[6 * i];
  return true;
}

std::atomic<std::uint64_t> with_stored{0}, without{0}, wrong{0};

// boxes_hit, with a check of the stored values for each pair.
void decide_stored(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  (a.stored && b.stored ? with_stored : without) += n;
  for (std::size_t i = 0; a.stored && b.stored && i < n; ++i)
    wrong +=
        a.stored[2 * pairs[i].a + 1] != a.rows[6 * pairs[i].a] || b.stored[2 * pairs[i].b] != b.rows[6 * pairs[i].b];
  decide<6, 6, boxes_hit>(a, b, pairs, n, out);
}

constexpr kind_info storing_boxes = [] {
  kind_info k = boxes;
  k.stored = 1;
  return k;
}();
constexpr predicate_info storing = [] {
  predicate_info p = plain("storing", "", storing_boxes, storing_boxes, decide_stored, decide_stored);
  p.decide[static_cast<int>(rung::fp64)] = decide_stored;
  p.stored_a = p.stored_b = p.plain_stored_a = p.plain_stored_b = {0, 2, store_boxes};
  return p;
}();

void forget() {
  computed = 0, with_stored = 0, without = 0, wrong = 0, refuses = false;
}

} // namespace

TEST_CASE("stored values are computed once for each set, from posed rows, when enough pairs were looked at") {
  forget();
  const rows some = some_boxes(10000, 1, 0.2f, 5), few = some_boxes(10, 1, 0.2f, 8);
  pose away;
  away.m[3] = 0.01;
  const prepared x = prepare(view_of(some, storing_boxes), storing_boxes),
                 y = prepare(view_of(some, storing_boxes), storing_boxes, away),
                 z = prepare(view_of(few, storing_boxes), storing_boxes);
  const auto want = collide(x, y, storing, rung::exact).pairs;
  CHECK(computed == 0); // exact does not read them
  CHECK(collide(z, x, storing, rung::fp32).count > 0);
  CHECK(computed == 10); // of the ten alone, for which the pairs are many
  CHECK(with_stored == 0);
  std::vector<std::thread> threads;
  std::atomic<int> alike{0};
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] { alike += same(collide(x, y, storing, rung::fp32).pairs, want); });
  for (std::thread &t : threads)
    t.join();
  CHECK(alike == 4);
  CHECK(computed == 20010);
  CHECK(with_stored > 0);
  CHECK(wrong == 0);
}

TEST_CASE("if nothing can be stored, pairs compute the values") {
  forget();
  const prepared x = prepare(view_of(some_boxes(500, 1, 0.5f, 6), storing_boxes), storing_boxes);
  refuses = true;
  const auto want = collide(x, x, storing, rung::exact).pairs;
  CHECK(same(collide(x, x, storing, rung::fp32).pairs, want));
  refuses = false;
  CHECK(same(collide(x, x, storing, rung::fp32).pairs, want)); // it is not tried again
  CHECK(with_stored == 0);
  CHECK(computed == 0);
}

TEST_CASE("values stored for the kind of one catalogue are not read for that of another") {
  forget();
  static constexpr kind_info same_name = storing_boxes;
  predicate_info other = storing;
  other.a = other.b = &same_name;
  other.stored_a.compute = other.stored_b.compute = other.plain_stored_a.compute =
      other.plain_stored_b.compute = [](const float *, std::size_t n, float *out) {
        std::fill_n(out, 2 * n, 7.0f);
        return true;
      };
  const prepared x = prepare(view_of(some_boxes(500, 1, 0.5f, 9), storing_boxes), storing_boxes);
  const auto want = collide(x, x, storing, rung::exact).pairs;
  CHECK(same(collide(x, x, other, rung::fp32).pairs, want));
  CHECK(with_stored == 0);
  CHECK(same(collide(x, x, storing, rung::fp32).pairs, want));
  CHECK(with_stored > 0);
  const std::uint64_t before = with_stored;
  CHECK(same(collide(x, x, other, rung::fp32).pairs, want));
  CHECK(with_stored == before);
  CHECK(wrong == 0);
}

TEST_CASE("pairs() keeps stored values in the caller's memory") {
  forget();
  const rows some = some_boxes(3000, 1, 0.2f, 7);
  const view v = view_of(some, storing_boxes);
  std::vector<std::byte> work(workspace(storing, 3000, 3000, 2));
  predicate_info poor = storing;
  poor.stored_a = poor.stored_b = poor.plain_stored_a = poor.plain_stored_b = {};
  CHECK(work.size() >= workspace(poor, 3000, 3000, 2) + 2 * 3000 * 2 * sizeof(float));
  std::uint64_t count = 0;
  pairs_options o;
  o.threads = 2;
  REQUIRE(pairs(storing, rung::fp32, v, {}, v, {}, {nullptr, 0, &count}, {work.data(), work.size()}, o) == status::ok);
  CHECK(computed == 6000);
  CHECK(with_stored > 0);
  CHECK(wrong == 0);
  CHECK(count == collide(prepare(v, storing_boxes), prepare(v, storing_boxes), storing, rung::exact).count);
}
