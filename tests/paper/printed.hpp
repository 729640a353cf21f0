// The paper's printed expansions, as data, letter for letter: a line is the coefficient of one blade of B, a
// term is sign, index into the first operand's coefficients, index into the second's (from 1, as printed).
#ifndef MEETC_TESTS_PAPER_PRINTED_HPP
#define MEETC_TESTS_PAPER_PRINTED_HPP

#include "tests/paper/cga.hpp"

#include <string>
#include <vector>

namespace meetc::paper_test {

struct term {
  int sign, first, second;
};
struct printed_line {
  std::string blade;
  std::vector<term> terms;
};
using printed_formula = std::vector<printed_line>;

// (3.1): plane ω with line β. (The erratum E1 is in the line "e2 eb".)
inline printed_formula printed_3_1() {
  return {{"e1 e", {{+1, 2, 3}, {+1, 1, 4}, {-1, 4, 1}}}, {"e1 eb", {{+1, 2, 3}, {+1, 1, 4}, {-1, 4, 1}}},
          {"e2 e", {{+1, 3, 1}, {-1, 2, 2}, {+1, 1, 5}}}, {"e2 eb", {{+1, 3, 1}, {-1, 2, 2}, {-1, 1, 5}}},
          {"e3 e", {{-1, 3, 3}, {+1, 4, 2}, {+1, 1, 6}}}, {"e3 eb", {{-1, 3, 3}, {+1, 4, 2}, {+1, 1, 6}}},
          {"e eb", {{-1, 3, 4}, {-1, 4, 5}, {-1, 2, 6}}}};
}
// (3.3): plane ω with plane λ.
inline printed_formula printed_3_3() {
  return {{"e1 e eb", {{+1, 4, 2}, {-1, 2, 4}}},  {"e2 e eb", {{+1, 2, 3}, {-1, 3, 2}}},
          {"e3 e eb", {{+1, 3, 4}, {-1, 4, 3}}},  {"e1 e2 e", {{+1, 2, 1}, {-1, 1, 2}}},
          {"e2 e3 e", {{+1, 3, 1}, {-1, 1, 3}}},  {"e3 e1 e", {{+1, 4, 1}, {-1, 1, 4}}},
          {"e1 e2 eb", {{+1, 2, 1}, {-1, 1, 2}}}, {"e2 e3 eb", {{+1, 3, 1}, {-1, 1, 3}}},
          {"e3 e1 eb", {{+1, 4, 1}, {-1, 1, 4}}}};
}
// (3.5): sphere μ with sphere λ.
inline printed_formula printed_3_5() {
  return {{"e1 e2 e", {{+1, 3, 1}, {-1, 1, 3}}},  {"e2 e3 e", {{+1, 4, 1}, {-1, 1, 4}}},
          {"e3 e1 e", {{+1, 5, 1}, {-1, 1, 5}}},  {"e1 e2 eb", {{+1, 3, 2}, {-1, 2, 3}}},
          {"e2 e3 eb", {{+1, 4, 2}, {-1, 2, 4}}}, {"e3 e1 eb", {{+1, 5, 2}, {-1, 2, 5}}},
          {"e1 e eb", {{+1, 5, 3}, {-1, 3, 5}}},  {"e2 e eb", {{+1, 3, 4}, {-1, 4, 3}}},
          {"e3 e eb", {{+1, 4, 5}, {-1, 5, 4}}},  {"e1 e2 e3", {{+1, 1, 2}, {-1, 2, 1}}}};
}

// The blades of Table 1 that the printed letters name, whose order is eb before e.
inline std::vector<std::string> plane_names() {
  return {"e1 e2 e3 eb", "e1 e2 eb e", "e2 e3 eb e", "e3 e1 eb e"};
}
inline std::vector<std::string> line_names() {
  return {"e1 e2 eb", "e2 e3 eb", "e3 e1 eb", "e1 eb e", "e2 eb e", "e3 eb e"};
}
inline std::vector<std::string> sphere_names() {
  return {"e1 e2 e3 e", "e1 e2 e3 eb", "e1 e2 eb e", "e2 e3 eb e", "e3 e1 eb e"};
}

inline std::vector<rational> coefficients(const multivector &x, const std::vector<std::string> &names) {
  std::vector<rational> r;
  for (const std::string &name : names)
    r.push_back(coefficient(x, name));
  return r;
}
inline rational evaluate(const printed_line &line, const std::vector<rational> &first,
                         const std::vector<rational> &second) {
  rational sum = 0;
  for (const term &t : line.terms)
    sum += t.sign * first.at(static_cast<std::size_t>(t.first) - 1) * second.at(static_cast<std::size_t>(t.second) - 1);
  return sum;
}

} // namespace meetc::paper_test

#endif
