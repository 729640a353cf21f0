// Common kernels of several polynomials: the programs of least price that a search finds for all of them at once.
//
// Problem: the outputs of a product of multivectors share sums such as s x + b z - c y, up to a factor and a sign. A Horner
// scheme of each output alone sees none of them.
// Method: fast extraction of common divisors, as in multi-level logic synthesis (Brayton and McMullen 1982; Rajski and
// Vasudevamurthy 1992), here with signs and rational ratios. The quotients of each sum by each of its variables are
// intersected in pairs, in equal ratios; two or more common terms are a kernel, and so is a product of two variables that
// occurs twice. A kernel becomes a value wherever it occurs times a monomial. A beam search over extractions, priced by the
// Horner schemes of all sums (scheme.hpp), stops after some layers without gain.
// Limits: kernels are found where two quotients agree; cancellation between outputs is not. The work is bounded by counts, so
// that the same polynomials give the same program everywhere.
#pragma once
#include "gen/poly/scheme.hpp"

namespace meetc::poly {

// Outputs over leaves and values. No value depends on itself.
struct packed_system {
  std::vector<packed> outputs;
  std::vector<std::pair<int, packed>> values; // the variable, which scheme_table gave, and its definition

  // The definition of a value, or null for a leaf.
  const packed *definition(int variable) const;
};

// The price of what the outputs need: `estimated` by quick schemes.
long cost(const packed_system &s, scheme_table &in);
long estimated_cost(const packed_system &s, const scheme_table &in);

struct extraction_effort {
  int width = 3;    // of the beam
  int tried = 24;   // kernels for each system of the beam
  int patience = 3; // layers without gain
};
// The cheapest system found with the same outputs, `s` itself where none is cheaper.
packed_system extract_kernels(const packed_system &s, scheme_table &in, const extraction_effort &effort);

} // namespace meetc::poly
