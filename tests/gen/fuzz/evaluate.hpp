// The meaning of the fuzzer's expressions in any domain of multivectors: numbers of the oracle, or sizes of expansions.
//
//   struct domain {
//     using value = ...;
//     value number(const rational &q); value blade(const std::vector<std::string> &vectors);
//     value add(a, b); value subtract(a, b); value scale(q, a);
//     value geometric(a, b); value outer(a, b); value inner(a, b);   // inner: the left contraction
//     value reverse(a); value involute(a); value grade_part(a, k); value scalar_part(a); value coefficient(a, along);
//     value complement(a, right); value dual(a, back); value dot(a, b); value inverse(a); value versor(v, x);
//     value meet(a, b);
//   };
#ifndef MEETC_TESTS_FUZZ_EVALUATE_HPP
#define MEETC_TESTS_FUZZ_EVALUATE_HPP

#include "tests/gen/fuzz/expression.hpp"
#include "tests/gen/fuzz/space.hpp"

#include <array>
#include <stdexcept>

namespace meetc::fuzz {

struct function {
  const char *name;
  int arguments;
};
// The functions of functions.toml, meet, and the operators of the language but for grade and inverse, whose arguments are
// special. Those that make formulas long come first, and are drawn more often.
inline constexpr std::array functions{
    function{"gp", 2},      function{"sandwich", 2},   function{"between", 3}, function{"twice", 2},
    function{"project", 2}, function{"reflect", 2},    function{"square", 1},  function{"meet", 2},
    function{"wedge", 2},   function{"commutator", 2}, function{"norm2", 1},   function{"dot", 2},
    function{"rnorm2", 1},  function{"regressive", 2}, function{"dual", 1},    function{"undual", 1},
    function{"rc", 1},      function{"lc", 1},         function{"rev", 1},     function{"involute", 1},
    function{"conj", 1},    function{"scalar", 1}};

// A number as the spec language writes it, in decimals.
inline rational number_of(const std::string &text) {
  const auto dot = text.find('.');
  if (dot == std::string::npos)
    return rational(text, 10);
  rational q(text.substr(0, dot) + text.substr(dot + 1) + "/1" + std::string(text.size() - dot - 1, '0'), 10);
  q.canonicalize();
  return q;
}

template <class D>
typename D::value call_function(D &d, const std::string &f, const std::vector<typename D::value> &a) {
  if (f == "gp")
    return d.geometric(a[0], a[1]);
  if (f == "wedge")
    return d.outer(a[0], a[1]);
  if (f == "dot")
    return d.dot(a[0], a[1]);
  if (f == "meet")
    return d.meet(a[0], a[1]);
  if (f == "commutator")
    return d.scale(rational(1, 2), d.subtract(d.geometric(a[0], a[1]), d.geometric(a[1], a[0])));
  if (f == "sandwich")
    return d.versor(a[0], a[1]);
  if (f == "reflect")
    return d.versor(a[1], a[0]);
  if (f == "project")
    return d.geometric(d.dot(a[0], a[1]), d.reverse(a[1]));
  if (f == "between")
    return d.subtract(d.geometric(d.geometric(a[0], a[1]), a[2]), d.geometric(a[2], d.geometric(a[1], a[0])));
  if (f == "twice")
    return d.subtract(d.add(d.outer(a[0], a[1]), d.inner(a[1], d.geometric(a[0], a[0]))), a[0]);
  if (f == "dual" || f == "undual")
    return d.dual(a[0], f == "undual");
  if (f == "rc" || f == "lc")
    return d.complement(a[0], f == "rc");
  if (f == "regressive")
    return d.complement(d.outer(d.complement(a[0], true), d.complement(a[1], true)), false);
  if (f == "involute")
    return d.involute(a[0]);
  if (f == "conj")
    return d.involute(d.reverse(a[0]));
  if (f == "scalar")
    return d.scalar_part(a[0]);
  if (f == "rnorm2")
    return d.scalar_part(d.geometric(a[0], d.reverse(a[0])));
  if (f == "inverse")
    return d.inverse(a[0]);
  if (f == "square")
    return d.geometric(a[0], a[0]);
  if (f == "norm2")
    return d.scalar_part(d.geometric(a[0], a[0]));
  if (f == "rev")
    return d.reverse(a[0]);
  throw std::out_of_range("no function " + f);
}

template <class D>
typename D::value evaluate(D &d, const expression &e, const std::vector<typename D::value> &parameters) {
  const auto part = [&](std::size_t i) { return evaluate(d, *e.parts[i], parameters); };
  switch (e.is) {
  case form::parameter:
    return parameters.at(static_cast<std::size_t>(e.index));
  case form::number:
    return d.number(number_of(e.text));
  case form::blade:
    return d.blade(e.vectors);
  case form::negate:
    return d.scale(-1, part(0));
  case form::add:
    return d.add(part(0), part(1));
  case form::subtract:
    return d.subtract(part(0), part(1));
  case form::multiply:
    return d.geometric(part(0), part(1));
  case form::reverse:
    return d.reverse(part(0));
  case form::divide:
    return d.geometric(part(0), d.inverse(part(1)));
  case form::outer:
    return d.outer(part(0), part(1));
  case form::inner:
    return d.inner(part(0), part(1));
  case form::regressive:
    return call_function(d, "regressive", {part(0), part(1)});
  case form::coefficient:
    return d.coefficient(part(0), part(1));
  case form::call:
    break;
  }
  if (e.text == "grade")
    return d.grade_part(part(0), static_cast<int>(number_of(e.parts[1]->text).get_d()));
  std::vector<typename D::value> arguments;
  for (std::size_t i = 0; i < e.parts.size(); ++i)
    arguments.push_back(part(i));
  return call_function(d, e.text, arguments);
}

// Multivectors of the oracle, in the declared basis.
class dense {
public:
  using value = multivector;
  explicit dense(const space &s) : space_(s), algebra_(s.algebra()) {}

  value number(const rational &q) const { return algebra_.scalar(q); }
  value blade(const std::vector<std::string> &vectors) const { return space_.blade(vectors); }
  value add(const value &a, const value &b) const { return oracle::add(a, b); }
  value subtract(const value &a, const value &b) const { return oracle::subtract(a, b); }
  value scale(const rational &q, const value &a) const { return oracle::scale(q, a); }
  value geometric(const value &a, const value &b) const { return algebra_.geometric(a, b); }
  value outer(const value &a, const value &b) const { return oracle::outer(a, b); }
  value inner(const value &a, const value &b) const { return algebra_.left_contraction(a, b); }
  value scalar_part(const value &a) const { return algebra_.scalar(oracle::scalar_part(a)); }
  value reverse(const value &a) const {
    return by_grade(a, [](int g) { return g * (g - 1) / 2 % 2 ? -1 : 1; });
  }
  value involute(const value &a) const {
    return by_grade(a, [](int g) { return g % 2 ? -1 : 1; });
  }
  value grade_part(const value &a, int k) const { return oracle::grade_part(a, k); }
  value complement(const value &a, bool right) const {
    const value i = algebra_.pseudoscalar();
    return right ? oracle::right_complement(a, i) : oracle::left_complement(a, i);
  }
  value dual(const value &a, bool back) const {
    const value i = algebra_.pseudoscalar();
    if (oracle::is_zero(geometric(i, i)))
      return complement(a, !back);
    return inner(a, back ? i : inverse(i));
  }
  value dot(const value &a, const value &b) const { return algebra_.symmetric_dot(a, b); }
  value inverse(const value &a) const { return algebra_.inverse(a); }
  value versor(const value &v, const value &x) const {
    const bool odd = oracle::is_zero(add(v, involute(v)));
    return geometric(geometric(v, odd ? involute(x) : x), reverse(v));
  }
  value meet(const value &a, const value &b) const {
    return space_.name() == "pga3" ? oracle::outer(a, b) : algebra_.meet(a, b, algebra_.pseudoscalar());
  }
  // Along a multiple of a blade of the vectors of lowering, or else of the declared ones.
  value coefficient(const value &a, const value &along) const {
    const auto one_of = [this](const value &from, const value &at) -> value {
      std::size_t found = at.size();
      for (std::size_t b = 0; b < at.size(); ++b)
        if (at[b] != 0) {
          if (found != at.size())
            return {};
          found = b;
        }
      return found == at.size() ? value{} : algebra_.scalar(from[found] / at[found]);
    };
    if (value v = one_of(space_.in_working(a), space_.in_working(along)); !v.empty())
      return v;
    if (value v = one_of(a, along); !v.empty())
      return v;
    throw std::domain_error("an index is no multiple of a blade");
  }

private:
  const space &space_;
  const oracle::dense_algebra &algebra_;

  template <class Sign> value by_grade(const value &a, Sign sign) const {
    value out = algebra_.zero();
    for (int g = 0; g <= algebra_.dimension(); ++g)
      out = oracle::add(out, oracle::scale(sign(g), oracle::grade_part(a, g)));
    return out;
  }
};

} // namespace meetc::fuzz

#endif
