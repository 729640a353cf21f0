// A decision on known signs as statements of a language that has no sets of signs: C, Python. Each truth that is not constant
// becomes a value b0, b1, ..., in the order of first use.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

#include <functional>
#include <map>
#include <string>

namespace meetc::target {

// The differences between the languages. A mask has the bits 1 negative, 2 zero, 4 positive.
struct truth_syntax {
  std::string yes, no;                                    // the constants
  std::function<std::string(const std::string &)> negate; // of a name
  std::string both, either;                               // operators, with their spaces
  std::function<std::string(const std::string &, const std::string &, const std::string &)> choose;
  std::function<std::string(const std::string &, const std::string &)> statement; // a name and its value
};

class truth_text {
public:
  // slot: of each atom, its place in sign[].
  truth_text(const lower::decision &d, const std::map<int, int> &slot, truth_syntax s);

  // The name or constant of a truth.
  std::string name(int id);
  // Whether one of the truths holds, as an expression.
  std::string any_of(const std::vector<int> &ids);
  // The statements so far.
  std::string take() { return std::move(before_); }

private:
  const lower::decision &d_;
  const std::map<int, int> &slot_;
  truth_syntax syntax_;
  std::map<int, std::string> names_;
  std::string before_;
  int next_ = 0;

  std::string keep(const std::string &text);
  std::string made(const lower::truth_node &n);
};

// "sign[0] * sign[3]" for a product of atoms; "0", "1" and "-1" where there are none.
std::string sign_product(const lower::sign_value &v, const std::map<int, int> &slot);

} // namespace meetc::target
