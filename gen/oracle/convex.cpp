#include "gen/oracle/convex.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace meetc::oracle {
namespace {

using integer = mpz_class;
using vec = std::array<integer, 3>;
using corners = std::vector<vec>;

// ---- arithmetic that reuses its memory, since it takes nearly all of the time ----

void subtract(vec &out, const vec &a, const vec &b) {
  for (std::size_t k = 0; k < 3; ++k)
    mpz_sub(out[k].get_mpz_t(), a[k].get_mpz_t(), b[k].get_mpz_t());
}
void dot(integer &out, const vec &a, const vec &b) {
  mpz_mul(out.get_mpz_t(), a[0].get_mpz_t(), b[0].get_mpz_t());
  for (std::size_t k = 1; k < 3; ++k)
    mpz_addmul(out.get_mpz_t(), a[k].get_mpz_t(), b[k].get_mpz_t());
}

// Solves g t = h d for integers t and d > 0 by fraction-free elimination (E. H. Bareiss, 1968). Every division is
// exact, because minors of g are divided. g is a Gram matrix, so no pivot is negative, and a pivot of 0 means that g is
// singular. At most 3 by 3.
struct regular_system {
  integer g[3][4]; // h in column n
  integer t[3], d;

  // Returns false where g is singular.
  bool eliminate(std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      if (g[k][k] == 0)
        return false;
      for (std::size_t i = k + 1; i < n; ++i)
        for (std::size_t j = k + 1; j <= n; ++j) {
          mpz_ptr x = g[i][j].get_mpz_t();
          mpz_mul(x, x, g[k][k].get_mpz_t());
          mpz_submul(x, g[i][k].get_mpz_t(), g[k][j].get_mpz_t());
          if (k > 0)
            mpz_divexact(x, x, g[k - 1][k - 1].get_mpz_t());
        }
    }
    d = n == 0 ? integer(1) : g[n - 1][n - 1];
    return true;
  }
  // Computes t, from the last number to the first. Returns false as soon as one is negative.
  bool solve_nonnegative(std::size_t n) {
    for (std::size_t i = n; i-- > 0;) {
      mpz_ptr x = t[i].get_mpz_t();
      mpz_mul(x, d.get_mpz_t(), g[i][n].get_mpz_t());
      for (std::size_t j = i + 1; j < n; ++j)
        mpz_submul(x, g[i][j].get_mpz_t(), t[j].get_mpz_t());
      mpz_divexact(x, x, g[i][i].get_mpz_t());
      if (sgn(t[i]) < 0)
        return false;
    }
    return true;
  }
};

// ---- the quadratic programme ----

// The nearest points of two hulls of integer points.
class programme {
public:
  programme(const corners &a, const corners &b) : a_(a), b_(b) {}

  // Computes the square of the distance, as numerator and positive denominator.
  //
  // Why it is enough to try every subset of corners and to skip singular ones: the weights of the nearest points form a
  // polytope (their difference w is unique). At a corner of that polytope the corners of a and b in use have
  // independent directions, so their programme is regular, and its only stationary point is this one. More than three
  // directions in space are dependent.
  void solve(integer &numerator, integer &denominator) {
    for (unsigned i = 1; i < 1U << a_.size(); ++i)
      for (unsigned j = 1; j < 1U << b_.size(); ++j)
        if (stationary(i, j) && optimal()) {
          dot(numerator, w_, w_);
          denominator = system_.d * system_.d;
          return;
        }
    throw std::logic_error("two hulls without a distance"); // excluded by the argument above
  }

  // Calls f(numerators, denominator) for points of both hulls, among them all extreme points of their common part: there
  // the flats through some corners of a and through some of b, whose directions are independent, meet in one point.
  template <class F> void each_common(F &&f) {
    vec x;
    for (unsigned i = 1; i < 1U << a_.size(); ++i)
      for (unsigned j = 1; j < 1U << b_.size(); ++j)
        if (stationary(i, j) && w_[0] == 0 && w_[1] == 0 && w_[2] == 0) {
          for (std::size_t k = 0; k < 3; ++k) {
            x[k] = system_.d * (*start_a_)[k];
            for (std::size_t n = 0; n < of_a_; ++n)
              x[k] += system_.t[n] * directions_[n][k];
          }
          f(x, system_.d);
        }
  }

private:
  const corners &a_, &b_;
  const vec *start_a_ = nullptr; // the first of the corners of a in use, and the number of directions from it
  std::size_t of_a_ = 0;
  vec directions_[3], first_, w_;
  regular_system system_;
  integer square_, least_, most_, x_;

  // w / d = x - y, where x and y are the nearest points of the flats through these corners of a and of b, a stationary
  // point of |x - y|². Returns false where x and y are not unique, or where one lies outside its hull.
  bool stationary(unsigned in_a, unsigned in_b) {
    const vec *start_b = nullptr;
    std::size_t n = 0;
    start_a_ = nullptr;
    for (std::size_t i = 0; i < a_.size(); ++i)
      if (in_a >> i & 1) {
        if (!start_a_)
          start_a_ = &a_[i];
        else if (n == 3)
          return false;
        else
          subtract(directions_[n++], a_[i], *start_a_);
      }
    of_a_ = n;
    for (std::size_t i = 0; i < b_.size(); ++i)
      if (in_b >> i & 1) {
        if (!start_b)
          start_b = &b_[i];
        else if (n == 3)
          return false;
        else
          subtract(directions_[n++], *start_b, b_[i]);
      }
    subtract(first_, *start_a_, *start_b);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        dot(system_.g[i][j], directions_[i], directions_[j]);
        system_.g[j][i] = system_.g[i][j];
      }
      dot(system_.g[i][n], directions_[i], first_);
      mpz_neg(system_.g[i][n].get_mpz_t(), system_.g[i][n].get_mpz_t());
    }
    if (!system_.eliminate(n) || !system_.solve_nonnegative(n) || !first_weight_feasible(0, of_a_) ||
        !first_weight_feasible(of_a_, n))
      return false;
    for (std::size_t k = 0; k < 3; ++k) {
      mpz_mul(w_[k].get_mpz_t(), system_.d.get_mpz_t(), first_[k].get_mpz_t());
      for (std::size_t i = 0; i < n; ++i)
        mpz_addmul(w_[k].get_mpz_t(), system_.t[i].get_mpz_t(), directions_[i][k].get_mpz_t());
    }
    return true;
  }

  // The weights of the points of one side must not be negative. The weights add up to 1, which gives the first.
  bool first_weight_feasible(std::size_t begin, std::size_t end) {
    x_ = system_.d;
    for (std::size_t i = begin; i < end; ++i)
      x_ -= system_.t[i];
    return x_ >= 0;
  }

  // The optimality conditions of the whole programme: w is a difference of points of the hulls, and no difference of
  // corners lies further back along w. Then |w| is the distance, because the slab between two planes perpendicular to w
  // separates the hulls.
  bool optimal() {
    dot(square_, w_, w_);
    if (square_ == 0)
      return true;
    extreme(least_, a_, -1);
    extreme(most_, b_, 1);
    least_ -= most_;
    least_ *= system_.d;
    return least_ >= square_;
  }
  // The greatest (sign 1) or least (-1) dot product of w with a corner.
  void extreme(integer &out, const corners &points, int sign) {
    dot(out, w_, points[0]);
    for (std::size_t i = 1; i < points.size(); ++i) {
      dot(x_, w_, points[i]);
      if (sign * cmp(x_, out) > 0)
        mpz_swap(out.get_mpz_t(), x_.get_mpz_t());
    }
  }
};

// ---- from rationals to integers ----

// Multiplies all coordinates and pads by one common factor, then moves the points so that one of them is 0.
struct on_integers {
  corners a, b;
  integer pad_a, pad_b;
  rational factor;

  on_integers(const hull &x, const rational &pad_x, const hull &y, const rational &pad_y) {
    integer common = 1;
    const auto widen = [&](const rational &q) { mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), q.get_den_mpz_t()); };
    for (const hull *h : {&x, &y})
      for (const point &p : *h)
        std::for_each(p.begin(), p.end(), widen);
    widen(pad_x);
    widen(pad_y);
    integer rest;
    const auto scaled = [&](integer &out, const rational &q) {
      mpz_divexact(rest.get_mpz_t(), common.get_mpz_t(), q.get_den_mpz_t());
      mpz_mul(out.get_mpz_t(), rest.get_mpz_t(), q.get_num_mpz_t());
    };
    for (auto [to, from] : {std::pair(&a, &x), std::pair(&b, &y)}) {
      to->resize(from->size());
      for (std::size_t i = 0; i < from->size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
          scaled((*to)[i][k], (*from)[i][k]);
    }
    scaled(pad_a, pad_x);
    scaled(pad_b, pad_y);
    const vec origin = a[0];
    for (corners *c : {&a, &b})
      for (vec &p : *c)
        subtract(p, p, origin);
    // Common powers of two take time and change nothing.
    mp_bitcnt_t low = ~mp_bitcnt_t{0};
    each([&](const integer &c) { low = sgn(c) == 0 ? low : std::min(low, mpz_scan1(c.get_mpz_t(), 0)); });
    if (low == ~mp_bitcnt_t{0})
      low = 0;
    each([&](integer &c) { mpz_tdiv_q_2exp(c.get_mpz_t(), c.get_mpz_t(), low); });
    factor = rational(common) >> low;
  }

private:
  template <class F> void each(F &&f) {
    for (corners *c : {&a, &b})
      for (vec &p : *c)
        std::for_each(p.begin(), p.end(), f);
    f(pad_a);
    f(pad_b);
  }
};

void require_points(const hull &a) {
  if (a.empty())
    throw std::invalid_argument("the hull of no point");
}
void require_few_points(const hull &a, const hull &b) {
  require_points(a);
  require_points(b);
  if (a.size() > 16 || b.size() > 16)
    throw std::invalid_argument("the oracle tries every subset of corners: 16 points are too many already");
}

// For integer points.
integer greatest_square(const vec &p, const corners &a) {
  integer most, square;
  vec d;
  for (const vec &q : a) {
    subtract(d, p, q);
    dot(square, d, d);
    most = std::max(most, square);
  }
  return most;
}

} // namespace

point at(const rational &x, const rational &y, const rational &z) {
  return {x, y, z};
}

rational squared_distance(const hull &a, const hull &b) {
  require_few_points(a, b);
  const on_integers in(a, 0, b, 0);
  rational square;
  programme(in.a, in.b).solve(square.get_num(), square.get_den());
  square.canonicalize();
  return square / (in.factor * in.factor);
}

std::vector<point> common_part(const hull &a, const hull &b) {
  require_few_points(a, b);
  const on_integers in(a, 0, b, 0);
  std::vector<point> out;
  programme(in.a, in.b).each_common([&](const vec &x, const integer &d) {
    point p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = rational(x[k], d);
      p[k].canonicalize();
      p[k] = p[k] / in.factor + a[0][k];
    }
    if (std::find(out.begin(), out.end(), p) == out.end())
      out.push_back(std::move(p));
  });
  return out;
}

rational max_squared_distance(const point &p, const hull &a) {
  require_points(a);
  rational most = 0;
  for (const point &q : a) {
    rational square = 0;
    for (std::size_t k = 0; k < 3; ++k)
      square += (p[k] - q[k]) * (p[k] - q[k]);
    most = std::max(most, square);
  }
  return most;
}

bool touches(const hull &a, const rational &pad_a, const hull &b, const rational &pad_b, touch_mode mode) {
  if (pad_a < 0 || pad_b < 0)
    throw std::invalid_argument("a negative pad");
  const bool surfaces = mode == touch_mode::surface;
  if (surfaces && ((pad_a > 0 && a.size() != 1) || (pad_b > 0 && b.size() != 1)))
    throw std::invalid_argument("the surface of a padded hull is defined for one point only");
  require_few_points(a, b);
  const on_integers in(a, pad_a, b, pad_b);
  integer square, unit; // the square of the distance is square / unit
  programme(in.a, in.b).solve(square, unit);
  const integer sum = in.pad_a + in.pad_b, difference = in.pad_a - in.pad_b;
  if (square > sum * sum * unit)
    return false; // apart, in both modes
  if (!surfaces || sum == 0)
    return true;
  if (pad_a > 0 && pad_b > 0)
    return difference * difference * unit <= square;
  return sum * sum <= (pad_a > 0 ? greatest_square(in.a[0], in.b) : greatest_square(in.b[0], in.a));
}

} // namespace meetc::oracle
