// Functions that are no polynomials: what is read back from a blade, and the exponentials, logarithms, roots and poses of
// versors. Their values are numbers with roots, so no sign and no formula takes them.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

#include <array>
#include <optional>

namespace meetc::lower {

// The geometry that is read back from a blade, as steps. Variables are numbered: first the blade's coefficients, then the
// results of the steps, in order.
struct reading {
  enum class what {
    values,     // of polynomials
    reciprocal, // of one: 0, and the blade gives nothing, where it is 0
    root        // of one: 0, and the blade gives nothing real, where it is negative
  };
  struct step {
    what makes;
    program code;          // inputs: all variables
    std::vector<int> sets; // the variable of each result
    std::string text;
  };
  // A number, or an element of a kind by what it stores.
  struct entry {
    std::string name, text;
    const lang::kind *kind; // null: a number
    std::vector<int> numbers;
  };
  std::vector<std::string> variables;  // their names
  std::shared_ptr<poly::ring> numbers; // of the programs' inputs: the variables, and more that none reads
  std::vector<step> steps;
  std::vector<entry> entries;
};

// The numbers of a versor of motions of space as those of a dual quaternion s + u + J (p + w): s, u1, u2, u3, p, w1, w2, w3.
// Its units are -e2e3, -e3e1, -e1e2 and J = e1e2e3e0, for three vectors that square to 1 and one that squares to 0.
struct dual_number {
  std::optional<basis_blade> at; // none: the number is 0
  int sign = 1;                  // the coefficient is sign times the number
};
using dual_numbers = std::array<dual_number, 8>;

struct analytic_kernel {
  std::string text, function, name; // "exp(bivector)", "exp", "exp_bivector"
  location where;
  const lang::kind *kind = nullptr;
  std::optional<reading> read; // for gives; the others are of motions
  dual_numbers in, out;        // out: not for norm and pose
  const lang::kind *result_kind = nullptr;
  std::vector<basis_blade> result; // where there is no kind
  rational shift;                  // pose: the translation is shift (s w - p u + u x w) / (s^2 + u.u)
};

// Throws spec_error where the kind has no such function.
analytic_kernel compile_analytic(const model &m, const lang::expr &call);

reading compile_reading(const model &m, const lang::kind &k, const location &where);
void compile_motion(const model &m, analytic_kernel &k);
// The factor of the translation, for a versor that moves the algebra's points. Throws where it does not.
rational pose_shift(const model &m, const lang::kind &k, const std::array<std::optional<algebra::blade_term>, 8> &units,
                    const location &where);

} // namespace meetc::lower
