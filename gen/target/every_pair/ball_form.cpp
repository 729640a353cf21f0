// Touching balls as a sum of products: a header with the features and the margins of the filter.
#include "gen/bound/matrix.hpp"
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/bounds.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/every_pair/every_pair.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string features(const ir::program &code, const char *name, char argument, char result, int first_input) {
  body_names names;
  names.input = [&](int i) { return fmt::format("{}[{}]", argument, i - first_input); };
  names.result = [&](std::size_t i, const std::string &value) { return fmt::format("{}[{}] = {};", result, i, value); };
  return fmt::format("  template <class T> MEETC_HD static void {}(const T *{}, T *{}) {{\n{}  }}\n", name, argument,
                     result, body(code, names, "    "));
}

} // namespace

std::string ball_form_header(const unit &u) {
  const lower::ball_form &form = *u.balls;
  const auto products = form.parts.products.size();
  std::string out = banner(u.scene, "Touching balls as a sum of products, by which pairs are filtered.") +
                    open_header(u.scene, "file_ball_form");
  out += fmt::format(
      "// Balls (x, y, z, r), r >= 0, touch where |c - c'|^2 <= (r + r')^2, that is where half of the difference,\n"
      "//   sum over k < products of f_k(X) g_k(Y), plus f(X) + g(Y),\n// is <= 0. K = {}:\n",
      form.parts.terms());
  for (std::size_t k = 0; k < products; ++k)
    out += fmt::format("//   f_{0} = {1}, g_{0} = {2}\n", k, form.parts.products[k].f.text(),
                       form.parts.products[k].g.text());
  out += fmt::format("//   f = {}\n//   g = {}\n", form.parts.of_x.text(), form.parts.of_y.text());
  out += fmt::format("struct ball_form {{\n  static constexpr int inputs = {}, products = {};\n\n",
                     lower::ball_form::inputs, products);
  const auto constant = [](const char *name, const bound::dyadic &value) {
    return fmt::format("  static constexpr float {} = {};\n", name, hex_literal(value.value(), "f"));
  };
  out += fmt::format("  // The filter in half precision{}: if |input| <= largest_input and the margin\n",
                     u.asks(lang::rung::certified) ? " (proofs/ball_filter.gappa)" : "") +
         "  //   m = margin_square * sum f_k^2 + margin_additive * |f| + margin_linear * sum |f_k| + margin_absolute\n"
         "  // is subtracted from f, and likewise from g, then the computed sum of balls that touch is negative.\n";
  out += constant("largest_input", bound::matrix_input) + constant("additive_unit", bound::matrix_unit) +
         constant("least_part", bound::matrix_flush) + constant("margin_square", bound::margin_square) +
         constant("margin_additive", bound::margin_additive) + constant("margin_linear", bound::margin_linear) +
         constant("margin_absolute", bound::margin_absolute);
  out += fmt::format("\n  // f_0 to f_{0}, then f: products + 1 values. {1}.\n", products - 1,
                     count_text(ir::count(form.a.nodes, form.a.results)));
  out += features(form.a, "features_a", 'x', 'f', 0);
  out += fmt::format("  // g_0 to g_{0}, then g. {1}.\n", products - 1,
                     count_text(ir::count(form.b.nodes, form.b.results)));
  out += features(form.b, "features_b", 'y', 'g', lower::ball_form::inputs);
  return out + "};\n" + close_header(u.scene);
}

} // namespace meetc::target
