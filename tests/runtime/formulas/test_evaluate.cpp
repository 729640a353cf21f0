// Every formula of the shipped scene on columns, on listed rows and on the pairs of a query, for every instruction set that
// runs here, against the emitted function on one row.
#include "tests/catch.hpp"
#include "tests/runtime/formulas/fused.hpp"

#include "meet/core/query/collide.hpp"
#include "meet/core/query/evaluate.hpp"

#include <cga/cga_runtime.hpp>
#include <cga/for_each.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace meetc;

namespace {

// n objects of every operand of a formula, in three layouts: columns, packed rows, and columns without a neighbour.
struct objects {
  objects(const formula_info &f, std::size_t count, bool whole, unsigned seed) : n(count) {
    std::mt19937 random(seed);
    for (int k = 0; k < f.operand_count; ++k)
      for (int i = 0; i < f.operands[k].number_count; ++i) {
        numbers.emplace_back(n);
        for (float &x : numbers.back())
          x = whole ? static_cast<float>(static_cast<int>(random() % 7) - 3)
                    : std::ldexp(static_cast<float>(random() % 16777216) - 8388608.0F,
                                 static_cast<int>(random() % 5) - 23);
      }
    std::size_t first = 0;
    for (int k = 0; k < f.operand_count; ++k) {
      const auto fields = static_cast<std::size_t>(f.operands[k].number_count);
      rows.emplace_back(n * fields);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < fields; ++j)
          rows.back()[i * fields + j] = numbers[first + j][i];
      packed.emplace_back();
      for (std::size_t j = 0; j < fields; ++j)
        packed.back().push_back({numbers[first + j].data(), 1});
      strided.emplace_back(fields);
      columns_of(rows.back().data(), strided.back());
      first += fields;
    }
  }
  std::vector<operand_columns> operands(const std::vector<std::vector<column>> &of) const {
    std::vector<operand_columns> out;
    for (const auto &columns : of)
      out.push_back({columns, n});
    return out;
  }
  std::size_t n;
  std::vector<std::vector<float>> numbers, rows;
  std::vector<std::vector<column>> packed, strided;
};

// Columns with a guard behind each, which must stay.
template <class Number> struct room {
  room(const formula_info &f, std::size_t n)
      : all(static_cast<std::size_t>(f.result_count), std::vector<Number>(n + 1, guard)) {
    for (auto &column : all)
      to.push_back(column.data());
  }
  bool kept() const {
    return std::all_of(all.begin(), all.end(), [](const auto &column) { return column.back() == guard; });
  }
  static constexpr Number guard = 123456;
  std::vector<std::vector<Number>> all;
  std::vector<Number *> to;
};

template <class Number>
bool same_bits(const std::vector<std::vector<Number>> &x, const std::vector<std::vector<Number>> &y) {
  using bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t i = 0; i < x[k].size(); ++i)
      if (std::bit_cast<bits>(x[k][i]) != std::bit_cast<bits>(y[k][i]))
        return false;
  return x.size() == y.size();
}

// The emitted function on row i of the operands, as the instruction set computes it.
template <class F, class T, class Number>
void one_row(const objects &of, const std::vector<std::size_t> &which, std::size_t i,
             std::vector<std::vector<Number>> &out) {
  T in[F::numbers], values[F::results];
  for (int k = 0; k < F::numbers; ++k)
    in[k] = T(of.numbers[static_cast<std::size_t>(k)][which[static_cast<std::size_t>(F::operand_of(k))]]);
  F::values(in, values);
  for (int k = 0; k < F::results; ++k) {
    if constexpr (std::is_same_v<T, Number>)
      out[static_cast<std::size_t>(k)][i] = values[k];
    else
      out[static_cast<std::size_t>(k)][i] = values[k].v;
  }
}

template <class F, class Number>
void check_formula(const formula_info &f, bool fuses, std::size_t n, bool whole, unsigned seed) {
  CAPTURE(f.name, n, whole, fuses, sizeof(Number));
  REQUIRE(f.operand_count == F::operands);
  REQUIRE(f.number_count == F::numbers);
  REQUIRE(f.result_count == F::results);
  const objects of(f, n, whole, seed);
  room<Number> want(f, n);
  const auto fill = [&](const std::vector<std::size_t> &which, std::size_t i) {
    // The values of whole numbers are exact, and so are those that round.
    if (fuses && !whole)
      one_row<F, fused<Number>, Number>(of, which, i, want.all);
    else
      one_row<F, Number, Number>(of, which, i, want.all);
  };
  for (std::size_t i = 0; i < n; ++i)
    fill(std::vector<std::size_t>(F::operands, i), i);
  for (const int threads : {1, 2})
    for (const auto *layout : {&of.packed, &of.strided}) {
      room<Number> have(f, n);
      evaluate(f, of.operands(*layout), have.to, threads);
      REQUIRE(have.kept());
      REQUIRE(same_bits(have.all, want.all));
    }
  // Listed rows, in any order and repeated.
  std::mt19937 random(seed + 1);
  const std::size_t listed = n ? n + 3 : 0;
  std::vector<std::uint32_t> rows;
  want = room<Number>(f, listed);
  for (std::size_t i = 0; i < listed; ++i) {
    std::vector<std::size_t> which;
    for (int k = 0; k < F::operands; ++k) {
      rows.push_back(static_cast<std::uint32_t>(random() % n));
      which.push_back(rows.back());
    }
    fill(which, i);
  }
  for (const auto *layout : {&of.packed, &of.strided}) {
    room<Number> have(f, listed);
    evaluate(f, of.operands(*layout), rows, have.to, 2);
    REQUIRE(have.kept());
    REQUIRE(same_bits(have.all, want.all));
  }
}

std::vector<const catalogue *> catalogues() {
  std::vector<const catalogue *> out;
  for (int i = 0; i < instruction_set_count; ++i)
    if (const catalogue *c = cga::catalogue_for(static_cast<instruction_set>(i)))
      out.push_back(c);
  return out;
}

// Whether lanes of this catalogue fuse. The baseline does where the program does.
bool fuses(const catalogue &c) {
#if defined(__FMA__) || defined(__aarch64__)
  return true;
#else
  return c.compiled_for != instruction_set::baseline;
#endif
}

} // namespace

TEST_CASE("every formula on columns and on rows is the emitted function, bit for bit") {
  int formulas = 0;
  for (const catalogue *c : catalogues())
    cga::for_each_formula([&]<class F>(const cga::detail::on_columns<F> &listed) {
      const formula_info &f = formula_named(*c, listed.name);
      for (const std::size_t n : {0, 1, 3, 4, 8, 15, 16, 33, 5000})
        for (const bool whole : {true, false}) {
          check_formula<F, float>(f, fuses(*c), n, whole, static_cast<unsigned>(n));
          check_formula<F, double>(f, fuses(*c), n, whole, static_cast<unsigned>(n));
        }
      ++formulas;
    });
  REQUIRE(formulas == static_cast<int>(catalogues().size()) * cga::catalogue().formula_count);
  REQUIRE(cga::catalogue().formula_count > 20);
}

TEST_CASE("a column of stride 0 is one object for all") {
  const formula_info &f = formula_named(cga::catalogue(), "norm2(meet(sphere,plane))");
  std::vector<float> x(100), zero(100, 0.0F), r(100, 2.0F);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = static_cast<float>(i) / 16;
  const float plane[] = {1, 0, 0, 3}; // x = 3
  const std::vector<column> spheres{{x.data()}, {zero.data()}, {zero.data()}, {r.data()}};
  const std::vector<column> planes{{plane, 0}, {plane + 1, 0}, {plane + 2, 0}, {plane + 3, 0}};
  std::vector<float> out(x.size());
  float *const to[] = {out.data()};
  const operand_columns operands[] = {{spheres, x.size()}, {planes, x.size()}};
  evaluate(f, operands, to);
  // The sphere meets the plane where its centre is within its radius of it; the circle's B² is then positive.
  for (std::size_t i = 0; i < x.size(); ++i) {
    const float distance = x[i] - 3, power = distance * distance - 4;
    CAPTURE(i, out[i], power);
    REQUIRE((out[i] > 0) == (power < 0));
    REQUIRE((out[i] == 0) == (power == 0));
  }
}

TEST_CASE("values of the pairs that a query finds") {
  std::mt19937 random(7);
  std::vector<float> rows(4 * 300);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = static_cast<float>(random() % 1024) / (i % 4 == 3 ? 4096 : 1024);
  const catalogue &c = cga::catalogue();
  const predicate_info *touch = nullptr;
  for (int i = 0; i < c.predicate_count; ++i)
    if (std::string(c.predicates[i].name) == "sphere_sphere")
      touch = &c.predicates[i];
  REQUIRE(touch);
  view v;
  v.data = rows.data(), v.elements = 300;
  const prepared set = prepare(v, *touch->a);
  const result found = collide(set, set, *touch, rung::certified);
  REQUIRE(found.pairs.size() > 300);
  const formula_info &f = formula_named(c, "norm2(meet(sphere, sphere))");
  const formula_values<float> values = evaluate<float>(f, set, set, found.pairs);
  const formula_values<double> wide = evaluate<double>(f, set, set, found.pairs, 1);
  REQUIRE(values.column(0).size() == found.pairs.size());
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    const float *const x = &rows[4 * found.pairs[i].a], *const y = &rows[4 * found.pairs[i].b];
    double one[1];
    double in[8];
    std::copy(x, x + 4, in);
    std::copy(y, y + 4, in + 4);
    cga::detail::columns::norm2_meet_sphere_sphere::values(in, one);
    REQUIRE(wide.column(0)[i] == one[0]); // exact: products of few bits
    REQUIRE(std::abs(values.column(0)[i] - one[0]) <= 1e-5);
  }
  const index_pair beyond[] = {{0, 300}};
  REQUIRE_THROWS_WITH(evaluate<float>(f, set, set, beyond), Catch::Contains("element 300 of b is not in the set"));
  REQUIRE_THROWS_WITH(evaluate<float>(formula_named(c, "norm2(meet(sphere, plane))"), set, set, found.pairs),
                      Catch::Contains("does not take a sphere and a sphere"));
}

TEST_CASE("operands that do not fit are refused") {
  const catalogue &c = cga::catalogue();
  REQUIRE_THROWS_WITH(formula_named(c, "norm2(meet(sphere, cube))"),
                      Catch::Contains("no formula 'norm2(meet(sphere, cube))'") &&
                          Catch::Contains("norm2(meet(sphere, sphere))"));
  const formula_info &f = formula_named(c, "norm2(meet(sphere, sphere))");
  const objects of(f, 10, true, 1);
  std::vector<operand_columns> operands = of.operands(of.packed);
  room<float> out(f, 10);
  REQUIRE_THROWS_WITH(evaluate(f, std::span(operands).first(1), out.to), Catch::Contains("takes 2 operands, not 1"));
  REQUIRE_THROWS_WITH(evaluate(f, operands, std::span(out.to).first(0)), Catch::Contains("has 1 values"));
  operands[1].objects = 9;
  REQUIRE_THROWS_WITH(evaluate(f, operands, out.to), Catch::Contains("10 and 9 objects"));
  const std::vector<std::uint32_t> rows{0, 0, 9, 9, 1, 0};
  REQUIRE_THROWS_WITH(evaluate(f, operands, rows, out.to),
                      Catch::Contains("value 1 takes object 9 of operand 1, which has 9"));
  REQUIRE_THROWS_WITH(evaluate(f, operands, std::span(rows).first(3), out.to), Catch::Contains("no multiple"));
  operands[1].numbers = operands[1].numbers.first(3);
  REQUIRE_THROWS_WITH(evaluate(f, operands, out.to), Catch::Contains("has the columns x,y,z,r; here are 3"));
  REQUIRE(std::all_of(out.all[0].begin(), out.all[0].end(), [](float x) { return x == room<float>::guard; }));
}
