#include "tests/runtime/kernel/scenes.hpp"

#include <algorithm>
#include <cmath>

namespace meetc::matrix_test {
namespace {

using engine = std::mt19937_64;

double unit(engine &random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
} // [0, 1)
double within(engine &random, double low, double high) {
  return low + (high - low) * unit(random);
}
int whole(engine &random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

float finite(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -most, most));
}
float beside(float x, engine &random) {
  return random() % 2 ? std::nextafter(x, HUGE_VALF) : std::nextafter(x, -HUGE_VALF);
}

sphere random_sphere(engine &random, double size) {
  return {finite(within(random, -size, size)), finite(within(random, -size, size)), finite(within(random, -size, size)),
          finite(random() % 8 ? within(random, 0, size / 2) : 0)};
}

// A ball that touches s in some direction, as nearly as float32 can hold it, and sometimes one ulp away from that.
sphere tangent_to(const sphere &s, double r, engine &random) {
  static constexpr double directions[][3] = {
      {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {2.0 / 3, -2.0 / 3, 1.0 / 3}, {0.6, 0, 0.8}, {-2.0 / 7, 3.0 / 7, 6.0 / 7}};
  double d[3];
  const std::size_t which = random() % 8;
  if (which < 6) {
    std::copy_n(directions[which], 3, d);
  } else {
    double length = 0;
    for (double &x : d)
      x = within(random, -1, 1), length += x * x;
    for (double &x : d)
      x /= std::sqrt(length);
  }
  sphere out;
  out[3] = finite(r);
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = finite(s[k] + (static_cast<double>(s[3]) + static_cast<double>(out[3])) * d[k]);
  if (random() % 3 == 0) {
    float &x = out[random() % 4];
    x = finite(beside(x, random));
  }
  out[3] = std::max(out[3], 0.0F);
  return out;
}

void scale(scene &s, int exponent) {
  for (auto *set : {&s.owners, &s.others})
    for (sphere &x : *set)
      for (float &v : x)
        v = finite(std::ldexp(static_cast<double>(v), exponent));
}
void move(scene &s, double by, engine &random) {
  double t[3];
  for (double &x : t)
    x = random() % 3 ? by * (random() % 2 ? 1 : -1) : 0;
  for (auto *set : {&s.owners, &s.others})
    for (sphere &x : *set)
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = finite(static_cast<double>(x[k]) + t[k]);
}

scene at_random(engine &random) {
  scene out;
  for (int i = 0; i < 3; ++i) {
    out.owners.push_back(random_sphere(random, 1));
    out.others.push_back(random_sphere(random, 1));
  }
  return out;
}

// The frame is much wider than the balls that touch, so they are only a few of its steps wide.
scene tangent(engine &random) {
  scene out;
  const double frame = std::ldexp(1.0, whole(random, 0, 14));
  out.owners = {random_sphere(random, frame), random_sphere(random, frame), {}};
  out.owners[2] = random_sphere(random, random() % 2 ? frame : 1);
  for (const sphere &s : out.owners)
    out.others.push_back(tangent_to(s, random() % 4 ? within(random, 0, 1) : 0, random));
  return out;
}

// Touching exactly: all numbers are small multiples of 1/64.
scene on_a_lattice(engine &random) {
  scene out;
  for (int i = 0; i < 2; ++i) {
    sphere s, t;
    for (std::size_t k = 0; k < 3; ++k)
      s[k] = t[k] = static_cast<float>(whole(random, -64, 64)) / 64;
    s[3] = static_cast<float>(3 * whole(random, 0, 20)) / 64;
    t[3] = static_cast<float>(3 * whole(random, 0, 20)) / 64;
    if (random() % 2) {
      t[random() % 3] += s[3] + t[3];
    } else {
      const float third = (s[3] + t[3]) / 3;
      t[0] += 2 * third, t[1] -= 2 * third, t[2] += third;
    }
    if (random() % 4 == 0)
      t[3] = std::max(0.0F, beside(t[3], random));
    out.owners.push_back(s), out.others.push_back(t);
  }
  return out;
}

scene nested(engine &random) {
  scene out = at_random(random);
  for (std::size_t i = 0; i < out.owners.size(); ++i) {
    sphere &s = out.others[i] = out.owners[i];
    s[3] = finite(random() % 2 ? s[3] * within(random, 0, 1) : s[3] * within(random, 1, 100));
  }
  return out;
}

scene points(engine &random) {
  scene out;
  const double size = std::ldexp(1.0, whole(random, -20, 20));
  for (int i = 0; i < 2; ++i) {
    sphere s = random_sphere(random, random() % 2 ? size : 0);
    s[3] = 0;
    out.owners.push_back(s), out.others.push_back(s);
  }
  return out;
}

scene any_of_those(engine &random) {
  switch (random() % 5) {
  case 0:
    return at_random(random);
  case 1:
    return tangent(random);
  case 2:
    return on_a_lattice(random);
  case 3:
    return nested(random);
  default:
    return points(random);
  }
}

scene far(engine &random) {
  scene out = any_of_those(random);
  static constexpr double places[] = {1e4, 1e6, 1e7, 1e10};
  move(out, places[random() % 4], random);
  return out;
}
// Down to the last subnormal.
scene tiny(engine &random) {
  scene out = any_of_those(random);
  scale(out, whole(random, -156, -120));
  return out;
}
// Up to the largest float.
scene huge(engine &random) {
  scene out = any_of_those(random);
  scale(out, whole(random, 100, 129));
  return out;
}

// A small frame, and others of any size that touch it: many of them are astride.
scene astride(engine &random) {
  scene out = any_of_those(random);
  const std::size_t n = out.owners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double r = std::ldexp(within(random, 1, 2), whole(random, -10, 60));
    out.others.push_back(tangent_to(out.owners[i], r, random));
  }
  if (random() % 2)
    scale(out, whole(random, -130, 60));
  return out;
}

// Every number with an exponent of its own.
scene any_exponents(engine &random) {
  scene out;
  const auto number = [&] { return finite(std::ldexp(within(random, -2, 2), whole(random, -149, 127))); };
  for (int i = 0; i < 3; ++i) {
    out.owners.push_back({number(), number(), number(), std::fabs(number())});
    out.others.push_back({number(), number(), number(), std::fabs(number())});
    if (random() % 2)
      out.others.push_back(tangent_to(out.owners.back(), std::fabs(number()), random));
  }
  // One point, with radii that vanish next to its coordinates.
  if (random() % 4 == 0) {
    const float x = number();
    out.owners.assign(1,
                      {x, x, x, finite(std::fabs(static_cast<double>(x)) * std::ldexp(1.0, whole(random, -60, -20)))});
    out.others.assign(1, tangent_to(out.owners[0], std::fabs(static_cast<double>(x)), random));
    sphere beside_it = out.owners[0];
    beside_it[0] = finite(beside(x, random));
    for (const double step : {0.5, 1.0, 1.5}) { // it reaches that far back
      beside_it[3] = finite(std::fabs(static_cast<double>(beside_it[0]) - static_cast<double>(x)) * step);
      out.others.push_back(beside_it);
    }
  }
  return out;
}

template <class Ball> bool share_a_point(const Ball &a, const Ball &b) {
  mpq_class d2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const mpq_class d = mpq_class(static_cast<double>(a[k])) - mpq_class(static_cast<double>(b[k]));
    d2 += d * d;
  }
  const mpq_class reach = mpq_class(static_cast<double>(a[3])) + mpq_class(static_cast<double>(b[3]));
  return d2 <= mpq_class(reach * reach);
}

__extension__ typedef __int128 wide;

// A half times 2^24.
std::int64_t whole_of(std::uint16_t h) {
  return static_cast<std::int64_t>(std::ldexp(meetc::from_half(h), 24));
}

} // namespace

std::span<const family> families() {
  static const family all[] = {{"at random", at_random},
                               {"tangent", tangent},
                               {"on a lattice", on_a_lattice},
                               {"nested", nested},
                               {"points", points},
                               {"far", far},
                               {"tiny", tiny},
                               {"huge", huge},
                               {"astride", astride},
                               {"any exponents", any_exponents}};
  return all;
}

bool has_finite_box(const sphere &s) {
  float lo[3], hi[3];
  cga::sphere_shape::box(s.data(), lo, hi);
  return std::all_of(lo, lo + 3, [](float x) { return std::isfinite(x); }) &&
         std::all_of(hi, hi + 3, [](float x) { return std::isfinite(x); });
}

meetc::matrix_frame frame_around(const std::vector<sphere> &set) {
  meetc::interval around[3];
  for (const sphere &s : set)
    meetc::widen<cga::sphere_shape>(around, s.data());
  return meetc::frame_of(around);
}
meetc::placing place(const meetc::matrix_frame &frame, const sphere &s, meetc::cover c, ball &in_frame) {
  return meetc::place_element<cga::sphere_shape>(frame, c, s.data(), in_frame.data());
}

bool touch(const sphere &a, const sphere &b) {
  return share_a_point(a, b);
}
bool touch(const ball &a, const ball &b) {
  return share_a_point(a, b);
}

unit_result multiply(const columns &x, const columns &y) {
  wide sum = 0, size = 0; // times 2^48, below 2^77
  for (std::size_t k = 0; k < x.size(); ++k) {
    const wide t = static_cast<wide>(whole_of(x[k])) * whole_of(y[k]);
    sum += t, size += t < 0 ? -t : t;
  }
  sum *= 1 << 23, size *= 17;
  return {sum + size < 0, sum - size >= 0};
}

} // namespace meetc::matrix_test
