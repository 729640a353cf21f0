// The compiler's meets against the paper's printed equations (3.1) to (3.5), as polynomials: the printed letters are
// coefficients on the blades of Table 1, so the algebra is compiled without its null basis.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"
#include "tests/paper/printed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

using paper_test::printed_formula;
using paper_test::printed_line;
using paper_test::term;
using names = std::set<std::string>;
using polynomials = std::map<std::string, poly::poly>; // by blade, "e1^e2"

const compilation &meets() {
  static const spec_copy copy({"meet(plane, line)", "meet(plane, plane)", "meet(sphere, sphere)",
                               "norm2(meet(plane, line))", "norm2(meet(plane, plane))", "norm2(meet(sphere, sphere))"});
  static const compilation c = [] {
    copy.replace("cga3.toml", "null    = ['n', 'nb']", "");
    return copy.compile();
  }();
  return c;
}

// A blade as the paper names it, "e3 e1 eb": the sign of its order, and the name "e1^e3^eb" in the algebra's order.
std::pair<int, std::string> in_order(const std::string &blade) {
  static const std::vector<std::string> order{"e1", "e2", "e3", "e", "eb"};
  std::vector<std::ptrdiff_t> places;
  std::istringstream words(blade);
  for (std::string word; words >> word;)
    places.push_back(std::find(order.begin(), order.end(), word) - order.begin());
  int sign = 1;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j)
      sign *= places[i] > places[j] ? -1 : 1;
  std::sort(places.begin(), places.end());
  std::string name;
  for (const std::ptrdiff_t p : places)
    name += (name.empty() ? "" : "^") + order[static_cast<std::size_t>(p)];
  return {sign, name};
}

// The printed letters of one operand: polynomials in the ring of the compiled formula.
using letters = std::vector<poly::poly>;
letters letters_of(const poly::ring &in, const char *operand, const std::vector<std::string> &blades) {
  letters all;
  for (const std::string &blade : blades) {
    const auto [sign, name] = in_order(blade);
    const int v = in.find(fmt::format("{}.{}", operand, name));
    REQUIRE(v >= 0);
    all.push_back(poly::poly::variable(in, v).scaled(sign));
  }
  return all;
}

// A flat blade has a factor n = e + eb, so that its coefficients with e alone are those with eb: the paper has letters for
// the latter.
poly::poly with_letters(const poly::poly &p, bool flat) {
  const poly::ring &in = p.in();
  std::vector<int> to;
  for (const std::string &name : in.names()) {
    const int twin = flat && name.ends_with("^e") ? in.find(name + "b") : -1;
    to.push_back(in.find(twin < 0 ? name : name + "b"));
  }
  return p.renamed(to, in);
}

struct compared {
  polynomials compiled; // none for a number
  letters first, second;
};
compared meet_of(std::size_t number, bool flat, const std::vector<std::string> &first,
                 const std::vector<std::string> &second) {
  const lower::formula &f = meets().kernels.at(number).value;
  REQUIRE(f.polynomials.size() == f.result_names.size());
  compared c;
  for (std::size_t i = 0; i < f.polynomials.size() && !f.is_number(); ++i)
    c.compiled.emplace(f.result_names[i].text(), with_letters(f.polynomials[i], flat));
  c.first = letters_of(*f.numbers, "X", first);
  c.second = letters_of(*f.numbers, "Y", second);
  return c;
}

poly::poly printed(const printed_line &line, const compared &c) {
  poly::poly sum(c.first[0].in());
  for (const term &t : line.terms)
    sum = sum + (c.first[static_cast<std::size_t>(t.first) - 1] * c.second[static_cast<std::size_t>(t.second) - 1])
                    .scaled(t.sign);
  return sum;
}

// The lines that are not the compiler's, with the better of the two signs for the whole formula.
names wrong_lines(const printed_formula &formula, const compared &c) {
  names wrong[2];
  for (const printed_line &line : formula) {
    const auto [sign, name] = in_order(line.blade);
    for (const int whole : {0, 1})
      if (!c.compiled.contains(name) || !(c.compiled.at(name) == printed(line, c).scaled(whole == 0 ? sign : -sign)))
        wrong[whole].insert(line.blade);
  }
  return wrong[0].size() < wrong[1].size() ? wrong[0] : wrong[1];
}

// The blades that the formula prints, and those that the compiler finds.
void check_blades(const printed_formula &formula, const compared &c) {
  names by_paper, by_compiler;
  for (const printed_line &line : formula)
    by_paper.insert(in_order(line.blade).second);
  for (const auto &[name, value] : c.compiled)
    if (!value.is_zero())
      by_compiler.insert(name);
  CHECK(by_paper == by_compiler);
}

// B^2 is a sum of squares of printed lines, each with a sign.
poly::poly sum_of_squares(const printed_formula &formula, const compared &c, int (*sign_of)(const std::string &blade)) {
  poly::poly sum(c.first[0].in());
  for (const printed_line &line : formula)
    if (const int sign = sign_of(line.blade); sign != 0)
      sum = sum + (printed(line, c) * printed(line, c)).scaled(sign);
  return sum;
}
poly::poly norm2(std::size_t number, bool flat) {
  return with_letters(meets().kernels.at(number).value.polynomials.at(0), flat);
}

compared plane_line(std::size_t number) {
  return meet_of(number, true, paper_test::plane_names(), paper_test::line_names());
}
compared plane_plane(std::size_t number) {
  return meet_of(number, true, paper_test::plane_names(), paper_test::plane_names());
}
compared sphere_sphere(std::size_t number) {
  return meet_of(number, false, paper_test::sphere_names(), paper_test::sphere_names());
}

} // namespace

TEST_CASE("E1: the compiler's meet of plane and line is (3.1) but for the sign on e2 eb") {
  const compared c = plane_line(0);
  check_blades(paper_test::printed_3_1(), c);
  CHECK(wrong_lines(paper_test::printed_3_1(), c) == names{"e2 eb"});
  printed_formula mended = paper_test::printed_3_1();
  mended[3].terms[2].sign = +1;
  CHECK(wrong_lines(mended, c).empty());
}

TEST_CASE("(3.2): the compiler's B^2 of plane and line is the printed square") {
  const compared c = plane_line(3);
  const auto line = [](const std::string &blade) { return blade == "e eb" ? 1 : 0; };
  CHECK(norm2(3, true) == sum_of_squares(paper_test::printed_3_1(), c, line));
}

TEST_CASE("(3.3), (3.4): the compiler's meet of two planes and its B^2 are the printed ones") {
  check_blades(paper_test::printed_3_3(), plane_plane(1));
  CHECK(wrong_lines(paper_test::printed_3_3(), plane_plane(1)).empty());
  const auto first_row = [](const std::string &blade) { return blade.ends_with(" e eb") ? 1 : 0; };
  CHECK(norm2(4, true) == sum_of_squares(paper_test::printed_3_3(), plane_plane(4), first_row));
}

TEST_CASE("(3.5), E3: the compiler's meet of two spheres is the printed one, and B^2 the sum of signed squares") {
  check_blades(paper_test::printed_3_5(), sphere_sphere(2));
  CHECK(wrong_lines(paper_test::printed_3_5(), sphere_sphere(2)).empty());
  const auto each = [](const std::string &blade) { return blade.ends_with(" e") || blade == "e1 e2 e3" ? -1 : 1; };
  CHECK(norm2(5, false) == sum_of_squares(paper_test::printed_3_5(), sphere_sphere(5), each));
}

TEST_CASE("any single flipped sign of a printed equation differs from the compiler's meet") {
  const compared of[] = {plane_line(0), plane_plane(1), sphere_sphere(2)};
  printed_formula mended = paper_test::printed_3_1();
  mended[3].terms[2].sign = +1;
  const printed_formula formulas[] = {mended, paper_test::printed_3_3(), paper_test::printed_3_5()};
  for (std::size_t f = 0; f < 3; ++f)
    for (std::size_t i = 0; i < formulas[f].size(); ++i)
      for (std::size_t j = 0; j < formulas[f][i].terms.size(); ++j) {
        printed_formula flipped = formulas[f];
        flipped[i].terms[j].sign *= -1;
        CHECK(wrong_lines(flipped, of[f]) == names{flipped[i].blade});
      }
}
