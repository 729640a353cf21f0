// The one file with threads, and the guard of the floating-point control word.
#include "tests/catch.hpp"
#include "toy.hpp"

#include "meet/core/threads/threads.hpp"

#include <set>
#include <thread>
#if defined(__SSE2__)
#include <pmmintrin.h>
#endif

using namespace meetc;
using namespace toy;

TEST_CASE("every index is handed out once") {
  for (const std::size_t n : {0u, 1u, 7u, 1000u, 4097u})
    for (const int threads : {1, 2, 8}) {
      std::vector<std::atomic<int>> seen(n);
      for_chunks(threads, n, 16, [&](int, std::size_t begin, std::size_t end) {
        for (; begin < end; ++begin)
          ++seen[begin];
      });
      CHECK(std::all_of(seen.begin(), seen.end(), [](const auto &s) { return s == 1; }));
    }
}

TEST_CASE("one thread runs inline") {
  const auto here = std::this_thread::get_id();
  bool same_thread = true;
  for_chunks(1, 100, 1, [&](int worker, std::size_t, std::size_t) {
    same_thread &= worker == 0 && std::this_thread::get_id() == here;
  });
  CHECK(same_thread);
}

TEST_CASE("an exception reaches the caller, and the others stop") {
  for (const int threads : {1, 2, 8}) {
    std::atomic<int> done{0};
    CHECK_THROWS_AS(for_chunks(threads, 1'000'000, 1,
                               [&](int, std::size_t begin, std::size_t) {
                                 if (begin == 10)
                                   throw std::bad_alloc();
                                 ++done;
                               }),
                    std::bad_alloc);
    CHECK(done < 1'000'000);
  }
}

namespace {
bool slow_hit(const float *a, const float *b) {
  return boxes_hit(a, b);
}
void slow(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  decide<6, 6, slow_hit>(a, b, pairs, n, out);
}
constexpr predicate_info slow_boxes = plain("slow", "", boxes, boxes, slow);
} // namespace

TEST_CASE("progress rises, modestly, on the calling thread") {
  const prepared x = prepare(view_of(some_boxes(1000, 0, 1, 40), boxes), boxes);
  std::vector<double> seen;
  std::set<std::thread::id> callers;
  collide_options o;
  o.threads = 1;
  o.progress = [&](double fraction) {
    seen.push_back(fraction);
    callers.insert(std::this_thread::get_id());
  };
  const result r = collide(x, x, slow_boxes, rung::fp32, o);
  CHECK(r.count == 1'000'000);
  CHECK(!seen.empty());
  CHECK(static_cast<double>(seen.size()) <= r.seconds * 10 + 1);
  CHECK(std::is_sorted(seen.begin(), seen.end()));
  CHECK((seen.front() > 0 && seen.back() <= 1));
  CHECK(callers == std::set<std::thread::id>{std::this_thread::get_id()});

  o.threads = 2;
  o.progress = [](double) { throw std::runtime_error("stop"); };
  CHECK_THROWS_AS(collide(x, x, slow_boxes, rung::fp32, o), std::runtime_error);
}

#if defined(__SSE2__)
TEST_CASE("flush-to-zero, as another library may set it, changes no answer and is put back") {
  rows a = {1e-40f, 0, 0, 2e-40f, 1, 1, 4e-40f, 0, 0, 5e-40f, 1, 1};
  pose half;
  half.m[0] = 0.5;
  const unsigned before = _mm_getcsr();
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  const unsigned flushing = _mm_getcsr();
  const prepared x = prepare(view_of(a, boxes), boxes, half, 2);
  const result r = collide(x, x, box_box_hit, rung::fp32, {.threads = 2});
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  constexpr unsigned raised = _MM_EXCEPT_MASK; // flags that stay up after any inexact result; they change nothing
  CHECK((after & ~raised) == (flushing & ~raised));
  CHECK(r.count == 2);
  float lo[3], hi[3];
  x.bounds(lo, hi);
  CHECK(lo[0] == 1e-40f / 2);
}
#endif
