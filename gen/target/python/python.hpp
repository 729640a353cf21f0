// Python: formulas, signs and plain predicates as functions of NumPy arrays, in one module without another dependency.
//
// <space>/<space>.py has a named tuple for each kind and for each blade, whose members are numbers or arrays that broadcast.
// A function computes all elements at once, in the arrays' own type; NumPy has no fused multiply-add, so products and sums are
// rounded one by one, as in C compiled without it.
#pragma once
#include "gen/target/statements.hpp"
#include "gen/target/target.hpp"

namespace meetc::target {

std::vector<file> python_files(const unit &u);
// The part of the module for one kernel, after the kinds that it needs.
std::string python_text(const unit &u, std::size_t kernel);

// ---- the parts ----

// A spec's name as a name in Python.
std::string python_name(const std::string &name);
// An operand's name, different from the names that the module and its functions use themselves.
std::string python_operand(const unit &u, const std::string &name);
// A member's name, different from the methods of the named tuples; and "c.x" with each part so named.
std::string python_member(const std::string &name);
std::string python_path(const std::string &path);
// The statements of a program, indented, and the expressions of its results.
statements::text python_body(const ir::program &p, const std::function<std::string(int)> &input);
// A named tuple of coefficients.
std::string python_blade_tuple(const std::string &type, const std::string &what,
                               const std::vector<lower::basis_blade> &blades);
std::string python_kinds(const unit &u);
std::string python_formula(const unit &u, const lower::kernel &k);
std::string python_decision(const unit &u, const lower::kernel &k);

} // namespace meetc::target
