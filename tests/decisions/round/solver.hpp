// The same claims for a solver: SMT-LIB 2 scripts of nonlinear real arithmetic (QF_NRA), answered by z3.
#ifndef MEETC_TESTS_DECISIONS_ROUND_SOLVER_HPP
#define MEETC_TESTS_DECISIONS_ROUND_SOLVER_HPP

#include "tests/decisions/round/claim.hpp"

namespace meetc::decisions_round {

// A script that is unsatisfiable where what its name says is true.
struct query {
  std::string name, script;
};

// That the facts of a claim cannot all be true. Where the certificate is good, only the facts that it takes
// are asked about; how it takes them the solver does not see.
query query_of(const claim &c);
// Decision against geometry in one question, with no case made by hand: two spheres or balls; a ball or
// sphere and a segment. None for triangles, which took the solver more than minutes.
std::vector<query> whole_queries(const emitted &e, const decision &d);
// That a way from inside a triangle to a point that is not leaves it through an edge.
query way_out();

// "unsat", "sat", "unknown", "timeout" or what else the solver says; the script is kept in `folder`.
std::string answer(const query &q, const std::string &z3, const std::string &folder, int seconds);

} // namespace meetc::decisions_round

#endif
