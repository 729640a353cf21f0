// The passes over every program between lowering and bounds, one line each, in this order.
//
// A pass takes a program and returns a program with the same results. After each, run() expands both into polynomials
// and compares them; this happens nowhere else. A difference is a defect of the compiler and throws std::logic_error.
// Error bounds are computed after the last pass, from the program that is emitted.
#pragma once
#include "gen/lower/analytic/analytic.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace meetc::passes {

struct pass {
  const char *name; // as in `meetc show --emit=after:NAME`
  const char *does; // one line: what it needs, keeps and improves
  ir::program (*run)(const ir::program &);
  std::optional<lower::use> only = {}; // runs only on programs of this use; on all where there is none
};

// All passes, first to last. "lower" is not among them: it is their input.
std::span<const pass> all();

// Runs the passes up to the one called `last` (all of them where it is empty, none for "lower"), and checks each.
// `inputs` is the ring of the program's inputs.
ir::program run(const ir::program &p, const poly::ring &inputs, const std::string &last = {},
                lower::use as = lower::use::once);

// The same for every program of a kernel, including those that compute blades.
void run(lower::kernel &k, const std::string &last = {});
void run(std::vector<lower::blade_maker> &makers);
void run(lower::analytic_kernel &k);

// Runs after the bounds are computed: magnitudes are programs too, and those of one object are stored by the same rule
// in the stages that run for most pairs.
void run(bound::kernel_bounds &b);

// "lower" and the names of all passes.
std::vector<std::string> names();

} // namespace meetc::passes
