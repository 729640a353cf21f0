// Decimals on a tie of two float32 numbers and just beside it, with every transform: they are rounded to float32 first, and
// then moved in double and rounded once, as the library moves float32 numbers.
#include "fixture.hpp"

#include "meet/core/views/moved_coordinate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

using namespace fixture;
using meetc::io::transform;

namespace {

// A decimal and the float32 nearest to it.
struct decimal {
  std::string text;
  float nearest;
};

// All digits of a double, which is a multiple of 2^-150.
std::string digits_of(double x) {
  char text[400];
  std::snprintf(text, sizeof text, "%.340e", x); // glibc prints them all
  return text;
}
// The same number, and what is less than 10^-60 of it above and below.
std::string beside(const std::string &digits, int side) {
  const std::size_t e = digits.find('e');
  std::string mantissa = digits.substr(0, e);
  mantissa.erase(mantissa.find_last_not_of('0') + 1); // it ends with a digit that is not 0, or with the point
  if (mantissa.back() == '.')
    mantissa += "0";
  mantissa.resize(std::max<std::size_t>(mantissa.size(), 60), '0');
  if (side > 0)
    mantissa += "1";
  if (side < 0) {
    std::size_t at = mantissa.find_last_not_of('0');
    while (mantissa[at] == '.' || mantissa[at] == '0')
      --at;
    --mantissa[at];
    for (std::size_t i = at + 1; i < mantissa.size(); ++i)
      if (mantissa[i] == '0')
        mantissa[i] = '9';
    mantissa += "9";
  }
  return mantissa + digits.substr(e);
}

decimal any_decimal(std::mt19937_64 &g) {
  // Neighbours f < next, of any size that neither a pose nor a sum takes beyond float32, and their middle.
  const bool subnormal = g() % 8 == 0;
  const auto bits = static_cast<std::uint32_t>(subnormal ? g() % 0x800000 : (0x01000000 + g() % 0x6c000000));
  const float f = std::bit_cast<float>(bits), next = std::bit_cast<float>(bits + 1);
  const double tie = (static_cast<double>(f) + static_cast<double>(next)) / 2;
  const int side = static_cast<int>(g() % 3) - 1;
  const bool up = side > 0 || (side == 0 && (bits & 1) != 0);
  const bool negative = g() % 2 == 0;
  return {(negative ? "-" : "") + beside(digits_of(tie), side), (up ? next : f) * (negative ? -1.0F : 1.0F)};
}

// The point as the library moves it: in double, in this order, rounded once.
std::array<float, 3> moved(const transform &by, const std::array<float, 3> &p) {
  std::array<double, 3> q = {p[0], p[1], p[2]};
  if (by.scale)
    for (double &c : q)
      c *= *by.scale;
  if (by.matrix) {
    const std::array<double, 3> r = q;
    for (std::size_t i = 0; i < 3; ++i)
      q[i] = meetc::moved_coordinate(by.matrix->data() + 4 * i, r[0], r[1], r[2]);
  }
  if (by.translate)
    for (std::size_t i = 0; i < 3; ++i)
      q[i] += (*by.translate)[i];
  return {static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2])};
}

std::vector<transform> transforms() {
  std::vector<transform> out(7);
  out[1].translate = {0, 0, 0};
  out[2].scale = 1;
  out[3].matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  out[4].translate = {0.1, -1, 1e-30};
  out[5].scale = 1 / 3.0, out[5].translate = {1, 2, 3};
  out[6].matrix = {0, -0.5, 0, 1, 0.5, 0, 0, 0.1, 0, 0, 0.5, 0}, out[6].scale = 0.7;
  return out;
}

std::string file_of(const std::string &name, const std::vector<decimal> &of) {
  const auto point = [&of](std::size_t i) { return of[i].text + " " + of[i + 1].text + " " + of[i + 2].text + "\n"; };
  const std::size_t points = of.size() / 3;
  std::string out;
  if (name == "a.csv") {
    out = "x0,y0,z0,x1,y1,z1\n";
    for (std::size_t i = 0; i < of.size(); ++i)
      out += of[i].text + (i % 6 == 5 ? "\n" : ",");
    return out;
  }
  if (name == "a.stl") {
    out = "solid s\n";
    for (std::size_t i = 0; i < points; i += 3) {
      out += "facet normal 0 0 0\nouter loop\n";
      for (std::size_t k = 0; k < 3; ++k)
        out += "vertex " + point(3 * (i + k));
      out += "endloop\nendfacet\n";
    }
    return out + "endsolid s\n";
  }
  if (name == "a.off") {
    out = "OFF\n" + std::to_string(points) + " 1 0\n";
    for (std::size_t i = 0; i < points; ++i)
      out += point(3 * i);
    return out + "3 0 1 2\n";
  }
  const bool ply = name != "a.obj";
  if (ply)
    out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points) +
          (name == "float.ply" ? "\nproperty float x\nproperty float y\nproperty float z\n"
                               : "\nproperty double x\nproperty double y\nproperty double z\n") +
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < points; ++i)
    out += (ply ? "" : "v ") + point(3 * i);
  return out + (ply ? "3 0 1 2\n" : "f 1 2 3\n");
}

} // namespace

TEST_CASE("decimals on and beside a tie are rounded to float32 before they are moved", "[transform]") {
  std::mt19937_64 random(77);
  for (const char *name : {"a.csv", "a.obj", "a.off", "a.stl", "float.ply", "double.ply"})
    for (const transform &by : transforms()) {
      std::vector<decimal> of;
      for (int i = 0; i < 1800; ++i)
        of.push_back(any_decimal(random));
      const meetc::io::element_set set = read(name, file_of(name, of), by);
      REQUIRE(set.data.size() == of.size());
      int wrong = 0;
      for (std::size_t i = 0; i < of.size(); i += 3) {
        const std::array<float, 3> want = moved(by, {of[i].nearest, of[i + 1].nearest, of[i + 2].nearest});
        for (std::size_t k = 0; k < 3; ++k)
          wrong += std::bit_cast<std::uint32_t>(want[k]) != std::bit_cast<std::uint32_t>(set.data[i + k]);
      }
      INFO(name << " " << by.options());
      CHECK(wrong == 0);
    }
}
