#include "meet/bench/tables/paper/brute_force.hpp"

#include "meet/bench/baselines/baselines.hpp"

#include <algorithm>

namespace meetc::bench {

namespace {

constexpr std::size_t block = 4096;
constexpr std::uint64_t least_rows = 64; // rows of a in a sample, since rows differ in how early they are rejected

// The step with which at most `wanted` of n are taken.
std::size_t stride_to(std::size_t n, std::uint64_t wanted) {
  const std::uint64_t w = std::max<std::uint64_t>(1, wanted);
  return std::max<std::size_t>(1, (n + w - 1) / w);
}

// Calls f(row of a, row of b) for each pair of rows of A and B floats.
template <int A, int B, class Test>
void each(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out, const Test &test) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] =
        test(a.rows + std::size_t{pairs[i].a} * A, b.rows + std::size_t{pairs[i].b} * B) ? answer::yes : answer::no;
}

} // namespace

namespace classic {

const decide_function balls = [](row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  each<4, 4>(a, b, pairs, n, out, [](const float *x, const float *y) { return baselines::balls(x, y); });
};
const decide_function moller = [](row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  each<9, 9>(a, b, pairs, n, out, [](const float *x, const float *y) {
    return baselines::moller(x, y, static_cast<float>(baselines::moller_epsilon));
  });
};
const decide_function moller_0 = [](row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  each<9, 9>(a, b, pairs, n, out, [](const float *x, const float *y) { return baselines::moller(x, y, 0.0F); });
};
const decide_function guigue_devillers = [](row_array a, row_array b, const index_pair *pairs, std::size_t n,
                                            answer *out) {
  each<9, 9>(a, b, pairs, n, out, [](const float *x, const float *y) { return baselines::guigue_devillers(x, y); });
};
const decide_function moller_trumbore = [](row_array a, row_array b, const index_pair *pairs, std::size_t n,
                                           answer *out) {
  each<6, 9>(a, b, pairs, n, out,
             [](const float *x, const float *y) { return baselines::moller_trumbore(x, y, 0.0F); });
};

} // namespace classic

brute_force::side::side(const io::element_set &set, std::size_t stride, const stored_values &of_plain,
                        const stored_values &of_bounded)
    : fields(static_cast<std::size_t>(set.kind->fields)), floats(static_cast<std::size_t>(of_bounded.floats)) {
  rows.resize((set.elements + stride - 1) / stride * fields);
  for (std::size_t i = 0; i < set.elements; i += stride)
    set.row(i, rows.data() + i / stride * fields);
  for (const auto &[values, to] : {std::pair(&of_plain, &plain), std::pair(&of_bounded, &bounded)}) {
    to->resize(count() * floats);
    if (floats > 0 && !values->compute(rows.data(), count(), to->data()))
      to->clear();
  }
}

row_array brute_force::side::from(std::size_t row, bool for_plain) const {
  const std::vector<float> &stored = for_plain ? plain : bounded;
  return {rows.data() + row * fields, stored.empty() ? nullptr : stored.data() + row * floats};
}

brute_force::brute_force(const predicate_info &predicate, const io::element_set &a, const io::element_set &b,
                         std::uint64_t budget)
    : a_(a, stride_to(a.elements, std::max<std::uint64_t>(least_rows, budget / std::max<std::size_t>(1, b.elements))),
         predicate.plain_stored_a, predicate.stored_a),
      b_(b, stride_to(b.elements, budget / std::max<std::size_t>(1, a_.count())), predicate.plain_stored_b,
         predicate.stored_b),
      share_(static_cast<double>(std::max<std::uint64_t>(1, pairs())) /
             (static_cast<double>(a.elements) * static_cast<double>(b.elements))),
      one_with_many_(block) {
  for (std::size_t j = 0; j < block; ++j)
    one_with_many_[j] = {0, static_cast<std::uint32_t>(j)};
}

void brute_force::decide(const pair_test &test, std::size_t i, std::size_t j, std::size_t n, answer *out) const {
  test.decide(a_.from(i, test.plain), b_.from(j, test.plain), one_with_many_.data(), n, out);
}

template <class Take> void brute_force::each_block(const Take &take) const {
  for (std::size_t i = 0; i < a_.count(); ++i)
    for (std::size_t j = 0; j < b_.count(); j += block)
      take(i, j, std::min(block, b_.count() - j));
}

void brute_force::run(const pair_test &test) const {
  std::vector<answer> out(block);
  each_block([&](std::size_t i, std::size_t j, std::size_t n) { decide(test, i, j, n, out.data()); });
}

difference brute_force::compared(const pair_test &test, const pair_test &truth) const {
  std::vector<answer> given(block), right(block);
  difference all;
  each_block([&](std::size_t i, std::size_t j, std::size_t n) {
    decide(test, i, j, n, given.data());
    decide(truth, i, j, n, right.data());
    const difference d = difference_of(std::span<const answer>(given.data(), n), {right.data(), n});
    all.found += d.found, all.extra += d.extra, all.missed += d.missed;
  });
  return all;
}

} // namespace meetc::bench
