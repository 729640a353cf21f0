// Programs as statements of a C-like language: the domain of the fold with which targets write code.
//
// A node that is used once is written where it is used, as long as that stays readable; every other node becomes a
// constant: by the program's name, else t0, t1 and so on. The graph's order of operations and all its parentheses are kept.
#pragma once
#include "gen/ir/fold.hpp"

#include <functional>
#include <map>
#include <string>

namespace meetc::target {

// The differences between the languages.
struct syntax {
  std::string type; // of the constants: "T", "double"
  std::string fma;  // the function: "meetc::fma", "fmaf"; empty: a b + c is written
  std::function<std::string(const ir::rational &)> constant; // a literal that needs no parentheses
  std::function<std::string(int)> input;                     // an input's number to an expression without parentheses
  std::string indent;
  // With two types: for each node, whether its value has the wider type; the name of that type; and the function that
  // multiplies values of `type` and returns one of that type.
  std::vector<char> wide = {};
  std::string wide_type = {}, wide_product = {};
  // The statement that gives a value a name; by default "const TYPE NAME = VALUE;".
  std::function<std::string(const std::string &, const std::string &)> keep = {};
  // A program's name of a value as a name of the language that is none of its words; each gives another one.
  std::function<std::string(const std::string &)> local = {};
};

// An expression and how tightly it binds.
struct expression {
  std::string text;
  enum class binding { atom, product, sum } as = binding::atom;
};

class statements {
public:
  using value = expression;
  // For the nodes of p that the results need; `given` names the values that exist already.
  statements(const ir::program &p, const std::vector<ir::node_id> &results, syntax s,
             std::map<ir::node_id, std::string> given);

  // All statements, and the expressions of the results in order.
  struct text {
    std::string before;
    std::vector<std::string> results;
  };
  static text of(const ir::program &p, const syntax &s);
  static text of(const ir::program &p, const std::vector<ir::node_id> &results, const syntax &s,
                 const std::map<ir::node_id, std::string> &given = {});

  // ---- the domain ----
  value input(const ir::node_ref &, int number) const { return {syntax_.input(number)}; }
  value constant(const ir::node_ref &, const ir::rational &q) const { return {syntax_.constant(q)}; }
  std::optional<value> given(const ir::node_ref &at) const {
    const auto it = given_.find(at.id);
    return it == given_.end() ? std::nullopt : std::optional(expression{it->second});
  }
  value negate(const ir::node_ref &at, const value &x) const;
  value add(const ir::node_ref &at, const value &x, const value &y);
  value subtract(const ir::node_ref &at, const value &x, const value &y);
  value multiply(const ir::node_ref &at, const value &x, const value &y);
  value fused(const ir::node_ref &at, const value &x, const value &y, const value &z);

private:
  using binding = expression::binding;
  syntax syntax_;
  const std::map<ir::node_id, std::string> &names_;
  std::map<ir::node_id, std::string> given_;
  std::map<ir::node_id, int> uses_;
  std::string out_;
  int next_ = 0;

  value made(const ir::node_ref &at, value v);
  bool wide(ir::node_id id) const { return !syntax_.wide.empty() && syntax_.wide[static_cast<std::size_t>(id)]; }
  static std::string factor(const value &v) { return v.as == binding::atom ? v.text : '(' + v.text + ')'; }
  static std::string term(const value &v) { return v.as == binding::sum ? '(' + v.text + ')' : v.text; }
};

} // namespace meetc::target
