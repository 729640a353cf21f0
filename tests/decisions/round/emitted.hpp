// The emitted ball predicates, each as a table of functions: the polynomials of its stages, exact signs of
// rational operands, and the emitted decision on signs.
#ifndef MEETC_TESTS_DECISIONS_ROUND_EMITTED_HPP
#define MEETC_TESTS_DECISIONS_ROUND_EMITTED_HPP

#include "tests/decisions/round/exact.hpp"

#include <meetc/support.hpp>
#include <string>
#include <vector>

namespace meetc::decisions_round {

// What the second operand is; the first is always a sphere.
enum class other { sphere, segment, triangle, point };

struct emitted {
  std::string name;
  other second;
  bool surface;
  int inputs_a, inputs_b, atoms;

  // Each atom as a polynomial in the stored numbers: the emitted template run on polynomials. `numbers` has
  // the variables of the first operand's row, then of the second's.
  std::vector<polynomial> (*polynomials)(const poly::ring &numbers);
  // The same of the second program that is emitted, the list of steps that wide integers take.
  std::vector<polynomial> (*step_polynomials)(const poly::ring &numbers);
  // Exact signs of the atoms: the emitted template run on rationals.
  std::vector<meetc::sign> (*signs)(const std::vector<rational> &row_a, const std::vector<rational> &row_b);
  // The product's own staging (meetc::decide) over given signs; of a lone sign, whether it is not negative.
  bool (*decide)(const meetc::sign *signs);
  // The parts of the staging; null for a lone sign.
  bool (*rejected)(const meetc::sign *signs);
  bool (*needs_rare)(const meetc::sign *signs);
  bool (*usual)(const meetc::sign *signs);
  bool (*whole)(const meetc::sign *signs);
  // A lone sign's value; null for a predicate.
  meetc::sign (*value)(const meetc::sign *signs);
};

const std::vector<emitted> &emitted_predicates(); // six predicates and the lone sign side(sphere, point)
const emitted &emitted_predicate(const std::string &name);

// The names of a predicate's stored numbers as the tests' rings have them: "a0", ..., "b0", ...
std::vector<std::string> row_names(const emitted &e);

} // namespace meetc::decisions_round

#endif
