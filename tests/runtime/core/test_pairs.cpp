// The layer in the caller's memory: how it is called, its statuses, and that it allocates nothing.
#include "tests/catch.hpp"
#include "toy.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

using namespace meetc;
using namespace toy;

namespace {
std::atomic<std::uint64_t> allocations{0};
}
void *operator new(std::size_t n) {
  ++allocations;
  if (void *p = std::malloc(n ? n : 1))
    return p;
  throw std::bad_alloc();
}
void *operator new(std::size_t n, const std::nothrow_t &) noexcept {
  ++allocations;
  return std::malloc(n ? n : 1);
}
void operator delete(void *p) noexcept {
  std::free(p);
}
void operator delete(void *p, std::size_t) noexcept {
  std::free(p);
}

namespace {

struct call {
  const predicate_info *predicate = &box_box_hit;
  view a, b;
  rung precision = rung::fp32;
  pose at_a = {}, at_b = {};
  pairs_options options = {};
  std::vector<index_pair> out = {};
  std::uint64_t count = 99;
  std::vector<std::byte> work = {};

  status run(std::size_t capacity) {
    out.resize(capacity);
    work.resize(workspace(*predicate, a.elements, b.elements, options.threads));
    return again();
  }
  status again() {
    return pairs(*predicate, precision, a, at_a, b, at_b, {out.data(), out.size(), &count}, {work.data(), work.size()},
                 options);
  }
};

} // namespace

TEST_CASE("count first, then pairs, too little room says how much") {
  const rows a = some_boxes(700, 1, 0.4f, 70), b = some_boxes(900, 1, 0.4f, 71);
  const auto want = brute(a, b, box_box_hit).pairs;
  REQUIRE(want.size() > 1000);
  const auto before = [](index_pair x, index_pair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
  for (const int threads : {1, 2, 5}) {
    call c{.a = view_of(a, boxes), .b = view_of(b, boxes)};
    c.options.threads = threads;
    CHECK(c.run(0) == status::ok);
    CHECK(c.count == want.size());
    CHECK(c.run(1000) == status::ok);
    CHECK(c.count == want.size());
    for (const index_pair p : c.out) // some of them
      REQUIRE(std::binary_search(want.begin(), want.end(), p, before));
    CHECK(c.run(want.size()) == status::ok);
    CHECK(c.count == want.size());
    CHECK(same(c.out, want));
    CHECK(c.run(want.size() + 10) == status::ok);
    c.out.resize(want.size());
    CHECK(same(c.out, want));
  }
}

TEST_CASE("on one thread nothing is allocated") {
  const rows a = some_boxes(3000, 1, 0.1f, 72), b = some_boxes(2500, 1, 0.1f, 73);
  call c{.a = view_of(a, boxes), .b = view_of(b, boxes)};
  c.options.threads = 1;
  REQUIRE(c.run(100'000) == status::ok);
  c.at_b.m[3] = 0.25;
  const std::uint64_t before = allocations;
  const status s = c.again();
  const std::uint64_t after = allocations;
  CHECK(s == status::ok);
  CHECK(after == before);
}

TEST_CASE("the workspace suffices at any alignment, and less is refused") {
  const rows a = some_boxes(333, 1, 0.2f, 74);
  const std::size_t want = brute(a, a, box_box_hit).pairs.size();
  const view v = view_of(a, boxes);
  for (const int threads : {1, 3}) {
    const std::size_t need = workspace(box_box_hit, 333, 333, threads);
    for (std::size_t shift = 0; shift < 70; shift += 3) {
      // Exactly the size that was asked for, so that a sanitizer sees one byte too many.
      const std::unique_ptr<std::byte[]> bytes(new std::byte[shift + need]);
      std::uint64_t count = 0;
      const pairs_options options{.threads = threads};
      const memory work{bytes.get() + shift, need};
      REQUIRE(pairs(box_box_hit, rung::fp32, v, {}, v, {}, {nullptr, 0, &count}, work, options) == status::ok);
      REQUIRE(count == want);
      const memory less{bytes.get() + shift, need - 1};
      REQUIRE(pairs(box_box_hit, rung::fp32, v, {}, v, {}, {nullptr, 0, &count}, less, options) ==
              status::workspace_too_small);
      REQUIRE(count == 0);
    }
  }
}

TEST_CASE("stop at the first") {
  const rows a = some_boxes(2000, 0, 1, 75), far = some_boxes(50, 1, 0.1f, 76, 100);
  for (const int threads : {1, 4}) {
    call c{.a = view_of(a, boxes), .b = view_of(a, boxes)};
    c.options.threads = threads;
    c.options.stop_at_first = true;
    CHECK(c.run(0) == status::ok);
    CHECK(c.count == 1);
    c.b = view_of(far, boxes);
    CHECK(c.run(5) == status::ok);
    CHECK(c.count == 0);
  }
}

TEST_CASE("every status has its cause, and leaves the count at 0") {
  rows a = some_balls(100, 1, 0.1f, 77);
  const auto fresh = [&] { return call{.predicate = &ball_ball_hit, .a = view_of(a, balls), .b = view_of(a, balls)}; };
  CHECK(fresh().run(10) == status::ok);

  call c = fresh();
  c.precision = rung::exact;
  CHECK(c.run(10) == status::no_such_rung);
  CHECK(c.count == 0);

  c = fresh();
  CHECK(pairs(*c.predicate, c.precision, c.a, {}, c.b, {}, {}, {}) == status::bad_argument);
  std::uint64_t count = 9;
  CHECK(pairs(*c.predicate, c.precision, c.a, {}, c.b, {}, {nullptr, 5, &count}, {}) == status::bad_argument);
  CHECK(pairs(*c.predicate, c.precision, c.a, {}, c.b, {}, {nullptr, 0, &count}, {}) == status::workspace_too_small);
  CHECK(count == 0);

  const view too_many{a.data(), 0, 16, nullptr, std::size_t{1} << 32};
  CHECK(pairs(*c.predicate, c.precision, too_many, {}, c.b, {}, {nullptr, 0, &count}, {}) == status::too_many_elements);

  a[4 * 50 + 3] = -1;
  CHECK(fresh().run(10) == status::bad_value);
  a[4 * 50 + 3] = std::numeric_limits<float>::quiet_NaN();
  CHECK(fresh().run(10) == status::bad_value);
  a[4 * 50 + 3] = 0;
  c = fresh();
  c.at_a.m[5] = 1e300;
  CHECK(c.run(10) == status::bad_value);

  const std::uint32_t index[] = {0, 1, 2, 3};
  call r{.predicate = &rod_rod_hit, .a = {a.data(), 4, 12, index, 2}, .b = {a.data(), 3, 12, index, 2}};
  CHECK(r.run(10) == status::bad_index);
  r.b.vertices = 4;
  CHECK(r.run(10) == status::ok);
  CHECK(std::string(text(status::bad_index)) == "an index lies beyond the vertices");
}

TEST_CASE("a pose moves one side, as if the rows had been moved") {
  const rows a = some_boxes(400, 1, 0.3f, 78), b = some_boxes(400, 1, 0.3f, 79);
  rows moved = b;
  for (std::size_t i = 0; i < moved.size(); ++i)
    moved[i] = static_cast<float>(static_cast<double>(b[i]) * 1.5 + (i % 3 == 2 ? 0.3 : 0.0));
  call c{.a = view_of(a, boxes), .b = view_of(b, boxes)};
  c.at_b.m[0] = c.at_b.m[5] = c.at_b.m[10] = 1.5;
  c.at_b.m[11] = 0.3;
  const auto want = brute(a, moved, box_box_hit).pairs;
  REQUIRE(c.run(want.size()) == status::ok);
  CHECK(same(c.out, want));
}
