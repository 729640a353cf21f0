#include "meet/bench/truth/proved_distance.hpp"

#include <cga/ball_ball.hpp>
#include <cga/sphere_sphere.hpp>

#include <algorithm>
#include <cmath>

namespace meetc::bench {

namespace {

// Rounding of the few operations that follow is far below this.
constexpr double slack = 1 + 0x1p-40;

struct centres {
  double distance, radius_a, radius_b;
};
centres centres_of(const float *a, const float *b) {
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = static_cast<double>(b[k]) - static_cast<double>(a[k]);
    square += d * d;
  }
  return {std::sqrt(square), static_cast<double>(a[3]), static_cast<double>(b[3])};
}

double per_length(double error, double length) {
  return error == 0 ? 0 : length > 0 ? slack * error / length : HUGE_VAL;
}

// P's signs compare the distance with the sum of the radii and, from the second on, with their difference.
template <class P, class A> double proved(const float *a, const float *b) {
  using stage = typename P::common_stage;
  typename A::value v[stage::atoms];
  typename A::magnitude m[stage::atoms];
  bounded_signs<P, A>(a, b).template compute<stage>(v, m);
  const centres c = centres_of(a, b);
  double most = 0;
  for (int i = 0; i < stage::atoms; ++i) {
    const double value = static_cast<double>(leading(v[i])), magnitude = static_cast<double>(typename A::real(m[i]));
    if (!std::isfinite(value) || !std::isfinite(magnitude))
      return HUGE_VAL;
    const double error = static_cast<double>(A::template factor<stage>(i)) * magnitude;
    const double radii = i == 0 ? c.radius_a + c.radius_b : std::fabs(c.radius_a - c.radius_b);
    most = std::max(most, per_length(error, c.distance + radii));
  }
  return most;
}

template <class P> proved_distance by_rung(rung precision) {
  switch (precision) { // plain rungs use the fused multiply-add everywhere
  case rung::fp32:
    return proved<P, fp32_arithmetic<true>>;
  case rung::fp64:
    return proved<P, fp64_arithmetic<true>>;
  case rung::fp64x2:
    return proved<P, fp64x2_arithmetic<true>>;
  case rung::exact:
  case rung::certified:
  case rung::tolerant:
    break;
  }
  return nullptr;
}

} // namespace

proved_distance proved_distance_of(std::string_view predicate, rung precision) {
  if (predicate == "ball_ball")
    return by_rung<cga::ball_ball>(precision);
  if (predicate == "sphere_sphere")
    return by_rung<cga::sphere_sphere>(precision);
  return nullptr;
}

} // namespace meetc::bench
