// Programs as C++ statements.
#pragma once
#include "gen/ir/count.hpp"
#include "gen/lower/kernel/kernel.hpp"

#include <functional>
#include <map>
#include <string>

namespace meetc::target {

// How a program reads its inputs and assigns its results.
struct body_names {
  std::function<std::string(int)> input;                               // from input number to expression
  std::function<std::string(std::size_t, const std::string &)> result; // from result number and value to statement
  std::string type = "T";
  // The functions of a b + c, rounded once everywhere, as the schedule of a predicate says, and of a constant.
  std::string fma = "meetc::fma", number = type;
};
// The names in a formula, whose type is any with +, - and *: a b + c is rounded as the target does it best.
body_names names_of_formula();
// Stands behind the parameters of a formula.
inline constexpr const char *throws_nothing = "noexcept(meetc::is_built_in<T>)";

// The whole program. Values that are used once are written where they are used.
std::string body(const ir::program &p, const body_names &names, const std::string &indent);

// Throws std::logic_error unless the statements of a formula on blades assign every coefficient of its result: "B.e1 = ...",
// or "return ..." for a number.
void check_whole(const lower::formula &f, const std::string &text);

// The values that a program stores beside the objects: statements that compute f[0], f[1], ..., and the expressions
// fa[i] and fb[i] by which the pair reads them.
struct stored_body {
  int fields_a = 0, fields_b = 0;
  std::string object_a, object_b;
  std::map<ir::node_id, std::string> read;
};
stored_body stored_parts(const ir::program &p, const body_names &names, const std::string &indent);

// The code that runs for each pair. With `mixed`, values of degree 3 and more have type W, the others names.type. A
// result's remark describes it; an empty list means no remarks.
std::string pair_body(const ir::program &p, const stored_body &stored, const body_names &names, bool mixed,
                      const std::vector<std::string> &remarks, const std::string &indent);

// "27 multiplications, 17 additions, 3 scalings by powers of two, 2 negations"; fused multiply-adds count as one of each, and
// the last two are left out where there are none.
std::string count_text(const ir::counts &c);

// "Within ((1 + u)^7 - 1) M of the exact value.", for a program whose values are wanted; see gen/bound/rounding_count.hpp.
std::string error_text(const ir::program &p);

// The assumptions of a program on blades, a line for each sentence; inputs: the names of the blades' coefficients.
std::vector<std::string> assumption_lines(const lower::assumptions &of, const std::vector<lower::basis_blade> &results,
                                          const std::vector<std::string> &inputs);

// A polynomial with these variable names.
std::string poly_with_names(const poly::poly &p, const std::vector<std::string> &names);

// Breaks a long sum at its operators; each line starts with `prefix`.
std::string wrapped(const std::string &text, const std::string &prefix, std::size_t width = 110);

} // namespace meetc::target
