// The operators of the language by the oracle. The definitions are written a second time here.
#include "gen/lang/operators.hpp"
#include "gen/verify/dense_evaluator.hpp"

#include <stdexcept>

namespace meetc::verify {
namespace {
using oracle::multivector;
using oracle::rational;

bool is_odd(const multivector &m) {
  return oracle::is_zero(oracle::add(m, oracle::involute(m)));
}
} // namespace

// The constant I, or the outer product of all declared vectors where there is none.
multivector dense_evaluator::pseudoscalar() const {
  if (const lang::named_expr *c = spec_.find_constant("I"))
    return evaluate(*c->body, {});
  multivector all(dense_.size());
  all.back() = 1;
  return changed(all, declared_vectors_);
}

multivector dense_evaluator::complement(const multivector &m, bool right) const {
  const multivector declared = changed(m, coordinates_[1]), i = changed(pseudoscalar(), coordinates_[1]);
  return changed(right ? oracle::right_complement(declared, i) : oracle::left_complement(declared, i),
                 declared_vectors_);
}

multivector dense_evaluator::builtin(const lang::expr &e, const std::vector<multivector> &a) const {
  const oracle::dense_algebra &g = dense_;
  const std::string &name = e.text;
  const auto versor = [&](const multivector &v, const multivector &x) {
    return g.geometric(g.geometric(v, is_odd(v) ? oracle::involute(x) : x), oracle::reverse(v));
  };
  try {
    if (name == "rev")
      return oracle::reverse(a[0]);
    if (name == "involute")
      return oracle::involute(a[0]);
    if (name == "conj")
      return oracle::reverse(oracle::involute(a[0]));
    if (name == "grade")
      return oracle::grade_part(a[0], static_cast<int>(oracle::scalar_part(a[1]).get_d()));
    if (name == "scalar")
      return g.scalar(oracle::scalar_part(a[0]));
    if (name == "rc" || name == "lc")
      return complement(a[0], name == "rc");
    if (name == "regressive")
      return complement(oracle::outer(complement(a[0], true), complement(a[1], true)), false);
    if (name == "dual" || name == "undual") {
      const multivector i = pseudoscalar(), square = g.geometric(i, i);
      if (oracle::is_zero(square))
        return complement(a[0], name == "dual");
      return g.left_contraction(a[0], name == "undual" ? i : g.inverse(i));
    }
    if (name == "commutator")
      return oracle::scale(rational(1, 2), oracle::subtract(g.geometric(a[0], a[1]), g.geometric(a[1], a[0])));
    if (name == "dot")
      return g.symmetric_dot(a[0], a[1]);
    if (name == "sandwich")
      return versor(a[0], a[1]);
    if (name == "reflect")
      return versor(a[1], a[0]);
    if (name == "project")
      return g.geometric(g.symmetric_dot(a[0], a[1]), oracle::reverse(a[1]));
    if (name == "inverse")
      return g.inverse(a[0]);
    if (name == "rnorm2")
      return g.scalar(oracle::scalar_part(g.geometric(a[0], oracle::reverse(a[0]))));
  } catch (const std::domain_error &error) {
    throw spec_error(e.where, error.what());
  }
  throw spec_error(e.where, "the judge does not know this operator");
}

} // namespace meetc::verify
