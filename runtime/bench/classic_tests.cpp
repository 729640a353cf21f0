#include <meetc/lanes.hpp>

#include "bench/classic_tests.hpp"

#include "bench/baselines.hpp"
#include "bench/moller_lanes.hpp"

MEETC_NAMESPACE(meetc::baselines) {

namespace {

// Test(a, i, b, j) for each row.
template <class Test>
void one_by_one(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from, std::size_t n,
                answer *out, const Test &test) {
  for (std::size_t k = 0; k < n; ++k)
    out[k] = test(a, i, b, from + k) ? answer::yes : answer::no;
}

// Test(a, i, b, j) for each group of lane_count rows. A group at the end may hold rows of which no answer is wanted.
template <class Test>
void by_lanes(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from, std::size_t n, answer *out,
              const Test &test) {
  __builtin_memset(out, static_cast<int>(answer::no), n);
  for (std::size_t k = 0; k < n; k += lane_count)
    for (lane_mask hits = test(a, i, b, from + k); hits != 0; hits &= hits - 1)
      if (const std::size_t at = k + static_cast<std::size_t>(__builtin_ctz(hits)); at < n)
        out[at] = answer::yes;
}
static_assert(sizeof(answer) == 1);

void run_moller(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from, std::size_t n,
                answer *out) {
  one_by_one(a, i, b, from, n, out, [](const classic_rows &x, std::size_t p, const classic_rows &y, std::size_t q) {
    return moller(x.rows + 9 * p, y.rows + 9 * q, 0.0F);
  });
}
void run_moller_stored(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from, std::size_t n,
                       answer *out) {
  one_by_one(a, i, b, from, n, out, moller_stored);
}
void run_moller_lanes(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from, std::size_t n,
                      answer *out) {
  by_lanes(a, i, b, from, n, out, moller_lanes);
}
void run_guigue_devillers(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from, std::size_t n,
                          answer *out) {
  one_by_one(a, i, b, from, n, out, [](const classic_rows &x, std::size_t p, const classic_rows &y, std::size_t q) {
    return guigue_devillers(x.rows + 9 * p, y.rows + 9 * q);
  });
}
void run_balls(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from, std::size_t n,
               answer *out) {
  one_by_one(a, i, b, from, n, out, [](const classic_rows &x, std::size_t p, const classic_rows &y, std::size_t q) {
    return balls(x.rows + 4 * p, y.rows + 4 * q);
  });
}
void run_balls_lanes(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from, std::size_t n,
                     answer *out) {
  by_lanes(a, i, b, from, n, out, [](const classic_rows &x, std::size_t p, const classic_rows &y, std::size_t q) {
    const auto column = [&y, q](std::size_t field) { return lanes::from(y.columns + field * y.stride + q); };
    const float *const row = x.rows + 4 * p;
    const vec<lanes> d{lanes(row[0]) - column(0), lanes(row[1]) - column(1), lanes(row[2]) - column(2)};
    const lanes reach = lanes(row[3]) + column(3);
    const lanes distance = dot(d, d), limit = reach * reach;
    return greater(limit, distance) | (limit == distance);
  });
}

} // namespace

const classic_table &compiled_classic_tests() {
  static constexpr classic_table table{MEETC_COMPILED_FOR,   run_moller, run_moller_stored, run_moller_lanes,
                                       run_guigue_devillers, run_balls,  run_balls_lanes};
  return table;
}

} // MEETC_NAMESPACE(meetc::baselines)

#if !defined(MEETC_INSTRUCTION_SET) // compiled once
namespace meetc::baselines {

#if defined(MEETC_WITH_avx2)
namespace avx2 {
const classic_table &compiled_classic_tests();
}
#endif
#if defined(MEETC_WITH_avx512)
namespace avx512 {
const classic_table &compiled_classic_tests();
}
#endif

const classic_table *classic_tests_for(instruction_set set) {
  if (!runs_here(set))
    return nullptr;
  switch (set) {
  case instruction_set::baseline:
    return &compiled_classic_tests();
#if defined(MEETC_WITH_avx2)
  case instruction_set::avx2:
    return &avx2::compiled_classic_tests();
#endif
#if defined(MEETC_WITH_avx512)
  case instruction_set::avx512:
    return &avx512::compiled_classic_tests();
#endif
  default:
    return nullptr;
  }
}

} // namespace meetc::baselines
#endif
