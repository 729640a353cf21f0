#include "tests/gen/fuzz/judge.hpp"

#include "tests/gen/fuzz/evaluate.hpp"
#include "tests/gen/oracle/random.hpp"

#include <fmt/format.h>

namespace meetc::fuzz {
namespace {

std::string text_of(const std::vector<rational> &numbers) {
  std::string out;
  for (const rational &q : numbers)
    out += (out.empty() ? "" : ", ") + q.get_str();
  return out;
}

std::vector<rational> drawn(oracle_test::random_numbers &random, std::size_t n) {
  std::vector<rational> out;
  for (std::size_t i = 0; i < n; ++i)
    out.push_back(random.fraction(9));
  return out;
}

rational value_at(const poly::poly &p, const std::map<std::string, rational> &at,
                  const std::vector<std::string> &names) {
  rational sum = 0;
  for (const poly::term &t : p.terms()) {
    rational product = t.coefficient;
    for (const poly::power &f : t.factors)
      for (int i = 0; i < f.exponent; ++i)
        product *= at.at(names[static_cast<std::size_t>(f.variable)]);
    sum += product;
  }
  return sum;
}

} // namespace

multivector judge::value(const std::vector<multivector> &operands) const {
  dense d(*c_.from.in);
  std::vector<multivector> arguments;
  for (const expression_ptr &a : c_.from.arguments)
    arguments.push_back(evaluate(d, *a, operands));
  return evaluate(d, *c_.from.body, arguments);
}

multivector judge::on_blades(const std::vector<rational> &numbers) const {
  const space &s = *c_.from.in;
  std::vector<multivector> operands;
  std::size_t at = 0;
  for (const lang::kind *k : c_.kernel.asked.kinds) {
    operands.push_back(s.algebra().zero());
    for (const lower::basis_blade &b : lower::named(model_.working(), lower::support(model_, *k)))
      operands.back() = oracle::add(operands.back(), oracle::scale(numbers.at(at++), s.blade(b.vectors)));
  }
  return s.in_working(value(operands));
}

std::vector<multivector> judge::stored_operands(const std::vector<rational> &numbers) const {
  std::vector<multivector> out;
  auto at = numbers.begin();
  for (const std::string &name : c_.from.kinds) {
    const kind &k = c_.from.in->find(name);
    const auto end = at + static_cast<std::ptrdiff_t>(k.stored);
    out.push_back(k.blade(*c_.from.in, {at, end}));
    at = end;
  }
  return out;
}

multivector judge::on_stored(const std::vector<rational> &numbers) const {
  return c_.from.in->in_working(value(stored_operands(numbers)));
}

std::size_t judge::stored_numbers() const {
  std::size_t n = 0;
  for (const std::string &name : c_.from.kinds)
    n += c_.from.in->find(name).stored;
  return n;
}

std::string judge::programs(std::uint64_t seed, const lower::declared_formula *declared) const {
  oracle_test::random_numbers random(seed);
  const lower::formula &f = c_.kernel.value;
  const auto wrong = [&](const multivector &want, const std::vector<lower::blade> &blades,
                         const std::vector<rational> &have, const char *what,
                         const std::vector<rational> &at) -> std::string {
    multivector got(want.size());
    for (std::size_t i = 0; i < blades.size() && i < have.size(); ++i)
      got[blades[i]] = have[i];
    return got == want && blades.size() == have.size() ? "" : fmt::format("{} differs at ({})", what, text_of(at));
  };
  for (int round = 0; round < 2; ++round) {
    std::vector<rational> at = drawn(random, blade_numbers());
    if (auto what = wrong(on_blades(at), f.result, ir::evaluate(f.from_blades, at), "the program on blades", at);
        !what.empty())
      return what;
    if (!f.prepared.results.empty())
      if (auto what = wrong(on_blades(at), f.result, ir::evaluate(f.prepared, at), "the prepared program", at);
          !what.empty())
        return what;
    at = drawn(random, stored_numbers());
    const multivector want = on_stored(at);
    if (f.is_number())
      if (auto what = wrong(want, {0}, ir::evaluate(f.from_stored, at), "the program on stored numbers", at);
          !what.empty())
        return what;
    if (!f.for_pairs.results.empty())
      if (auto what = wrong(want, {0}, ir::evaluate(f.for_pairs, at), "the program for pairs", at); !what.empty())
        return what;
    if (!declared)
      continue;
    std::map<std::string, rational> coefficients;
    const std::vector<multivector> operands = stored_operands(at);
    for (std::size_t i = 0; i < operands.size(); ++i)
      for (std::size_t b = 0; b < operands[i].size(); ++b)
        coefficients[c_.kernel.asked.names[i] + '.' + model_.declared().name(static_cast<lower::blade>(b))] =
            operands[i][b];
    multivector have = c_.from.in->algebra().zero();
    for (std::size_t i = 0; i < declared->blades.size(); ++i)
      have = oracle::add(have, oracle::scale(value_at(declared->values[i], coefficients, declared->numbers->names()),
                                             c_.from.in->blade(declared->blades[i].vectors)));
    const multivector value_there = value(operands);
    if (have != value_there)
      return fmt::format("the form in the declared basis differs at ({})", text_of(at));
    if (value_at(declared->norm2, coefficients, declared->numbers->names()) !=
        oracle::scalar_part(c_.from.in->algebra().geometric(value_there, value_there)))
      return fmt::format("norm2 of the form in the declared basis differs at ({})", text_of(at));
  }
  return "";
}

} // namespace meetc::fuzz
