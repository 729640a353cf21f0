// exp, log, sqrt, normalise, norm and pose, as emitted for rotors of R(3), for motors of R(3,0,1), and for those of the
// conformal model, against 200 bits. The exact values come from power series and dense products, not from the formulas under
// test.
#include "tests/catch.hpp"
#include "tests/generated/analytic/wide.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <motors/motors.hpp>
#include <random>
#include <rigid/rigid.hpp>
#include <rotors/rotors.hpp>

using namespace meetc::generated_test;

namespace {

// Coefficients by the masks of e1, e2, e3 (squares 1) and e0 (square 0).
using dense = std::array<wide, 16>;

dense product(const dense &a, const dense &b) {
  dense out;
  for (unsigned i = 0; i < 16; ++i)
    for (unsigned j = 0; j < 16; ++j) {
      if ((i & j & 8) != 0 || a[i] == wide(0) || b[j] == wide(0))
        continue;
      int swaps = 0;
      for (unsigned k = 0; k < 4; ++k)
        if (j >> k & 1)
          swaps += __builtin_popcount(i >> (k + 1));
      out[i ^ j] = out[i ^ j] + (swaps % 2 ? -(a[i] * b[j]) : a[i] * b[j]);
    }
  return out;
}
dense reversed(dense a) {
  for (unsigned i = 0; i < 16; ++i)
    if (__builtin_popcount(i) % 4 >= 2)
      a[i] = -a[i];
  return a;
}
dense sum(const dense &a, const dense &b, const wide &factor) {
  dense out;
  for (unsigned i = 0; i < 16; ++i)
    out[i] = a[i] + factor * b[i];
  return out;
}
dense scaled(const dense &a, const wide &factor) {
  return sum({}, a, factor);
}
// The series of a small part, squared.
dense exponential(const dense &b) {
  constexpr int squarings = 24;
  const dense small = scaled(b, wide(std::ldexp(1, -squarings)));
  dense out, term;
  out[0] = term[0] = wide(1);
  for (int k = 1; k < 40; ++k) {
    term = scaled(product(term, small), wide(1) / wide(k));
    out = sum(out, term, wide(1));
  }
  for (int i = 0; i < squarings; ++i)
    out = product(out, out);
  return out;
}
// The length of the part without e0, or of the part with it.
wide length(const dense &a, bool dual) {
  wide out;
  for (unsigned i = 0; i < 16; ++i)
    if ((i >= 8) == dual)
      out = out + a[i] * a[i];
  return sqrt(out);
}
// 1/|V| for the dual number |V|.
dense over_norm(const dense &v) {
  const dense square = product(v, reversed(v));
  dense out;
  out[0] = wide(1) / sqrt(square[0]);
  out[15] = -(square[15] * out[0] / (square[0] * wide(2)));
  return out;
}

// ---- the blades of each algebra: a space knows its types, and the masks of their members in order ----

struct rotor_space {
  template <class T> using bivector = rotors::bivector_blade<T>;
  template <class T> using versor = rotors::rotor_blade<T>;
  static constexpr std::array<unsigned, 3> of_bivector{3, 5, 6};
  static constexpr std::array<unsigned, 4> of_versor{0, 3, 5, 6};
};
struct motor_space {
  template <class T> using bivector = motors::bivector_blade<T>;
  template <class T> using versor = motors::motor_blade<T>;
  static constexpr std::array<unsigned, 6> of_bivector{3, 5, 9, 6, 10, 12};
  static constexpr std::array<unsigned, 8> of_versor{0, 3, 5, 9, 6, 10, 12, 15};
};
struct rigid_space {
  template <class T> using bivector = rigid::bivector_blade<T>;
  template <class T> using versor = rigid::motor_blade<T>;
  static constexpr std::array<unsigned, 6> of_bivector{3, 5, 9, 6, 10, 12};
  static constexpr std::array<unsigned, 8> of_versor{0, 3, 5, 9, 6, 10, 12, 15};
};

// A blade is nothing but its coefficients.
template <class Blade, class T, std::size_t N> Blade blade_from(const std::array<T, N> &numbers) {
  static_assert(sizeof(Blade) == sizeof numbers);
  return std::apply([](const auto &...x) { return Blade{x...}; }, numbers);
}
template <class T, std::size_t N, class Blade> std::array<T, N> numbers_of(const Blade &b) {
  static_assert(sizeof(Blade) == N * sizeof(T));
  std::array<T, N> out;
  const T *from = reinterpret_cast<const T *>(&b);
  std::copy(from, from + N, out.begin());
  return out;
}
template <class T, std::size_t N>
dense dense_of(const std::array<T, N> &numbers, const std::array<unsigned, N> &masks) {
  dense out;
  for (std::size_t i = 0; i < N; ++i)
    out[masks[i]] = wide(numbers[i]);
  return out;
}

struct worst {
  const char *what;
  double seen = 0; // as a part of what is stated
  // error <= stated, which are lengths
  void hold(const wide &error, const wide &stated) {
    if (error == wide(0))
      return;
    REQUIRE(stated > wide(0));
    const auto part = static_cast<double>(error / stated);
    seen = part > seen ? part : seen;
    CHECK(part <= 1);
  }
  explicit worst(const char *name) : what(name) {}
  ~worst() { std::printf("%-48s at most %.2f of what is stated\n", what, seen); }
};

class source {
public:
  explicit source(unsigned seed) : random_(seed) {}
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  // A direction, some of whose components are small or 0.
  std::array<double, 3> direction() {
    std::array<double, 3> out{};
    while (std::hypot(out[0], out[1], out[2]) < 0.1)
      for (double &x : out)
        x = between(-1, 1) * (between(0, 1) < 0.2 ? 0 : between(0, 1) < 0.3 ? 1e-7 : 1);
    const double l = std::hypot(out[0], out[1], out[2]);
    for (double &x : out)
      x /= l;
    return out;
  }
  double angle(double most) {
    static const double from[] = {0, M_PI / 2, M_PI, 2 * M_PI, 10, 100};
    static const double by[] = {0, 1e-30, 1e-16, 1e-12, 1e-8, 1e-7, 1e-5, 1e-3, 0.1, 1};
    for (;;) {
      const double a = from[pick(6)] + (pick(2) ? 1 : -1) * by[pick(10)] * between(0.5, 2);
      if (a >= 0 && a <= most)
        return a;
    }
  }
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

private:
  std::mt19937 random_;
};

template <class T> constexpr double unit() {
  return std::numeric_limits<T>::epsilon() / 2;
}

template <class Space, class T> auto bivector(source &random, double angle) {
  std::array<T, Space::of_bivector.size()> out;
  const std::array<double, 3> l = random.direction();
  const double far = std::pow(10, random.between(-6, 3));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const unsigned mask = Space::of_bivector[i];
    out[i] = static_cast<T>(mask == 3   ? l[2] * angle
                            : mask == 5 ? -l[1] * angle
                            : mask == 6 ? l[0] * angle
                                        : far * random.between(-1, 1));
  }
  return out;
}

template <class Space, class T> void check_exp(const char *name) {
  worst rotation(name), dual("  its dual part");
  source random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto b = bivector<Space, T>(random, random.angle(200));
    const dense in = dense_of(b, Space::of_bivector), want = exponential(in);
    const auto have = numbers_of<T, Space::of_versor.size()>(exp(blade_from<typename Space::template bivector<T>>(b)));
    const dense off = sum(dense_of(have, Space::of_versor), want, wide(-1));
    const wide angle = length(in, false);
    rotation.hold(length(off, false), (wide(8) + wide(4) * angle) * wide(unit<T>()));
    dual.hold(length(off, true), (wide(16) + wide(4) * angle) * wide(unit<T>()) * length(in, true));
  }
}

// A versor near the exponential of a bivector, of any length and with an error in its dual part.
template <class Space, class T> auto versor(source &random) {
  const auto b = bivector<Space, double>(random, random.angle(3.2));
  auto exact = exponential(dense_of(b, Space::of_bivector));
  const double size = random.pick(2) ? 1 : std::pow(10, random.between(-8, 8));
  std::array<T, Space::of_versor.size()> out;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<T>(static_cast<double>(exact[Space::of_versor[i]]) * size);
  return out;
}

template <class Space, class T> void check_roots(const char *name) {
  using versor_blade = typename Space::template versor<T>;
  using wide_versor = typename Space::template versor<wide>;
  constexpr std::size_t all = Space::of_versor.size(), of_log = Space::of_bivector.size();
  std::printf("%s\n", name);
  worst log_rotation("  log"), log_dual("  log, dual part"), unit_rotation("  normalise"),
      unit_dual("  normalise, dual part"), sqrt_rotation("  sqrt"), sqrt_dual("  sqrt, dual part"), norms("  norm");
  source random(2);
  const wide u(unit<T>()), tiny(1e-45);
  for (int i = 0; i < 1500; ++i) {
    const auto numbers = versor<Space, T>(random);
    const versor_blade v = blade_from<versor_blade>(numbers);
    std::array<wide, all> wide_numbers;
    std::copy(numbers.begin(), numbers.end(), wide_numbers.begin());
    const wide_versor w = blade_from<wide_versor>(wide_numbers);
    const dense in = dense_of(numbers, Space::of_versor);
    const dense exact = product(in, over_norm(in)); // V / |V|
    const wide size = length(in, false), far = length(in, true);

    const auto unit_v = dense_of(numbers_of<T, all>(normalise(v)), Space::of_versor);
    unit_rotation.hold(length(sum(unit_v, exact, wide(-1)), false), wide(8) * u);
    unit_dual.hold(length(sum(unit_v, exact, wide(-1)), true), wide(16) * u * far / size);
    norms.hold(abs(wide(norm(v)) - size), wide(4) * u * size);

    // The root of 200 bits is proved by its square.
    const auto root = dense_of(numbers_of<wide, all>(sqrt(w)), Space::of_versor);
    const dense again = product(root, root);
    REQUIRE(length(sum(again, exact, wide(-1)), false) < tiny);
    REQUIRE(length(sum(again, exact, wide(-1)), true) < tiny * (wide(1) + far / size) / root[0]);
    REQUIRE(!(root[0] < wide(0)));
    const auto have_root = dense_of(numbers_of<T, all>(sqrt(v)), Space::of_versor);
    sqrt_rotation.hold(length(sum(have_root, root, wide(-1)), false), wide(8) * u);
    sqrt_dual.hold(length(sum(have_root, root, wide(-1)), true), wide(12) * u * far / (size * root[0]));

    // The logarithm of 200 bits is proved by its exponential.
    const auto log_w = dense_of(numbers_of<wide, of_log>(log(w)), Space::of_bivector);
    const wide angle = length(log_w, false);
    const dense back = exponential(log_w);
    REQUIRE(length(sum(back, exact, wide(-1)), false) < tiny);
    REQUIRE(length(sum(back, exact, wide(-1)), true) < tiny * (wide(1) + far / size) / root[0]);
    REQUIRE(angle < wide(3.1415926535897936));
    const auto have_log = dense_of(numbers_of<T, of_log>(log(v)), Space::of_bivector);
    dense rotor = in;
    rotor[0] = wide(0);
    const wide turned = length(rotor, false), factor = turned > wide(0) ? angle / turned : wide(1) / size;
    log_rotation.hold(length(sum(have_log, log_w, wide(-1)), false), wide(12) * u * angle);
    log_dual.hold(length(sum(have_log, log_w, wide(-1)), true), wide(24) * u * far * factor);
  }
}

} // namespace

TEST_CASE("exponentials are those of 200 bits, near 0 and near pi too") {
  check_exp<rotor_space, float>("exp, rotors, float");
  check_exp<rotor_space, double>("exp, rotors, double");
  check_exp<motor_space, float>("exp, motors, float");
  check_exp<motor_space, double>("exp, motors, double");
  check_exp<rigid_space, double>("exp, conformal motors, double");
}

TEST_CASE("logarithms, roots, norms and unit versors are those of 200 bits, near 0 and near pi too") {
  check_roots<rotor_space, float>("rotors, float");
  check_roots<rotor_space, double>("rotors, double");
  check_roots<motor_space, float>("motors, float");
  check_roots<motor_space, double>("motors, double");
  check_roots<rigid_space, double>("conformal motors, double");
}

TEST_CASE("where all directions would do, the versor of the same motion is taken, and no versor gives no number") {
  motors::motor_blade<double> turn{};
  turn.scalar = -1;
  turn.e1_e0 = 2; // a translation, at the sign at which no direction is left
  const auto b = log(turn);
  CHECK(b.e1_e2 == 0);
  CHECK(b.e1_e0 == -2);
  const auto half = sqrt(turn);
  CHECK(half.scalar == 1);
  CHECK(half.e1_e0 == -1);
  const motors::motor_blade<double> none{};
  CHECK(std::isnan(normalise(none).scalar));
  CHECK(std::isnan(log(none).e1_e0));
  CHECK(norm(none) == 0);
  double m[12];
  motors::pose(none, m);
  CHECK(std::isnan(m[3]));
}

TEST_CASE("a pose moves points as the versor does") {
  source random(3);
  const wide u(unit<double>());
  worst turned("pose, rotation"), moved("pose, translation");
  for (int i = 0; i < 500; ++i) {
    const auto numbers = versor<motor_space, double>(random);
    double m[12], c[12];
    motors::pose(blade_from<motors::motor_blade<double>>(numbers), m);
    const dense in = dense_of(numbers, motor_space::of_versor), v = product(in, over_norm(in));
    // The points at the origin and on the axes are planes' meets: e123 - x e023 - y e031 - z e012.
    for (int axis = 0; axis < 4; ++axis) {
      dense p;
      p[7] = wide(1);
      const unsigned at[] = {14, 13, 11};
      const int sign[] = {-1, 1, -1}; // of e2e3e0, e1e3e0, e1e2e0
      if (axis < 3)
        p[at[axis]] = wide(sign[axis]);
      const dense to = product(product(v, p), reversed(v));
      for (int row = 0; row < 3; ++row) {
        const wide x = to[at[row]] * wide(sign[row]),
                   have = wide(m[4 * row + 3]) + wide(axis < 3 ? m[4 * row + axis] : 0);
        const wide far = length(in, true) / length(in, false);
        (axis < 3 ? turned : moved).hold(abs(have - x), wide(16) * u * (wide(axis < 3 ? 1 : 0) + wide(2) * far));
      }
    }
    // The conformal model has the same motions: its translation is that of a vector 2x + ... - nb.
    const auto conformal = versor<rigid_space, double>(random);
    rigid::pose(blade_from<rigid::motor_blade<double>>(conformal), c);
    double again[12];
    motors::pose(blade_from<motors::motor_blade<double>>(conformal), again);
    for (int k = 0; k < 12; ++k)
      CHECK(c[k] == (k % 4 == 3 ? -1 : 1) * again[k]);
  }
  // A quarter turn is exact, whatever the length of its rotor.
  rotors::rotor_blade<float> quarter{};
  quarter.scalar = 3;
  quarter.e1_e2 = -3;
  double m[12];
  rotors::pose(quarter, m);
  const double want[] = {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
  for (int k = 0; k < 12; ++k)
    CHECK(m[k] == want[k]);
}
