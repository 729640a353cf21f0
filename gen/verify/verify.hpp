// verify: compiled kernels, compared with the oracle.
//
//   formulas    with the dense 2^n product (gen/oracle/dense.hpp), in exact rationals
//   predicates  by their `means`, with exact convex geometry of the operands' hulls (gen/oracle/bodies.hpp), on small
//               lattices where about half of the cases are degenerate; where an operand has no hull, with what the spec says
//               of dense products
//   settled     equal points that are said to settle a predicate, with the same geometry
#pragma once
#include "gen/lower/kernel/kernel.hpp"

namespace meetc::verify {

struct report {
  long cases = 0, wrong = 0;
  std::string first_wrong; // the first case that failed, in readable form
  std::string note;        // why nothing could be compared, where cases is 0
  long degenerate = 0, hits = 0;
  bool by_text = false; // compared with dense products of its own text, since a kind has no hull
};

report verify_formula(const lower::model &m, const lower::kernel &k, long cases, unsigned seed);
// Compares one sign with the sign of the dense product.
report verify_sign(const lower::model &m, const lower::kernel &k, long cases, unsigned seed);
report verify_predicate(const lower::model &m, const lower::kernel &k, long cases, unsigned seed);
// Makes the points of each set in bounds.settled_by equal, in `cases` pairs each: the oracle must find a hit in all.
report verify_settled(const lower::model &m, const lower::kernel &k, const bound::kernel_bounds &bounds, long cases,
                      unsigned seed);

} // namespace meetc::verify
