#include "formula_calls.hpp"

#include "sets.hpp"

#include "meet/core/query/evaluate.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/sets/prepared.hpp"

#include <algorithm>

namespace words_test {

using namespace meetc;

namespace {

const std::vector<index_pair> some_pairs = {{0, 1}, {2, 0}, {2, 2}};

// Spheres whose numbers, and values, are subnormal in part.
rows some_spheres(unsigned seed) {
  const predicate_info &p = find_predicate(cga::catalogue(), "sphere_sphere");
  return some_rows(*p.a, seed);
}

} // namespace

void call_evaluate(caller &under) {
  const rows a = some_spheres(1), b = some_spheres(2);
  const std::size_t n = std::min(a.size(), b.size()) / 4;
  std::vector<column> columns_a(4), columns_b(4);
  columns_of(a.data(), columns_a), columns_of(b.data(), columns_b);
  const operand_columns operands[] = {{columns_a, n}, {columns_b, n}};
  std::vector<std::uint32_t> listed;
  for (std::uint32_t i = 0; i < n; ++i)
    listed.push_back(static_cast<std::uint32_t>(n) - 1 - i), listed.push_back(i);
  for (const char *const name : {"norm2(meet(sphere, sphere))", "meet(sphere, sphere)"}) {
    const formula_info &f = formula_named(cga::catalogue(), name);
    const auto run = [&](auto number) {
      std::vector<decltype(number)> out(2 * n * static_cast<std::size_t>(f.result_count));
      std::vector<decltype(number) *> columns, listed_columns;
      for (std::size_t k = 0; k < static_cast<std::size_t>(f.result_count); ++k)
        columns.push_back(out.data() + 2 * n * k), listed_columns.push_back(columns.back() + n);
      under([&] { evaluate(f, operands, columns, 2); });
      under([&] { evaluate(f, operands, listed, listed_columns, 2); });
      under.add_all(out);
    };
    run(0.0F), run(0.0);
    under([&] { evaluate(f, std::span(operands).first(1), std::span<float *const>{}); });
    const predicate_info &p = find_predicate(cga::catalogue(), "sphere_sphere");
    const prepared set_a = prepare(view_of(a, *p.a), *p.a), set_b = prepare(view_of(b, *p.b), *p.b);
    formula_values<float> values;
    under([&] { values = evaluate<float>(f, set_a, set_b, some_pairs); });
    under.add_all(values.numbers);
    formula_values<double> wide;
    under([&] { wide = evaluate<double>(f, set_a, set_b, some_pairs); });
    under.add_all(wide.numbers);
  }
}
void call_columns_of(caller &under) {
  const rows a = some_spheres(1);
  std::vector<column> columns(4);
  under([&] { columns_of(a.data(), columns); });
  under.add(columns[3].data - a.data()), under.add(columns[3].stride);
}
void call_common_objects(caller &under) {
  const rows a = some_spheres(1);
  std::vector<column> columns(4);
  columns_of(a.data(), columns);
  const operand_columns operands[] = {{columns, a.size() / 4}, {columns, a.size() / 4}};
  const formula_info &f = formula_named(cga::catalogue(), "meet(sphere, sphere)");
  std::size_t objects = 0, numbers = 0;
  under([&] { objects = common_objects(f, operands), numbers = columns_of(f, operands).size(); });
  under.add(objects), under.add(numbers);
  const operand_columns others[] = {{columns, 1}, {columns, 2}};
  under([&] { common_objects(f, others); });
}
void call_require_rows(caller &under) {
  const rows a = some_spheres(1);
  std::vector<column> columns(4);
  columns_of(a.data(), columns);
  const operand_columns operands[] = {{columns, 2}, {columns, 2}};
  const formula_info &f = formula_named(cga::catalogue(), "meet(sphere, sphere)");
  static constexpr std::uint32_t good[] = {0, 1, 1, 1}, bad[] = {0, 1, 1, 2};
  under([&] { require_rows(f, operands, good); });
  under([&] { require_rows(f, operands, bad); });
}
void call_formula_named(caller &under) {
  const formula_info *found = nullptr;
  under([&] { found = &formula_named(cga::catalogue(), "meet( sphere,sphere )"); });
  under.answer += found->name;
  under([&] { formula_named(cga::catalogue(), "nothing"); });
}
void call_find_formula(caller &under) {
  const formula_info *found = nullptr;
  under([&] { found = find_formula(cga::catalogue(), "meet(sphere,sphere)"); });
  under.answer += found->name;
}
void call_column(caller &under) {
  const formula_values<float> values{2, {1, 2, 3, 4}};
  std::span<const float> second;
  under([&] { second = values.column(1); });
  under.add_all(second.data(), second.size());
}

} // namespace words_test
