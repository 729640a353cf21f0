#include "gen/lower/predicate/degrees.hpp"

#include "gen/bound/grading.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>

namespace meetc::lower {
namespace {

// The terms of a polynomial by their degree in the variables from `first` to `end`.
std::map<int, std::vector<poly::term>> by_degree(const poly::poly &p, int first, int end) {
  std::map<int, std::vector<poly::term>> out;
  for (const poly::term &t : p.terms()) {
    int degree = 0;
    for (const poly::power &f : t.factors)
      degree += f.variable >= first && f.variable < end ? f.exponent : 0;
    out[degree].push_back(t);
  }
  return out;
}

std::string text_of(const poly::poly &in, const std::vector<poly::term> &terms) {
  constexpr std::size_t most = 12; // terms that are written out
  return terms.size() > most ? fmt::format("({} of them)", terms.size())
                             : poly::poly::from_terms(in.in(), terms).text();
}

// Throws where a sign's terms differ in degree in the numbers of an operand for which `unit` says how to write the square of
// its length.
void check(const request &r, const predicate &p, const char *is, const std::function<std::string(std::size_t)> &unit) {
  int first = 0;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    const int end = first + (i == 0 ? p.inputs_a : p.inputs_b);
    if (const std::string square = unit(i); !square.empty())
      for (const poly::poly &atom : p.signs.atoms())
        if (const auto degrees = by_degree(atom, first, end); degrees.size() > 1)
          throw spec_error(
              r.where, fmt::format("a sign of '{}' has terms of degree {} and of degree {} in the numbers of {}, a {} "
                                   "that is {}; multiply the terms {} by {}",
                                   r.text, degrees.begin()->first, degrees.rbegin()->first, r.names[i],
                                   r.kinds[i]->name, is, text_of(atom, degrees.begin()->second), square));
    first = end;
  }
}

} // namespace

void check_degrees(const request &r, const predicate &p) {
  check(r, p, "unit only up to rounding", [&](std::size_t i) -> std::string {
    const auto nearly = std::find_if(r.kinds[i]->relations.begin(), r.kinds[i]->relations.end(),
                                     [](const lang::relation &x) { return x.nearly; });
    return nearly == r.kinds[i]->relations.end() ? "" : lang::print(*nearly->left);
  });
}

void check_versors(const model &m, const request &r, const predicate &p) {
  check(r, p, "a versor of any length", [&](std::size_t i) -> std::string {
    const std::vector<blade> blades = support(m, *r.kinds[i]);
    const bool versor = std::any_of(blades.begin(), blades.end(),
                                    [&](blade b) { return algebra::grade(b) != algebra::grade(blades.front()); });
    return versor ? fmt::format("({0} * ~{0})[1]", r.names[i]) : "";
  });
}

void refuse_degrees(const request &r, const predicate &p) {
  std::vector<const poly::poly *> known;
  for (std::size_t i = 0; i < p.signs.atoms().size(); ++i) {
    const poly::poly &atom = p.signs.atoms()[i];
    known.push_back(&atom);
    if (bound::find_grading(known, *p.local))
      continue;
    const auto degrees = by_degree(atom, 0, p.numbers->size());
    const std::string said = p.signs.text(static_cast<int>(i));
    const int apart = degrees.rbegin()->first - degrees.begin()->first;
    throw spec_error(
        r.where,
        fmt::format(
            "a sign of '{}' is not homogeneous in the stored numbers, which the exact rung needs: {} has terms of "
            "degree {} and of degree {}, and no weights of the numbers make these equal{}; multiply the terms {} "
            "by {} of the kind's own, such as a length that it stores",
            r.text, said.empty() ? "one" : said, degrees.begin()->first, degrees.rbegin()->first,
            bound::find_grading({&atom}, *p.local) ? " in all signs" : "", text_of(atom, degrees.begin()->second),
            apart == 1 ? "a number" : fmt::format("{} numbers", apart)));
  }
  throw spec_error(r.where, fmt::format("a sign of '{}' is not homogeneous in the stored numbers, which the exact rung "
                                        "needs",
                                        r.text));
}

} // namespace meetc::lower
