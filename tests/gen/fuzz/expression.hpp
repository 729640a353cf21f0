// Expressions of the spec language as the fuzzer draws them: trees that are printed for meetc and evaluated here, so that
// nothing is shared with its parser.
#ifndef MEETC_TESTS_FUZZ_EXPRESSION_HPP
#define MEETC_TESTS_FUZZ_EXPRESSION_HPP

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace meetc::fuzz {

enum class form {
  parameter,
  number,
  blade,
  negate,
  reverse,
  add,
  subtract,
  multiply,
  divide,
  outer,
  inner,
  regressive,
  coefficient,
  call
};

struct expression;
using expression_ptr = std::shared_ptr<const expression>;

// parameter: its index. number: its decimals in `text`. blade: the outer product of `vectors`, in this order, and as one name
// (e12) where `text` says so. divide: by a number or a blade. coefficient: parts[0][parts[1]]. call: of the function `text`;
// the second part of a call of `grade` is a number.
struct expression {
  form is;
  std::vector<expression_ptr> parts = {};
  std::string text = {};
  std::vector<std::string> vectors = {};
  int index = 0;
  bool brackets = false; // writes more parentheses than it must
};

expression_ptr parameter(int index);
expression_ptr call(const std::string &function, std::vector<expression_ptr> arguments);

// The text, with `names` for the parameters.
std::string print(const expression &e, const std::vector<std::string> &names);

// The number of nodes of the tree.
std::size_t size(const expression &e);

// Calls `visit` with each tree that has one part less: a node replaced by one of its parts, but not by a coefficient's blade, a
// divisor or a grade.
// Ends early where it returns true.
bool for_each_smaller(const expression_ptr &e, const std::function<bool(const expression_ptr &)> &visit);

} // namespace meetc::fuzz

#endif
