// Formulas on a device: column by column, with one object for all, and on listed rows, against the CPU's, bit for bit where
// that fuses.
#include "engine.hpp"

#include "meet/core/device/evaluate.hpp"

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace cuda_test {
namespace {

using namespace meetc;

template <class Number>
void of_formula(comparison &with, const formula_info &f, std::size_t n, int layout, engine &random) {
  std::vector<std::vector<float>> numbers;
  std::vector<column> columns;
  for (int k = 0; k < f.number_count; ++k) {
    const bool one = layout == 1 && k < f.operands[0].number_count;
    const std::ptrdiff_t stride = one ? 0 : layout == 2 ? 3 : 1;
    numbers.emplace_back(one ? 1 : n * 3);
    for (float &x : numbers.back())
      x = std::ldexp(static_cast<float>(random() % 16777216) - 8388608.0F, static_cast<int>(random() % 5) - 23);
    columns.push_back({numbers.back().data(), stride});
  }
  std::vector<operand_columns> operands;
  for (int k = 0, first = 0; k < f.operand_count; first += f.operands[k++].number_count)
    operands.push_back({std::span(columns).subspan(static_cast<std::size_t>(first),
                                                   static_cast<std::size_t>(f.operands[k].number_count)),
                        n});
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; n && i < (n + 5) * operands.size(); ++i)
    rows.push_back(static_cast<std::uint32_t>(random() % n));
  const auto compare = [&](const formula_values<Number> &there, std::size_t count, const char *what, const auto &here) {
    std::vector<Number> want(count * static_cast<std::size_t>(f.result_count));
    std::vector<Number *> out;
    for (std::size_t k = 0; k < static_cast<std::size_t>(f.result_count); ++k)
      out.push_back(want.data() + k * count);
    here(out);
    with.require(
        "formulas",
        there.numbers.size() == want.size() &&
            (want.empty() || std::memcmp(there.numbers.data(), want.data(), want.size() * sizeof(Number)) == 0),
        std::string(f.name) + " " + what);
  };
  compare(evaluate<Number>(with.on(), f, operands), n, "by columns",
          [&](const std::vector<Number *> &out) { evaluate(f, operands, out); });
  compare(evaluate<Number>(with.on(), f, operands, rows), rows.size() / operands.size(), "on rows",
          [&](const std::vector<Number *> &out) { evaluate(f, operands, rows, out); });
}

template <class Call> bool is_refused(Call call) {
  try {
    call();
  } catch (const std::invalid_argument &) {
    return true;
  } catch (const std::out_of_range &) {
    return true;
  }
  return false;
}

// The pairs that a query finds and leaves on the device, in sets that were prepared, made there or moved, and with themselves.
template <class Number> void of_found_pairs(comparison &with, const catalogue &c, bool small, engine &random) {
  const formula_info &f = formula_named(c, "norm2(meet(sphere, sphere))"),
                     &value = formula_named(c, "meet(sphere, sphere)");
  const predicate_info &touch = predicate_named("ball_ball");
  const std::size_t n = small ? 300 : 30000;
  const rows_of rows_a = random_rows(*touch.a, n, {1, 0.1, 1, 0}, random),
                rows_b = random_rows(*touch.b, n / 2, {1, 0.1, 1, 0}, random);
  pose at;
  at.m[3] = 0.0625;
  const prepared here_a = prepare(view_of(rows_a), *touch.a, at), here_b = prepare(view_of(rows_b), *touch.b);
  device_set a(with.on(), view_of(rows_a), *touch.a), b(with.on(), here_b);
  a.move(at);
  for (const bool itself : {false, true}) {
    device_set &other = itself ? a : b;
    pairs_there found;
    device_options asked;
    asked.leave_there = &found;
    collide(with.on(), a, other, touch, rung::certified, asked);
    const std::vector<index_pair> pairs = collide(here_a, itself ? here_a : here_b, touch, rung::certified).pairs;
    with.require("formulas", found.size() == pairs.size() && !pairs.empty(), "found pairs");
    for (const formula_info *of : {&f, &value}) {
      const values_there<Number> there = evaluate<Number>(with.on(), *of, a, other, found.data(), found.size());
      const formula_values<Number> want = evaluate<Number>(*of, here_a, itself ? here_a : here_b, pairs);
      const formula_values<Number> got = there.download();
      with.require("formulas",
                   got.numbers.size() == want.numbers.size() &&
                       std::memcmp(got.numbers.data(), want.numbers.data(), want.numbers.size() * sizeof(Number)) == 0,
                   std::string(of->name) + " of found pairs");
    }
    if (itself)
      continue;
    with.require("formulas", evaluate<Number>(with.on(), f, a, b, nullptr, 0).download().numbers.empty(), "no pairs");
    const index_pair beyond{static_cast<std::uint32_t>(n), 0};
    device_memory<index_pair> wrong;
    check(cudaMemcpy(wrong.reserve(1, "a pair"), &beyond, sizeof beyond, cudaMemcpyHostToDevice), "a pair");
    with.require("formulas", is_refused([&] { evaluate<Number>(with.on(), f, a, b, wrong.data(), 1); }),
                 "an element that is not there");
    device_set given = device_set::given(with.on(), view_of(rows_b), *touch.b);
    with.require("formulas", is_refused([&] { evaluate<Number>(with.on(), f, a, given, found.data(), found.size()); }),
                 "a given set");
    const formula_info &line = formula_named(c, "norm2(meet(sphere, line))");
    with.require("formulas", is_refused([&] { evaluate<Number>(with.on(), line, a, b, found.data(), found.size()); }),
                 "another kind");
  }
}

} // namespace

void formula_scenes(comparison &with, const settings &s) {
  const catalogue *const c = fusing();
  if (!c) {
    std::puts("formulas: not compared, since no code of this processor fuses");
    return;
  }
  engine random(s.seed);
  for (int i = 0; i < c->formula_count; ++i)
    for (const std::size_t n : {0, 1, 255, 257, s.small ? 600 : 300000})
      for (const int layout : {0, 1, 2}) {
        of_formula<float>(with, c->formulas[i], n, layout, random);
        of_formula<double>(with, c->formulas[i], n, layout, random);
      }
  with.require("formulas", c->formula_count > 20, "hardly any");
  of_found_pairs<float>(with, *c, s.small, random);
  of_found_pairs<double>(with, *c, s.small, random);
}

} // namespace cuda_test
