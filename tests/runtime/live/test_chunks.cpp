// Results in chunks: the whole list in its order, cut where it was asked for, in memory that does not grow with it.
#include "scenes.hpp"
#include "tests/catch.hpp"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace live_test;

namespace {

// All pairs of the chunks; each but the last must have `chunk` of them.
std::vector<index_pair> joined(const prepared &a, const prepared &b, const predicate_info &p, rung precision,
                               std::size_t chunk, const collide_options &o, result *told = nullptr) {
  std::vector<index_pair> out;
  bool last = false;
  const result r = collide_in_chunks(
      a, b, p, precision, chunk,
      [&](std::span<const index_pair> pairs) {
        CHECK(!last);
        CHECK(!pairs.empty());
        CHECK(pairs.size() <= chunk);
        last = pairs.size() < chunk;
        out.insert(out.end(), pairs.begin(), pairs.end());
      },
      o);
  CHECK(r.pairs.empty());
  CHECK(r.count == out.size());
  if (told)
    *told = r;
  return out;
}

} // namespace

TEST_CASE("chunks make the list of a query, for each size, rung and number of threads") {
  const predicate_info &p = predicate("triangle_triangle");
  const mesh a = self_test::eight_torus(0.6, 40, 30), b = shaken(a, 0.05F, 7);
  const prepared set_a = prepare(a.view(), *p.a), set_b = prepare(b.view(), *p.b);
  for (const rung precision : rungs) {
    const result want = collide(set_a, set_b, p, precision);
    for (const std::size_t chunk : {std::size_t{1}, std::size_t{7}, std::size_t{1000}, std::size_t{1} << 40})
      for (const int threads : {1, 3}) {
        collide_options o;
        o.threads = threads;
        result told;
        CHECK((plain(joined(set_a, set_b, p, precision, chunk, o, &told)) == plain(want.pairs)));
        CHECK(told.candidates == want.candidates);
        CHECK(std::equal(told.rungs.unsure, told.rungs.unsure + bounded_rungs, want.rungs.unsure));
      }
  }
  CHECK(plain(joined(set_a, set_a, p, rung::certified, 100, {})) ==
        plain(collide(set_a, set_a, p, rung::certified).pairs));
}

TEST_CASE("chunks of more pairs than there is room for are found in parts") {
  const predicate_info &p = predicate("box_box");
  const std::vector<float> many = nested_boxes(700), few = nested_boxes(3);
  const prepared a = prepare(rows(many, *p.a), *p.a), b = prepare(rows(few, *p.a), *p.a);
  for (const int threads : {1, 2}) {
    collide_options o;
    o.threads = threads;
    CHECK((plain(joined(a, a, p, rung::certified, 64, o)) == plain(collide(a, a, p, rung::certified).pairs)));
    CHECK((plain(joined(b, a, p, rung::certified, 64, o)) == plain(collide(b, a, p, rung::certified).pairs)));
  }
  // Items: ten boxes each, in an order that is not theirs; and one item that owns all.
  collide_options o;
  std::vector<std::uint32_t> owner_a, owner_b(700, 5);
  for (std::uint32_t i = 0; i < 700; ++i)
    owner_a.push_back(3 * (i * 37 % 70));
  o.owner_a = owner_a;
  CHECK((plain(joined(a, a, p, rung::certified, 64, o)) == plain(collide(a, a, p, rung::certified, o).pairs)));
  o.owner_b = owner_b;
  CHECK((plain(joined(a, a, p, rung::certified, 64, o)) == plain(collide(a, a, p, rung::certified, o).pairs)));
  o.owner_a = owner_b;
  CHECK(joined(a, a, p, rung::certified, 64, o).size() == 1);
  // Numbers far from 1 are multiplied for the kernels.
  std::vector<float> large = many;
  for (float &x : large)
    x *= 0x1p60F;
  const prepared far = prepare(rows(large, *p.a), *p.a);
  CHECK(joined(far, far, p, rung::certified, 64, {}).size() == 700 * 700);
}

// Rows of whole numbers below `size`, times 2^power.
std::vector<float> lattice(const kind_info &kind, std::size_t n, int size, int power, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<float> out(n * static_cast<std::size_t>(kind.fields));
  for (float &x : out)
    x = std::ldexp(static_cast<float>(random() % static_cast<unsigned>(size)), power);
  return out;
}

TEST_CASE("sets at the ends of float32 have the pairs of sets at 1, whole and in chunks") {
  for (const char *const name :
       {"ball_segment", "segment_segment", "segment_triangle", "triangle_triangle", "ball_ball"}) {
    const predicate_info &p = predicate(name);
    constexpr std::size_t n = 600;
    std::vector<index_pair> want;
    for (const int power : {0, 110, -126, -146}) {
      CAPTURE(name, power);
      const auto rows_a = lattice(*p.a, n, 12, power, 3), rows_b = lattice(*p.b, n, 12, power, 4);
      const prepared a = prepare({.data = rows_a.data(), .elements = n}, *p.a),
                     b = prepare({.data = rows_b.data(), .elements = n}, *p.b);
      const std::vector<index_pair> found = collide(a, b, p, rung::certified).pairs;
      if (power == 0)
        want = found;
      CHECK(!found.empty());
      CHECK(plain(found) == plain(want));
      CHECK(plain(joined(a, b, p, rung::certified, 100, {})) == plain(want));
    }
  }
}

TEST_CASE("what chunks cannot be is refused") {
  const predicate_info &p = predicate("box_box");
  const std::vector<float> boxes = nested_boxes(10);
  const prepared a = prepare(rows(boxes, *p.a), *p.a), none = prepare(view{}, *p.a);
  const auto never = [](std::span<const index_pair>) { FAIL("there is a chunk"); };
  collide_options o;
  CHECK_THROWS_AS(collide_in_chunks(a, a, p, rung::certified, 0, never, o), std::invalid_argument);
  o.want = answer_kind::count;
  CHECK_THROWS_AS(collide_in_chunks(a, a, p, rung::certified, 10, never, o), std::invalid_argument);
  CHECK(collide_in_chunks(a, none, p, rung::certified, 10, never).count == 0);
  CHECK(collide_in_chunks(none, a, p, rung::certified, 10, never).count == 0);
  struct own {};
  CHECK_THROWS_AS(collide_in_chunks(a, a, p, rung::certified, 10, [](std::span<const index_pair>) { throw own(); }),
                  own);
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace {

// The largest memory of a process of its own, in bytes, that runs work(), which must return true.
template <class Work> std::size_t peak_of(const Work &work) {
  const pid_t child = fork();
  if (child == 0)
    _exit(work() ? 0 : 1);
  int how = 0;
  rusage used{};
  REQUIRE(wait4(child, &how, 0, &used) == child);
  REQUIRE(how == 0);
  return static_cast<std::size_t>(used.ru_maxrss) * 1024;
}

} // namespace

TEST_CASE("chunks of twenty million pairs take a small part of the memory of their list") {
  const predicate_info &p = predicate("box_box");
  const std::vector<float> boxes = nested_boxes(4500);
  constexpr std::uint64_t pairs = 4500 * 4500;
  collide_options o;
  o.threads = 2;
  const auto prepared_boxes = [&] { return prepare(rows(boxes, *p.a), *p.a); };
  const std::size_t nothing = peak_of([&] { return prepared_boxes().elements() == 4500; });
  const std::size_t chunks = peak_of([&] {
    const prepared a = prepared_boxes();
    std::uint64_t sum = 0;
    const auto add = [&](std::span<const index_pair> some) { sum += some.size(); };
    return collide_in_chunks(a, a, p, rung::certified, 1000, add, o).count == pairs && sum == pairs;
  });
  const std::size_t whole = peak_of([&] {
    const prepared a = prepared_boxes();
    return collide(a, a, p, rung::certified, o).pairs.size() == pairs;
  });
  CAPTURE(nothing, chunks, whole);
  CHECK(whole - nothing > pairs * sizeof(index_pair));
  CHECK(chunks - nothing < pairs * sizeof(index_pair) / 20);
}
#endif
