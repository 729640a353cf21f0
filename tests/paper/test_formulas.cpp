// The printed expansions (3.1) to (3.5) against the dense product.
#include "tests/catch.hpp"
#include "tests/paper/printed.hpp"

#include <set>

using namespace meetc::paper_test;

namespace {

// One meet of two random primitives, and the coefficients that the paper's letters stand for.
struct sample {
  std::vector<rational> first, second;
  multivector b;
};
using sampler = sample (*)(random_numbers &);

sample plane_line(random_numbers &r) {
  const multivector p = plane(random_vec(r), random_vec(r), random_vec(r)), l = line(random_vec(r), random_vec(r));
  return {coefficients(p, plane_names()), coefficients(l, line_names()), meet(p, l)};
}
sample plane_plane(random_numbers &r) {
  const multivector p = plane(random_vec(r), random_vec(r), random_vec(r));
  const multivector q = plane(random_vec(r), random_vec(r), random_vec(r));
  return {coefficients(p, plane_names()), coefficients(q, plane_names()), meet(p, q)};
}
sample sphere_sphere(random_numbers &r) {
  const multivector s = sphere(random_vec(r), random_vec(r), random_vec(r), random_vec(r));
  const multivector t = sphere(random_vec(r), random_vec(r), random_vec(r), random_vec(r));
  return {coefficients(s, sphere_names()), coefficients(t, sphere_names()), meet(s, t)};
}

// The lines of a formula that fail somewhere on random meets, with the better global sign.
std::set<std::string> wrong_lines(const printed_formula &formula, sampler draw, int samples = 100) {
  std::set<std::string> wrong[2];
  random_numbers r(1);
  for (int t = 0; t < samples; ++t) {
    const sample s = draw(r);
    for (const printed_line &line : formula) {
      const rational value = evaluate(line, s.first, s.second), truth = coefficient(s.b, line.blade);
      if (value != truth)
        wrong[0].insert(line.blade);
      if (-value != truth)
        wrong[1].insert(line.blade);
    }
  }
  return wrong[0].size() < wrong[1].size() ? wrong[0] : wrong[1];
}

// Whether B has a blade that the formula does not print.
bool has_unprinted_blade(const printed_formula &formula, sampler draw) {
  random_numbers r(2);
  for (int t = 0; t < 20; ++t) {
    const multivector b = draw(r).b;
    int printed = 0;
    for (const printed_line &line : formula)
      printed += coefficient(b, line.blade) != 0;
    if (printed != nonzero_blades(b))
      return true;
  }
  return false;
}

printed_formula corrected_3_1() {
  printed_formula f = printed_3_1();
  f[3].terms[2].sign = +1; // e2 eb: +ω1β5
  return f;
}

// The same sample with the letters from `mixed` on (those of blades with both eb and e) named on e eb
// instead.
sample reversed(sample s, std::size_t mixed) {
  for (std::vector<rational> *c : {&s.first, &s.second})
    for (std::size_t i = mixed; i < c->size(); ++i)
      (*c)[i] *= -1;
  return s;
}

using names = std::set<std::string>;

} // namespace

TEST_CASE("E1: in (3.1) only the e2 eb line is wrong, and + omega1 beta5 mends it") {
  CHECK(wrong_lines(printed_3_1(), plane_line) == names{"e2 eb"});
  CHECK(printed_3_1()[3].blade == "e2 eb");
  CHECK(wrong_lines(corrected_3_1(), plane_line).empty());
  CHECK_FALSE(has_unprinted_blade(printed_3_1(), plane_line));
}

TEST_CASE("E1: of the 21 signs of (3.1), flipping that one is the only single change that makes all lines right") {
  int repairs = 0;
  for (std::size_t i = 0; i < printed_3_1().size(); ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      printed_formula f = printed_3_1();
      f[i].terms[j].sign *= -1;
      if (wrong_lines(f, plane_line, 20).empty()) {
        ++repairs;
        CHECK(i == 3);
        CHECK(j == 2);
      }
    }
  CHECK(repairs == 1);
}

TEST_CASE("E2: (3.2) is B^2 of the true meet, and not of the printed (3.1)") {
  random_numbers r(4);
  for (int t = 0; t < 200; ++t) {
    const sample s = plane_line(r);
    const std::vector<rational> &w = s.first, &b = s.second;
    const rational root = w[2] * b[3] + w[3] * b[4] + w[1] * b[5];
    CHECK(norm2(s.b) == root * root);
    // B as printed, squared: e_i e squares to −1, e_i eb and e eb to +1.
    rational printed = 0, corrected = 0;
    for (const auto &[formula, sum] : {std::pair{printed_3_1(), &printed}, std::pair{corrected_3_1(), &corrected}})
      for (const printed_line &line : formula) {
        const rational c = evaluate(line, w, b);
        *sum += (line.blade.ends_with(" e") ? -1 : 1) * c * c;
      }
    CHECK(corrected == root * root);
    // With m = ω3β1 − ω2β2 and k = ω1β5 the printed pair adds (m − k)² − (m + k)² = −4 m k.
    const rational m = w[2] * b[0] - w[1] * b[1], k = w[0] * b[4];
    CHECK(printed == root * root - 4 * m * k);
    CHECK((printed == root * root) == (m * k == 0));
  }
}

TEST_CASE("(3.3), (3.4): plane with plane is right, 9 lines of 9, and so is its B^2") {
  CHECK(printed_3_3().size() == 9);
  CHECK(wrong_lines(printed_3_3(), plane_plane).empty());
  CHECK_FALSE(has_unprinted_blade(printed_3_3(), plane_plane));
  random_numbers r(5);
  for (int t = 0; t < 100; ++t) {
    const sample s = plane_plane(r);
    rational sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const rational c = evaluate(printed_3_3()[i], s.first, s.second);
      sum += c * c;
    }
    CHECK(norm2(s.b) == sum);
  }
}

TEST_CASE("(3.5), E3: sphere with sphere is right, 10 lines of 10, the B^2 that it lacks") {
  CHECK(printed_3_5().size() == 10);
  CHECK(wrong_lines(printed_3_5(), sphere_sphere).empty());
  CHECK_FALSE(has_unprinted_blade(printed_3_5(), sphere_sphere));
  // The missing line: − the squares of the three e_i e_j e, − that of e1 e2 e3, + all the others.
  random_numbers r(6);
  for (int t = 0; t < 100; ++t) {
    const sample s = sphere_sphere(r);
    rational sum = 0;
    for (const printed_line &line : printed_3_5()) {
      const rational c = evaluate(line, s.first, s.second);
      const bool minus = line.blade.ends_with(" e") || line.blade == "e1 e2 e3";
      sum += (minus ? -1 : 1) * c * c;
    }
    CHECK(norm2(s.b) == sum);
  }
}

TEST_CASE("any single flipped sign in (3.3) or (3.5) would be noticed") {
  for (const auto &[formula, draw] :
       {std::pair{printed_3_3(), sampler(plane_plane)}, std::pair{printed_3_5(), sampler(sphere_sphere)}})
    for (std::size_t i = 0; i < formula.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        printed_formula f = formula;
        f[i].terms[j].sign *= -1;
        CHECK(wrong_lines(f, draw, 20) == names{f[i].blade});
      }
}

TEST_CASE("Table 1 names the letters: eb before e, with e before eb (3.3) and (3.5) fail") {
  const sampler planes = [](random_numbers &r) { return reversed(plane_plane(r), 1); };
  const sampler spheres = [](random_numbers &r) { return reversed(sphere_sphere(r), 2); };
  CHECK(wrong_lines(printed_3_3(), planes).size() == 3);
  CHECK(wrong_lines(printed_3_5(), spheres).size() == 4);
}
