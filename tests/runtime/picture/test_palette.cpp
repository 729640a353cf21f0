// Colours that stand beside each other differ, for readers with a dichromacy as well.
#include "meet/picture/palette.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace meetc::picture;

namespace {

using row = std::array<double, 3>;
using matrix = std::array<row, 3>;

// On linear RGB; severity 1 of Machado, Oliveira, Fernandes 2009: none, protanopia, deuteranopia, tritanopia.
constexpr std::array<matrix, 4> sights{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
}};

row times(const matrix &m, const row &v) {
  row out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out[i] += m[i][k] * v[k];
  return out;
}

// CIE L*a*b* of a colour as it is seen, for the white D65.
row lab(colour c, const matrix &sight) {
  const auto linear = [](std::uint8_t v) {
    const double s = v / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  row seen = times(sight, {linear(c.r), linear(c.g), linear(c.b)});
  for (double &v : seen)
    v = std::clamp(v, 0.0, 1.0);
  const row xyz = times({{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}}, seen);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f(xyz[0] / 0.95047), y = f(xyz[1]), z = f(xyz[2] / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// The least difference of two of the colours, for any sight. A difference of 2.3 is just noticeable.
double least_difference(const std::vector<colour> &colours) {
  double least = 1e300;
  for (const matrix &sight : sights)
    for (std::size_t i = 0; i < colours.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const row a = lab(colours[i], sight), b = lab(colours[k], sight);
        least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
      }
  return least;
}

constexpr double six_steps = 6 * 2.3;

} // namespace

TEST_CASE("palette: what touches, what does not, and contacts differ in any sight") {
  std::vector<colour> all(palette::calm.begin(), palette::calm.end());
  all.insert(all.end(), {palette::yellow, palette::vermilion, palette::contact});
  CHECK(least_difference(all) > six_steps);
  // Green and pink, which are one for deuteranopes, show that the simulation can fail.
  CHECK(least_difference({{150, 176, 158}, {255, 20, 137}}) < six_steps);
}

TEST_CASE("palette: curves differ from each other and from the paper") {
  std::vector<colour> all(palette::series.begin(), palette::series.end());
  all.insert(all.end(), {palette::paper, palette::ink});
  CHECK(least_difference(all) > six_steps);
}

TEST_CASE("palette: shares grow darker in any sight") {
  for (const matrix &sight : sights)
    for (std::size_t i = 1; i < palette::shares.size(); ++i)
      CHECK(lab(palette::shares[i].ink, sight)[0] < lab(palette::shares[i - 1].ink, sight)[0]);
}

TEST_CASE("palette: a colour as text") {
  CHECK(hexadecimal({0, 10, 255}) == "#000aff");
}
