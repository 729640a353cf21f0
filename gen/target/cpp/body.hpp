// Programs as C++ statements.
#pragma once
#include "gen/lower/kernel.hpp"

#include <functional>
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

// A program in three parts by residency: what object A alone decides, object B alone, and the pair.
struct parts {
  int fields_a = 0, fields_b = 0;
  std::string object_a, object_b, pair;
};
// `input` names the inputs; fields are f[i] where they are stored, fa[i] and fb[i] where they are read; results are values
// v[i], each with its remark. With `mixed`, values of degree 3 and more are of type W, the others of type T. A negative is
// never stored: what reads it negates.
parts split_body(const ir::program &p, const std::function<std::string(int)> &input, bool mixed,
                 const std::vector<std::string> &remarks, const std::string &indent);

// "27 multiplications, 17 additions"; fused multiply-adds count as one of each.
std::string count_text(const ir::counts &c);

// A polynomial with other variable names.
std::string poly_with_names(const poly::poly &p, const std::vector<std::string> &names);

// Breaks a long sum after operators, each line behind `prefix`.
std::string wrapped(const std::string &text, const std::string &prefix, std::size_t width = 110);

} // namespace meetc::target
