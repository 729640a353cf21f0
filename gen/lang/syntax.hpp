// The expressions of a spec as a syntax tree. Every node knows its place in the file.
//
//   expr    = 'if' expr 'then' expr 'else' expr | or
//   or      = and { 'or' and }            and = not { 'and' not }          not = 'not' not | compare
//   compare = sum [ ('<' '<=' '==' '!=' '>=' '>') sum ]
//   sum     = product { ('+' '-') product }
//   product = wedge { ('*' '/') wedge }   (geometric product; division by a constant number only)
//   wedge   = unary { '^' unary } | unary { '|' unary } | unary { '&' unary }      (never mixed without parentheses)
//   unary   = ( '-' | '~' ) unary | postfix      postfix = primary { '.' name | '[' expr ']' }
//   args    = arg { ',' arg }             arg = expr | '*'      (a wildcard, for the kernels of a scene)
//   primary = number | name | name '(' args ')' | '(' expr ')' | '[' args ']'
//           | ('all' | 'any' | 'each') '(' name 'in' expr { ',' name 'in' expr } ':' expr ')'
#pragma once
#include "gen/support/source.hpp"

#include <memory>
#include <string>
#include <vector>

namespace meetc::lang {

enum class op {
  number,
  name,
  call,
  member,
  index,
  list,
  negate,
  add,
  subtract,
  multiply,
  divide,
  outer,
  inner,
  builtin, // an operator of gen/lang/operators.hpp by its name in `text`, which no declaration hides: ~A and A & B
  less,
  less_equal,
  equal,
  not_equal,
  greater_equal,
  greater,
  logical_not,
  logical_and,
  logical_or,
  conditional,
  all,
  any,
  each
};

struct expr;
using expr_ptr = std::shared_ptr<const expr>;

struct binder {
  std::string name;
  expr_ptr over;
};

// args: operands in the written order. text: the number, name or member.
struct expr {
  op kind;
  location where;
  std::string text;
  std::vector<expr_ptr> args;
  std::vector<binder> binders; // for all, any, each
};

// The part of a file that holds an expression (a TOML literal string, or part of one).
struct expr_source {
  std::shared_ptr<const source_file> file;
  std::size_t begin, end;
};

// Parses a whole expression. Throws spec_error at the first error.
expr_ptr parse_expression(const expr_source &text);

// Parses text from the command line.
expr_ptr parse_expression(const std::string &text, const std::string &where);

std::string print(const expr &e);

} // namespace meetc::lang
