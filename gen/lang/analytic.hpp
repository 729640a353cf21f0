// The functions that are no polynomials. A scene asks for each as a kernel of its own, of one kind: 'exp(bivector)'. A
// function, predicate or kind that the algebra declares hides the one of its name.
#pragma once
#include "gen/lang/spec.hpp"

namespace meetc::lang {

struct analytic {
  const char *name, *form, *value; // "exp"; the others as docs/spec.md lists them
};

const std::vector<analytic> &analytics();

// The function that a call names; null where it is none of these.
const analytic *called_analytic(const algebra &a, const expr &e);

// Throws: the call stands where only polynomials do.
[[noreturn]] void refuse_analytic(const expr &call);

// Moves the kernels of a scene that are such calls to scene::analytic. gives(*) stands for every kind with a table
// [gives.KIND], of those in scene::kinds where the scene names kinds. Throws spec_error where there is none.
void take_analytic(scene &s);

} // namespace meetc::lang
