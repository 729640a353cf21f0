// Programs as C++ statements.
#pragma once
#include "gen/ir/count.hpp"
#include "gen/lower/kernel.hpp"

#include <functional>
#include <map>
#include <string>

namespace meetc::target {

// How a program's inputs are read and its results are kept.
struct body_names {
  std::function<std::string(int)> input;                               // input number to an expression
  std::function<std::string(std::size_t, const std::string &)> result; // result number and value to a statement
  std::string type = "T";
};

// All of a program. Values that are used once are written where they are used.
std::string body(const ir::program &p, const body_names &names, const std::string &indent);

// What a program stores beside the objects: statements that fill f[0], f[1], ..., and how the pair reads them, fa[i] and
// fb[i].
struct stored_body {
  int fields_a = 0, fields_b = 0;
  std::string object_a, object_b;
  std::map<ir::node_id, std::string> read;
};
stored_body stored_parts(const ir::program &p, const std::function<std::string(int)> &input, const std::string &type,
                         const std::string &indent);

// What runs for each pair. With `mixed`, values of degree 3 and more are of type W, the others of names.type. A result's
// remark says what it is; no remarks: none has one.
std::string pair_body(const ir::program &p, const stored_body &stored, const body_names &names, bool mixed,
                      const std::vector<std::string> &remarks, const std::string &indent);

// "27 multiplications, 17 additions"; fused multiply-adds count as one of each.
std::string count_text(const ir::counts &c);

// A polynomial with other variable names.
std::string poly_with_names(const poly::poly &p, const std::vector<std::string> &names);

// Breaks a long sum after operators, each line behind `prefix`.
std::string wrapped(const std::string &text, const std::string &prefix, std::size_t width = 110);

} // namespace meetc::target
