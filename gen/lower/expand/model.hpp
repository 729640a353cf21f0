// The meaning of a spec's algebra: the declared basis, the basis in which formulas are lowered, and the layout of each
// kind in memory.
#pragma once
#include "gen/algebra/multivector.hpp"
#include "gen/lang/spec.hpp"
#include "gen/poly/poly.hpp"

namespace meetc::lower {

using algebra::blade;
using algebra::metric;
using algebra::rational;
using multivector = algebra::multivector<poly::poly>;

// A basis blade by the names of its vectors, in the order of their product.
struct basis_blade {
  std::vector<std::string> vectors; // none: a scalar

  bool is_scalar() const { return vectors.empty(); }
  // "e1^e2^n"; "1" for the scalar.
  std::string text() const { return is_scalar() ? "1" : join(vectors, "^"); }
  bool operator==(const basis_blade &) const = default;
};
std::vector<basis_blade> named(const metric &m, const std::vector<blade> &blades);

// One stored number of a kind, in memory order.
struct stored_real {
  std::string path; // "c.x"
  int group = -1;   // the part (a point, a direction) to which it belongs, -1 for a bare real
  int axis = 0;     // its index in the group
  bool position = false;
};

struct kind_layout {
  const lang::kind *kind;
  std::vector<stored_real> reals;
  int groups = 0;
  int points = 0; // how many groups are positions
};

class model {
public:
  explicit model(const lang::algebra &a);

  const lang::algebra &spec() const { return spec_; }
  const metric &declared() const { return declared_; }
  const metric &working() const { return working_; }
  // Row i is the i-th declared vector in the working basis, or the reverse.
  const std::vector<std::vector<rational>> &to_working() const { return to_working_; }
  const std::vector<std::vector<rational>> &to_declared() const { return to_declared_; }
  // A multivector of the one basis in the other.
  multivector in_working(const multivector &m) const;
  multivector in_declared(const multivector &m) const;

  kind_layout layout(const lang::kind &k) const;
  const lang::kind &kind(const std::string &name, const location &where) const;

private:
  const lang::algebra &spec_;
  metric declared_, working_;
  std::vector<std::vector<rational>> to_working_, to_declared_;
};

} // namespace meetc::lower
