// Scripts for Gappa (https://gappa.gitlabpages.inria.fr): the margins of the half-precision filter of touching balls.
//
// Claim and derivation are in gen/bound/matrix.hpp. The computed value is a polynomial in the numbers and in one free
// variable for each error, so the proof holds for all errors. |f g| <= (f^2 + g^2) / 2 enters as (|f| - |g|)^2 >= 0.
// The only rule that Gappa is given is an identity, which Gappa checks: it warns otherwise.
//   ball_filter   F <= 0 implies D < 0
//   half_parts    the parts have the errors that the first script assumes, and products of parts are exact in fp32
// Not proved, but assumed: how far the matrix unit's sum is from the sum of its products.
#include "gen/bound/matrix.hpp"
#include "gen/lower/ball_form.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/gappa/gappa.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string number(const bound::dyadic &d) {
  return d.exponent ? fmt::format("{}b{}", d.numerator, d.exponent) : fmt::format("{}", d.numerator);
}

// The sum "t0 + t1 + ..." of a term for each product; `term` gets the product's number.
template <class Term> std::string sum(std::size_t products, const Term &term) {
  std::string out;
  for (std::size_t k = 0; k < products; ++k)
    out += (k ? " + " : "") + term(k);
  return out;
}

const char *const filter_comment =
    R"(#   Object x (and y in the same way) has features f = d u, u = |f| and d its sign: fx0, fx1, ... of products, fx additive.
#   hx0, lx0   the parts of fx0 in fp16: ex0, ix0 are relative rounding errors; sx0, tx0 are changes by replacing small parts
#   mx, ax     the margin, and fx less the margin; zx is the error of shifting, scaling and evaluating
#   hx, lx     the parts of ax, times 2^8; wx >= 0 is the error of rounding down
#   p, q, r    the relative errors of the matrix unit in each product: |D - sum t| <= c sum |t| is D = sum t (1 + p), |p| <= c
#   F          is <= 0 where balls touch; D is computed
#   W, T       the excess of F over D: P, Q, R, S are the coefficients of u v, u, v and 1 in a product's error, cx is the
#              unit's error in ax. The last line is an identity.
)";

std::string filter_script(std::size_t products) {
  using namespace bound;
  std::string out = fmt::format("square = {};\nadditive = {};\nlinear = {};\nabsolute = {};\n",
                                number({2 * margin_square.numerator, margin_square.exponent}), number(margin_additive),
                                number(margin_linear), number(margin_absolute));
  const auto line = [&out](fmt::string_view format, const auto &...values) {
    out += fmt::format(fmt::runtime(format), values...) + '\n';
  };
  std::string given;
  const auto suppose = [&given](const std::string &what) { given += (given.empty() ? "" : " /\\\n  ") + what; };
  const auto small = [&](const std::string &name, const dyadic &most) {
    suppose(fmt::format("|{}| <= {}", name, number(most)));
  };
  for (const char *x : {"x", "y"}) {
    for (std::size_t k = 0; k < products; ++k) {
      line("f{0}{1} = d{0}{1} * u{0}{1};", x, k);
      line("h{0}{1} = f{0}{1} * (1 + e{0}{1}) + s{0}{1};", x, k);
      line("l{0}{1} = (f{0}{1} - h{0}{1}) * (1 + i{0}{1}) + t{0}{1};", x, k);
      const std::string n = fmt::format("{}{}", x, k);
      suppose(fmt::format("u{0} in [0, {1}] /\\ d{0} in [-1, 1]", n, number(matrix_input)));
      small('e' + n, matrix_part);
      small('i' + n, matrix_part);
      small('s' + n, matrix_flush);
      small('t' + n, matrix_flush);
    }
    line("f{0} = d{0} * u{0};", x);
    line("m{0} = square / 2 * ({1}) + additive * u{0} + linear * ({2}) + absolute;", x,
         sum(products, [&](std::size_t k) { return fmt::format("u{0}{1} * u{0}{1}", x, k); }),
         sum(products, [&](std::size_t k) { return fmt::format("u{0}{1}", x, k); }));
    line("a{0} = f{0} + z{0} - m{0};", x);
    line("h{0} = a{0} * (1 + e{0}) + s{0};", x);
    line("l{0} = a{0} - w{0} - h{0};", x);
    suppose(fmt::format("u{0} in [0, {1}] /\\ d{0} in [-1, 1] /\\ w{0} in [0, 8]", x, number(matrix_additive)));
    small(fmt::format("z{}", x), matrix_evaluate);
    small(fmt::format("e{}", x), matrix_step);
    small(fmt::format("s{}", x), {matrix_flush.numerator, matrix_flush.exponent + matrix_unit.exponent});
    small(fmt::format("p{}", x), matrix_accumulate);
    small(fmt::format("q{}", x), matrix_accumulate);
  }
  for (std::size_t k = 0; k < products; ++k)
    for (const char *p : {"p", "q", "r"})
      small(fmt::format("{}{}", p, k), matrix_accumulate);
  line("F = {} + fx + fy;", sum(products, [](std::size_t k) { return fmt::format("fx{0} * fy{0}", k); }));
  line("D = {} + hx * (1 + px) + lx * (1 + qx) + hy * (1 + py) + ly * (1 + qy);", sum(products, [](std::size_t k) {
         return fmt::format("hx{0} * hy{0} * (1 + p{0}) + hx{0} * ly{0} * (1 + q{0}) + lx{0} * hy{0} * (1 + r{0})", k);
       }));
  for (std::size_t k = 0; k < products; ++k) {
    // h = f (1 + e) + s and l = f b + c.
    for (const char *x : {"x", "y"}) {
      line("b{0}{1} = -e{0}{1} * (1 + i{0}{1});", x, k);
      line("c{0}{1} = t{0}{1} - s{0}{1} * (1 + i{0}{1});", x, k);
    }
    line("P{0} = dx{0} * dy{0} * (ex{0} * ix{0} * ey{0} * iy{0} - ex{0} * ix{0} - ey{0} * iy{0} - bx{0} * by{0} + "
         "p{0} * (1 + ex{0}) * (1 + ey{0}) + q{0} * (1 + ex{0}) * by{0} + r{0} * bx{0} * (1 + ey{0}));",
         k);
    line("Q{0} = dx{0} * ((1 + ex{0}) * (ty{0} - sy{0} * iy{0} + p{0} * sy{0} + q{0} * cy{0}) + bx{0} * sy{0} * (1 + "
         "r{0}));",
         k);
    line("R{0} = dy{0} * ((1 + ey{0}) * (tx{0} - sx{0} * ix{0} + p{0} * sx{0} + r{0} * cx{0}) + by{0} * sx{0} * (1 + "
         "q{0}));",
         k);
    line("S{0} = sx{0} * sy{0} * (1 + p{0}) + sx{0} * cy{0} * (1 + q{0}) + cx{0} * sy{0} * (1 + r{0});", k);
    line("W{0} = square / 2 * ((ux{0} - uy{0}) * (ux{0} - uy{0})) + (square - P{0}) * ux{0} * uy{0} + (linear - Q{0}) "
         "* ux{0} + "
         "(linear - R{0}) * uy{0} - S{0};",
         k);
  }
  for (const char *x : {"x", "y"}) {
    line("c{0} = p{0} * (1 + e{0}) - q{0} * e{0};", x);
    line("T{0} = absolute + c{0} * m{0} - z{0} * (1 + c{0}) + w{0} * (1 + q{0}) - (p{0} - q{0}) * s{0} + "
         "(additive - c{0} * d{0}) * u{0};",
         x);
  }
  // Strictly below 0, and no stored number overflows.
  out += fmt::format("{{ {} /\\\n  F <= 0\n  -> D <= -1b-20 /\\ |ax| <= 1b23 /\\ |ay| <= 1b23 }}\n", given);
  out += fmt::format("D -> F - ({} + Tx + Ty);\n", sum(products, [](std::size_t k) { return fmt::format("W{}", k); }));
  return out;
}

std::string parts_script() {
  using namespace bound;
  return fmt::format(
      "@half = float<11, -24, ne>;\n@down = float<11, -24, dn>;\n@single = float<24, -149, ne>;\n"
      "{{ |n| in [{0}, {1}] /\\ |s| <= {0} /\\ |y| <= {1} /\\ |v| <= {1}\n"
      "  -> |half(n) -/ n| <= {2} /\\ |half(n)| >= {0} /\\ |down(n) -/ n| <= {3} /\\ down(n) - n <= 0 /\\\n"
      "  |half(s) - s| <= {0} /\\ |half(s)| <= {0} /\\\n"
      "  single(half(y) * half(v)) - half(y) * half(v) in [0, 0] /\\\n"
      "  single(down(y) * {4}) - down(y) * {4} in [0, 0] }}\n",
      number(matrix_flush), "1b15", number(matrix_part), number(matrix_step), number(matrix_unit));
}

} // namespace

std::vector<file> filter_proofs(const unit &u) {
  const std::string folder = identifier(u.scene.space) + "/proofs/";
  return {
      {folder + "ball_filter.gappa",
       banner(u.scene, "The matrix filter of touching balls: where F <= 0, the computed D is < 0.", "#") +
           filter_comment + filter_script(u.balls->parts.products.size())},
      {folder + "half_parts.gappa",
       banner(u.scene, "The parts in fp16 that the matrix filter multiplies.", "#") +
           "#   n is a number whose part is normal: the part has a small relative error and is not replaced by 0.\n"
           "#   s is a smaller number, whose part is small too. Products of two parts, or of one and 2^8, are exact in "
           "fp32.\n" +
           parts_script()}};
}

} // namespace meetc::target
