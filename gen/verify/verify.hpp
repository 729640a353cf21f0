// verify: compiled kernels, compared with the oracle.
//
//   formulas    with the dense 2^n product (gen/oracle/dense.hpp), in exact rationals
//   predicates  with exact convex feasibility of the operands' hulls (gen/oracle/convex.hpp), on small lattices
//               where about half of the cases are degenerate
#pragma once
#include "gen/lower/kernel.hpp"

namespace meetc::verify {

struct report {
  long cases = 0, wrong = 0;
  std::string first_wrong; // the first case that failed, in readable form
  std::string note;        // why nothing could be checked, or ""
  long degenerate = 0, hits = 0;
};

report verify_formula(const lower::model &m, const lower::kernel &k, long cases, unsigned seed);
// Compares one sign with the sign of the dense product.
report verify_sign(const lower::model &m, const lower::kernel &k, long cases, unsigned seed);
report verify_predicate(const lower::model &m, const lower::kernel &k, long cases, unsigned seed);

} // namespace meetc::verify
