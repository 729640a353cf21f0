// The emitted ball predicates, each as a table of functions: the polynomials of its stages, exact signs of
// rational operands, and the emitted decision on signs.
#ifndef MEETC_TESTS_DECISIONS_ROUND_EMITTED_HPP
#define MEETC_TESTS_DECISIONS_ROUND_EMITTED_HPP

#include "tests/decisions/round/exact.hpp"

#include <meetc/support.hpp>
#include <string>
#include <vector>

namespace meetc::decisions_round {

// The type of the second operand; the first is always a sphere.
enum class other { sphere, segment, triangle, point };

struct emitted {
  std::string name;
  other second;
  bool surface;
  int inputs_a, inputs_b, atoms;

  // Each atom as a polynomial in the stored numbers: the emitted template run on polynomials. `numbers` has
  // the variables of the first operand's row, then of the second's.
  std::vector<polynomial> (*polynomials)(const poly::ring &numbers);
  // The same for the emitted bytecode, which wide integers run.
  std::vector<polynomial> (*step_polynomials)(const poly::ring &numbers);
  // Exact signs of the atoms: the emitted template run on rationals.
  std::vector<meetc::sign> (*signs)(const std::vector<rational> &row_a, const std::vector<rational> &row_b);
  // The staged decision (meetc::decide) over given signs; for the single sign, whether it is not negative.
  bool (*decide)(const meetc::sign *signs);
  // The parts of the staging; null for the single sign.
  bool (*rejected)(const meetc::sign *signs);
  bool (*needs_rare)(const meetc::sign *signs);
  bool (*usual)(const meetc::sign *signs);
  bool (*whole)(const meetc::sign *signs);
  // The value of the single sign; null for a predicate.
  meetc::sign (*value)(const meetc::sign *signs);
};

const std::vector<emitted> &emitted_predicates(); // six predicates and the single sign side(sphere, point)
const emitted &emitted_predicate(const std::string &name);

// The names of a predicate's stored numbers in the rings of the tests: "a0", ..., "b0", ...
std::vector<std::string> row_names(const emitted &e);

} // namespace meetc::decisions_round

#endif
