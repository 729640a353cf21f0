// A second evaluation of a spec's expressions, with numbers, dense multivectors and the oracle's products, on given
// operands. It shares the syntax tree with the compiler, and nothing else.
#pragma once
#include "gen/lang/spec.hpp"
#include "gen/oracle/dense.hpp"

#include <array>
#include <functional>
#include <map>
#include <optional>

namespace meetc::verify {

// A value with its named parts: the stored parts of an operand, whose kind computes others. A list has items.
struct dense_value {
  oracle::multivector blade;
  std::map<std::string, dense_value> members;
  const lang::kind *kind = nullptr;
  std::vector<dense_value> items = {};
};
using dense_scope = std::map<std::string, dense_value>;

class dense_evaluator {
public:
  // The metric of the basis of evaluation, and in it the rows of the declared vectors and of the working ones, which are the
  // declared ones with the null vectors in place of those that they replace.
  dense_evaluator(const lang::algebra &a, const oracle::matrix &metric, const oracle::matrix &declared_vectors,
                  const oracle::matrix &working_vectors);

  // A sign is the number -1, 0 or 1, and a truth 0 or 1. Throws spec_error for a list.
  oracle::multivector evaluate(const lang::expr &e, const dense_scope &scope) const;

  bool truth(const lang::expr &e, const dense_scope &scope) const;
  // The decision of a predicate, by its `hit` alone.
  bool hit(const lang::predicate &p, const std::vector<dense_value> &operands) const;

  // An operand from its stored numbers, taken from `numbers` in memory order.
  dense_value operand(const lang::kind &k, const std::vector<oracle::rational> &numbers, std::size_t &next) const;
  dense_value blade(const lang::expr &body, const dense_scope &scope) const { return {evaluate(body, scope), {}}; }

  const oracle::dense_algebra &algebra() const { return dense_; }

private:
  const lang::algebra &spec_;
  oracle::dense_algebra dense_;
  oracle::matrix declared_vectors_;
  std::array<oracle::matrix, 2>
      coordinates_; // rows of the vectors of evaluation in the working and in the declared basis

  oracle::rational coefficient(const oracle::multivector &m, const oracle::multivector &along,
                               const lang::expr &index) const;
  dense_value value(const lang::expr &e, const dense_scope &scope) const;
  dense_value made(const lang::kind &k, std::map<std::string, dense_value> members) const;
  // A truth, or a list; nothing for other expressions.
  std::optional<dense_value> truth_value(const lang::expr &e, const dense_scope &scope) const;
  oracle::multivector pseudoscalar() const;
  oracle::multivector complement(const oracle::multivector &m, bool right) const;
  oracle::multivector builtin(const lang::expr &e, const std::vector<oracle::multivector> &arguments) const;
};

// A multivector on other vectors: vector i becomes row i.
oracle::multivector changed(const oracle::multivector &x, const oracle::matrix &rows);

} // namespace meetc::verify
