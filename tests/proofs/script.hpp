// A Gappa script as a program: its meaning, without Gappa and without the emitter.
#ifndef MEETC_TESTS_PROOFS_SCRIPT_HPP
#define MEETC_TESTS_PROOFS_SCRIPT_HPP

#include <gmpxx.h>
#include <map>
#include <string>
#include <vector>

namespace meetc::proofs_test {

using rational = mpq_class;

// The nearest float32, ties to even. |q| is in the range of the normal numbers, or 0.
float nearest_float(const rational &q);

struct leaf {
  std::string name, minuend, subtrahend; // subtrahend "": a stored number
};
struct line {
  std::string name, expression;
};

struct script {
  std::string kernel, stage;
  std::size_t sign = 0; // the first that the script covers; `leaves` is of this one
  std::vector<leaf> leaves;
  std::vector<line> lines; // in order; those of the goal are named v and e
  rational bound;

  // Values by name; scales (s0, s1, ...) are 1.
  std::map<std::string, rational> run(std::map<std::string, rational> values) const;
};

// Throws std::runtime_error for a script that it cannot parse.
script parse(const std::string &text);

// The signs that a script says it is about.
struct cover {
  std::string stage; // "ball_triangle common"
  std::vector<std::size_t> signs;
  std::string powers; // of c: "beta^3 D"
};
std::vector<cover> covers(const std::string &text);

} // namespace meetc::proofs_test

#endif
