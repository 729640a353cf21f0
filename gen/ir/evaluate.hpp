// The meaning of a program: its values for given numbers, and its polynomials. Both are exact.
#pragma once
#include "gen/ir/arena.hpp"

#include <optional>

namespace meetc::ir {

// The results as polynomials in the inputs. Every pass is checked by them: to_poly(pass(p)) == to_poly(p).
std::vector<poly::poly> to_poly(const program &p, const poly::ring &inputs);

// The same where expanding stays within some seconds, and nothing elsewhere. gen/ir/residue.hpp compares programs then.
std::optional<std::vector<poly::poly>> short_polys(const program &p, const poly::ring &inputs);

// The results for these inputs.
std::vector<rational> evaluate(const program &p, const std::vector<rational> &inputs);

} // namespace meetc::ir
