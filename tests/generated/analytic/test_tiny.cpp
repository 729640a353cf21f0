// The stated errors of exp, log, sqrt, normalise and norm in arithmetic of 3 to 8 bits, for all numbers of a few exponents, and
// with a library whose sin, cos and atan2 err by up to one unit in the last place. The truth is the same function in double,
// which test_motions.cpp holds against 200 bits.
#include "tests/catch.hpp"

#include <cmath>
#include <cstdio>
#include <meetc/number/motion.hpp>
#include <random>
#include <vector>

namespace {

// Numbers of so many bits, with any exponent. Sums, products, quotients and roots are rounded to nearest, ties to even.
int bits = 4;
enum class library { nearest, below, above } rounding_of_library = library::nearest;

struct tiny {
  double v = 0;
  tiny() = default;
  explicit tiny(double x) : v(x) {}
  explicit operator double() const { return v; }
};

// x in units of its last place, rounded by `by`.
template <class By> double rounded(double x, By by) {
  if (x == 0 || !std::isfinite(x))
    return x;
  const int scale = bits - 1 - std::ilogb(x);
  return std::scalbn(by(std::scalbn(x, scale)), -scale);
}
tiny nearest(double x) {
  return tiny(rounded(x, [](double y) { return std::nearbyint(y); }));
}
tiny of_library(double x) {
  switch (rounding_of_library) {
  case library::below:
    return tiny(rounded(x, [](double y) { return std::floor(y); }));
  case library::above:
    return tiny(rounded(x, [](double y) { return std::ceil(y); }));
  default:
    return nearest(x);
  }
}

tiny operator+(tiny a, tiny b) {
  return nearest(a.v + b.v);
}
tiny operator-(tiny a, tiny b) {
  return nearest(a.v - b.v);
}
tiny operator*(tiny a, tiny b) {
  return nearest(a.v * b.v);
}
tiny operator/(tiny a, tiny b) {
  return nearest(a.v / b.v);
}
tiny operator-(tiny a) {
  return tiny(-a.v);
}
bool operator<(tiny a, tiny b) {
  return a.v < b.v;
}
bool operator>(tiny a, tiny b) {
  return a.v > b.v;
}
bool operator==(tiny a, tiny b) {
  return a.v == b.v;
}
tiny sqrt(tiny a) {
  return nearest(std::sqrt(a.v));
}
tiny sin(tiny a) {
  return of_library(std::sin(a.v));
}
tiny cos(tiny a) {
  return of_library(std::cos(a.v));
}
tiny atan2(tiny a, tiny b) {
  return of_library(std::atan2(a.v, b.v));
}
int ilogb(tiny a) {
  return std::ilogb(a.v);
}
tiny scalbn(tiny a, int n) {
  return tiny(std::scalbn(a.v, n));
}

using meetc::motion;

double length(const motion<double> &a, bool dual) {
  const double *of = dual ? a.w : a.u, first = dual ? a.p : a.s;
  return std::sqrt(first * first + of[0] * of[0] + of[1] * of[1] + of[2] * of[2]);
}
motion<double> difference(const motion<tiny> &a, const motion<double> &b) {
  motion<double> out{a.s.v - b.s, {}, a.p.v - b.p, {}};
  for (int i = 0; i < 3; ++i) {
    out.u[i] = a.u[i].v - b.u[i];
    out.w[i] = a.w[i].v - b.w[i];
  }
  return out;
}
motion<double> exact(const motion<tiny> &a) {
  motion<double> out{a.s.v, {}, a.p.v, {}};
  for (int i = 0; i < 3; ++i) {
    out.u[i] = a.u[i].v;
    out.w[i] = a.w[i].v;
  }
  return out;
}

// The largest part of a stated error that is seen. A bound that is five times as small would not hold.
struct worst {
  const char *what;
  double seen = 0;
  long cases = 0;
  void hold(double error, double stated) {
    ++cases;
    if (error > seen * stated)
      seen = stated > 0 ? error / stated : INFINITY;
  }
  void check() const {
    INFO(what);
    std::printf("%-24s %ld cases, at most %.2f of what is stated\n", what, cases, seen);
    CHECK(seen <= 1);
    CHECK(seen > 0.2);
  }
};

// 0 and, for each exponent, all numbers of so many bits, of both signs.
std::vector<double> numbers(std::initializer_list<int> exponents) {
  std::vector<double> out{0};
  for (const int e : exponents)
    for (int m = 1 << (bits - 1); m < 1 << bits; ++m)
      for (const int sign : {1, -1})
        out.push_back(sign * std::ldexp(m, e - (bits - 1)));
  return out;
}

class source {
public:
  tiny any() {
    return tiny(std::ldexp(static_cast<double>(static_cast<int>(random_() % (2U << bits)) - (1 << bits)),
                           static_cast<int>(random_() % 9) - 6));
  }
  std::size_t below(std::size_t n) { return random_() % n; }

private:
  std::mt19937 random_{1};
};

void dual_part(motion<tiny> &m, source &random) {
  m.p = random.any();
  for (tiny &x : m.w)
    x = random.any();
}

struct all_worst {
  worst exp_rotation{"exp"}, exp_dual{"exp, dual part"}, log_rotation{"log"}, log_dual{"log, dual part"},
      unit_rotation{"normalise"}, unit_dual{"normalise, dual part"}, sqrt_rotation{"sqrt"},
      sqrt_dual{"sqrt, dual part"}, norms{"norm"};

  void exponential(const motion<tiny> &b) {
    const double u = std::ldexp(1, -bits);
    const motion<double> in = exact(b), off = difference(meetc::motions::exp(b), meetc::motions::exp(in));
    motion<double> bivector = in;
    bivector.s = bivector.p = 0;
    const double angle = length(bivector, false);
    exp_rotation.hold(length(off, false), (8 + 4 * angle) * u);
    exp_dual.hold(length(off, true), (16 + 4 * angle) * u * length(bivector, true));
  }

  void versor(const motion<tiny> &v) {
    const double u = std::ldexp(1, -bits);
    const motion<double> in = exact(v);
    const double size = length(in, false), far = length(in, true);
    if (!(size > 0))
      return;
    const motion<double> off_unit = difference(meetc::motions::normalise(v), meetc::motions::normalise(in));
    unit_rotation.hold(length(off_unit, false), 8 * u);
    unit_dual.hold(length(off_unit, true), 16 * u * far / size);
    norms.hold(std::fabs(meetc::motions::norm(v).v - size), 4 * u * size);
    const motion<double> root = meetc::motions::sqrt(in), off_root = difference(meetc::motions::sqrt(v), root);
    sqrt_rotation.hold(length(off_root, false), 8 * u);
    sqrt_dual.hold(length(off_root, true), 12 * u * far / (size * root.s));
    const motion<double> log_in = meetc::motions::log(in), off_log = difference(meetc::motions::log(v), log_in);
    motion<double> turn = in;
    turn.s = 0;
    const double angle = length(log_in, false), turned = length(turn, false);
    log_rotation.hold(length(off_log, false), 12 * u * angle);
    log_dual.hold(length(off_log, true), 24 * u * far * (turned > 0 ? angle / turned : 1 / size));
  }

  void check() const {
    for (const worst *w : {&exp_rotation, &exp_dual, &log_rotation, &log_dual, &unit_rotation, &unit_dual,
                           &sqrt_rotation, &sqrt_dual, &norms})
      w->check();
  }
};

} // namespace

TEST_CASE("the stated errors of exp, log, sqrt, normalise and norm hold in tiny precisions") {
  all_worst seen;
  source random;
  for (const library l : {library::nearest, library::below, library::above}) {
    rounding_of_library = l;
    // All numbers of 3 bits with these exponents. The order and the signs of u change nothing but signs and an order.
    bits = 3;
    const std::vector<double> of = numbers({-5, -2, -1, 0, 1});
    for (std::size_t i = 0; i < of.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        for (std::size_t k = 0; k <= j; ++k) {
          motion<tiny> m{tiny(0), {tiny(of[i]), tiny(of[j]), tiny(of[k])}, tiny(0), {}};
          dual_part(m, random);
          seen.exponential(m);
          for (const double s : of) {
            m.s = tiny(s);
            seen.versor(m);
          }
        }
    for (bits = 4; bits <= 8; ++bits) {
      const std::vector<double> some = numbers({-bits, -2, -1, 0, 1, 2});
      for (int n = 0; n < 40000; ++n) {
        motion<tiny> m{tiny(some[random.below(some.size())]), {}, tiny(0), {}};
        for (tiny &x : m.u)
          x = tiny(some[random.below(some.size())]);
        dual_part(m, random);
        seen.exponential(m);
        seen.versor(m);
      }
    }
  }
  seen.check();
}
