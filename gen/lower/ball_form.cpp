#include "gen/lower/ball_form.hpp"

#include "gen/lower/build.hpp"

#include <stdexcept>

namespace meetc::lower {

ball_form make_ball_form() {
  std::vector<std::string> names;
  std::vector<poly::stored_number> numbers;
  for (const int operand : {0, 1})
    for (const std::string &n : ball_form::names) {
      names.push_back((operand ? "Y." : "X.") + n);
      numbers.push_back({operand, -1, 0, false}); // of the products no one is translation invariant
    }
  auto ring = std::make_unique<poly::ring>(names);
  const auto number = [&](int operand, int i) { return poly::poly::variable(*ring, operand * ball_form::inputs + i); };
  poly::poly whole(*ring);
  constexpr int radius = ball_form::inputs - 1;
  for (int i = 0; i < radius; ++i) {
    const poly::poly d = number(0, i) - number(1, i);
    whole = whole + d * d;
  }
  const poly::poly reach = number(0, radius) + number(1, radius);
  // Halved, every product has the coefficients 1 and -1.
  whole = (whole - reach * reach).scaled(rational(1, 2));
  const poly::separation parts = poly::separate(whole, ball_form::inputs);
  if (!(poly::to_poly(parts) == whole) || parts.additive() != 2)
    throw std::logic_error("the form of balls is not separated");
  const poly::frame frame(*ring, numbers);
  builder code(frame, prefer::operations);
  std::vector<node_id> a, b;
  for (const poly::product &k : parts.products) {
    a.push_back(code.build(k.f));
    b.push_back(code.build(k.g));
  }
  a.push_back(code.build(parts.of_x));
  b.push_back(code.build(parts.of_y));
  program of_a = code.finish(a), of_b = code.finish(b);
  return {std::move(ring), whole, parts, std::move(of_a), std::move(of_b)};
}

} // namespace meetc::lower
