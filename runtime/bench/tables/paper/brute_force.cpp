#include "bench/tables/paper/brute_force.hpp"

#include "bench/baselines/baselines.hpp"

#include <algorithm>
#include <functional>

namespace meetc::bench {

namespace {

constexpr std::size_t block = 4096;
constexpr std::uint64_t least_rows = 64; // rows of a in a sample, since rows differ in how early they are rejected

// The step with which at most `wanted` of n are taken.
std::size_t stride_to(std::size_t n, std::uint64_t wanted) {
  const std::uint64_t w = std::max<std::uint64_t>(1, wanted);
  return std::max<std::size_t>(1, (n + w - 1) / w);
}

std::vector<float> rows_of(const io::element_set &set, std::size_t stride) {
  const auto fields = static_cast<std::size_t>(set.kind->fields);
  std::vector<float> rows((set.elements + stride - 1) / stride * fields);
  for (std::size_t i = 0; i < set.elements; i += stride)
    set.row(i, rows.data() + i / stride * fields);
  return rows;
}

// Rows with what a predicate wants stored beside them: for its plain rung, and for the others.
struct rows_with_stored {
  std::vector<float> rows, plain, bounded;
  std::size_t fields, floats;

  rows_with_stored(std::vector<float> all, int fields_of_kind, const stored_values &of_plain,
                   const stored_values &of_bounded)
      : rows(std::move(all)), fields(static_cast<std::size_t>(fields_of_kind)),
        floats(static_cast<std::size_t>(of_bounded.floats)) {
    for (const auto &[values, to] : {std::pair(&of_plain, &plain), std::pair(&of_bounded, &bounded)}) {
      to->resize(count() * floats);
      if (floats > 0 && !values->compute(rows.data(), count(), to->data()))
        to->clear();
    }
  }
  std::size_t count() const { return rows.size() / fields; }
  row_array from(std::size_t row, bool for_plain) const {
    const std::vector<float> &stored = for_plain ? plain : bounded;
    return {rows.data() + row * fields, stored.empty() ? nullptr : stored.data() + row * floats};
  }
};

// One row of a against all rows of b.
struct sweep {
  rows_with_stored a, b;
  std::vector<index_pair> pairs; // (0, j)
  decide_function plain;

  template <class Take> void run(decide_function test, std::vector<answer> &out, const Take &take) const {
    for (std::size_t i = 0; i < a.count(); ++i)
      for (std::size_t j = 0; j < b.count(); j += block) {
        const std::size_t n = std::min(block, b.count() - j);
        test(a.from(i, test == plain), b.from(j, test == plain), pairs.data(), n, out.data());
        take(i, j, n);
      }
  }
};

template <int A, int B, class Test>
void each(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out, const Test &test) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] = test(a + std::size_t{pairs[i].a} * A, b + std::size_t{pairs[i].b} * B) ? answer::yes : answer::no;
}

} // namespace

namespace classic {

const decide_function balls = [](row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  each<4, 4>(a.rows, b.rows, pairs, n, out, [](const float *x, const float *y) { return baselines::balls(x, y); });
};
const decide_function moller = [](row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  each<9, 9>(a.rows, b.rows, pairs, n, out, [](const float *x, const float *y) {
    return baselines::moller(x, y, static_cast<float>(baselines::moller_epsilon));
  });
};
const decide_function moller_0 = [](row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  each<9, 9>(a.rows, b.rows, pairs, n, out,
             [](const float *x, const float *y) { return baselines::moller(x, y, 0.0F); });
};
const decide_function guigue_devillers = [](row_array a, row_array b, const index_pair *pairs, std::size_t n,
                                            answer *out) {
  each<9, 9>(a.rows, b.rows, pairs, n, out,
             [](const float *x, const float *y) { return baselines::guigue_devillers(x, y); });
};
const decide_function moller_trumbore = [](row_array a, row_array b, const index_pair *pairs, std::size_t n,
                                           answer *out) {
  each<6, 9>(a.rows, b.rows, pairs, n, out,
             [](const float *x, const float *y) { return baselines::moller_trumbore(x, y, 0.0F); });
};

} // namespace classic

brute_force_times time_brute_force(yardstick &by, std::span<const decide_function> tests,
                                   const predicate_info &predicate, const io::element_set &a, const io::element_set &b,
                                   std::uint64_t budget, int runs) {
  const std::size_t stride_a =
      stride_to(a.elements, std::max<std::uint64_t>(least_rows, budget / std::max<std::size_t>(1, b.elements)));
  const std::size_t taken = (a.elements + stride_a - 1) / stride_a;
  const std::size_t stride_b = stride_to(b.elements, budget / std::max<std::size_t>(1, taken));
  const decide_function plain = predicate.decide[static_cast<int>(rung::fp32)];
  sweep s{{rows_of(a, stride_a), a.kind->fields, predicate.plain_stored_a, predicate.stored_a},
          {rows_of(b, stride_b), b.kind->fields, predicate.plain_stored_b, predicate.stored_b},
          std::vector<index_pair>(block),
          plain};
  for (std::size_t j = 0; j < block; ++j)
    s.pairs[j] = {0, static_cast<std::uint32_t>(j)};

  brute_force_times times;
  times.pairs = taken * s.b.count();
  times.sample = stride_a > 1 || stride_b > 1;
  times.of.resize(tests.size());
  std::vector<answer> first(block), out(block);
  for (std::size_t t = 0; t < tests.size(); ++t)
    s.run(tests[t], out, [&](std::size_t i, std::size_t j, std::size_t n) {
      tests[0](s.a.from(i, tests[0] == plain), s.b.from(j, tests[0] == plain), s.pairs.data(), n, first.data());
      for (std::size_t k = 0; k < n; ++k) {
        times.of[t].yes += out[k] == answer::yes;
        times.of[t].wrong_yes += out[k] == answer::yes && first[k] != answer::yes;
        times.of[t].wrong_no += out[k] != answer::yes && first[k] == answer::yes;
      }
    });
  std::vector<std::function<void()>> works;
  for (const decide_function test : tests)
    works.emplace_back([&s, &out, test] { s.run(test, out, [](std::size_t, std::size_t, std::size_t) {}); });
  const std::vector<double> measured = by.measure(works, runs);
  const double share = static_cast<double>(std::max<std::uint64_t>(1, times.pairs)) /
                       (static_cast<double>(a.elements) * static_cast<double>(b.elements));
  for (std::size_t t = 0; t < tests.size(); ++t)
    times.of[t].time = measured[t] / share;
  return times;
}

} // namespace meetc::bench
