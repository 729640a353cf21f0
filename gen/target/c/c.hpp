// C99: formulas, signs and plain predicates as functions in a header, certified ones as functions of the generated
// library.
//
// <space>/<space>.h compiles as C99 and as C++ with -pedantic, and needs only <math.h> and <stdbool.h>. Every name
// begins with the namespace: cga_sphere (double), cga_spheref (float), cga_meet_sphere_line, cga_meet_sphere_linef.
// Predicates and signs take operands stored in float32. <space>/<space>_c.cpp holds the certified and exact answers, the
// plain ones in double-double, and the functions that are no polynomials, with C linkage, over the target cpp.
#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

std::vector<file> c_files(const unit &u);
// The part of the header for one kernel, after the kinds that it needs.
std::string c_text(const unit &u, std::size_t kernel);
std::string c_analytic_text(const unit &u, std::size_t kernel);

// ---- the parts ----

// A number type of C: the suffix of names, the type, its fma and its literals.
struct c_number {
  const char *suffix, *type, *fma, *literal; // "f", "float", "fmaf", "f"
};
inline constexpr c_number c_numbers[] = {{"", "double", "fma", ""}, {"f", "float", "fmaf", "f"}};
// The macro by which formulas multiply and add: fma where it is an instruction, and a product and a sum elsewhere.
std::string c_multiply_add(const unit &u, const c_number &n);

std::string c_name(const unit &u, const std::string &name, const c_number &n);
// An operand's name, different from the names that functions use themselves.
std::string c_operand(const std::string &name);
// The statements of a program, with `input` for its inputs and `fma` for the function a b + c, followed by the results
// through `result`.
std::string c_body(const ir::program &p, const c_number &n, const std::string &fma,
                   const std::function<std::string(int)> &input,
                   const std::function<std::string(std::size_t, const std::string &)> &result);
std::string c_kinds(const unit &u);
std::string c_formula(const unit &u, const lower::kernel &k);
// Declarations and plain functions of a sign or predicate, for the header.
std::string c_decision(const unit &u, const lower::kernel &k);
// A function that is no polynomial: its declarations, and its definitions in the library.
std::string c_analytic(const unit &u, const lower::analytic_kernel &k);
std::string c_analytic_definitions(const unit &u, const lower::analytic_kernel &k);
// The functions with C linkage, over the target cpp.
std::string c_library(const unit &u);

} // namespace meetc::target
