// The operators that every algebra has. A function, predicate or kind hides the operator of its name.
//
// All are taken in `vectors`, the declared basis, so that a null basis changes no value. I is the constant I of the algebra
// where it is a multiple of the outer product of all vectors, and that product where the algebra declares no I.
#pragma once
#include "gen/lang/spec.hpp"

namespace meetc::lang {

// The effect of an operator: one of its own, or the value of an expression.
enum class operation {
  reverse,
  involute,
  conjugate,
  grade_part,
  scalar_part,
  right_complement,
  left_complement,
  dual,
  undual,
  dot,
  inverse,
  expression,
  of_versor, // an expression for an even first operand, and another one for an odd one
};

struct builtin {
  std::string name;    // "rev", as a call has it
  std::string form;    // "`rev(A)`, `~A`", as docs/spec.md lists it
  std::string formula; // of the same table
  operation does;
  std::vector<std::string> params;
  expr_ptr body = nullptr, odd_body = nullptr; // over the parameters

  bool needs_pseudoscalar() const;
};

const std::vector<builtin> &builtins();
const builtin *find_builtin(const std::string &name); // null: there is none

// Whether a call has the meaning of the operator of that name: the algebra declares no function, predicate or kind of it.
const builtin *called_builtin(const algebra &a, const expr &e);

// Throws: a call has another number of arguments than `want`.
[[noreturn]] void refuse_arguments(const expr &call, std::size_t want);

// The vectors of a basis blade that is written as one name: e31 is e3 ^ e1. Each is a declared or a null vector whose name
// ends in its only digit. Empty where the name is none.
std::vector<std::string> vectors_of_name(const algebra &a, const std::string &name);

} // namespace meetc::lang
