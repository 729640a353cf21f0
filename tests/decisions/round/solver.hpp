// The same claims for a solver: SMT-LIB 2 scripts of nonlinear real arithmetic (QF_NRA), answered by z3.
#ifndef MEETC_TESTS_DECISIONS_ROUND_SOLVER_HPP
#define MEETC_TESTS_DECISIONS_ROUND_SOLVER_HPP

#include "tests/decisions/round/claim.hpp"

namespace meetc::decisions_round {

// A script that is unsatisfiable if the statement of its name is true.
struct query {
  std::string name, script;
};

// States that the facts of a claim cannot all be true. If the certificate is valid, the script has only the facts
// that it uses; the solver does not see the certificate.
query query_of(const claim &c);
// The decision against geometry in one query, without cases made by hand: two spheres or balls; a ball or sphere
// and a segment. There is none for triangles, for which the solver needs more than minutes.
std::vector<query> whole_queries(const emitted &e, const decision &d);
// States that a way from a point inside a triangle to one outside leaves it through an edge.
query way_out();

// "unsat", "sat", "unknown", "timeout" or another answer of the solver; the script is kept in `folder`.
std::string answer(const query &q, const std::string &z3, const std::string &folder, int seconds);

} // namespace meetc::decisions_round

#endif
