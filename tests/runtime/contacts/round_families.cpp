#include "tests/runtime/contacts/round_families.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace meetc::contacts_test {
namespace {

using random_numbers = std::mt19937;

int whole(random_numbers &r, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(r);
}
float uniform(random_numbers &r, float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(r);
}

// Numbers from `number`, radii from `radius`.
template <class Number, class Radius>
round_rows rows_of(random_numbers &r, std::size_t numbers, const Number &number, const Radius &radius) {
  round_rows out;
  for (float &x : out.ball)
    x = number(r);
  out.ball[3] = radius(r);
  for (std::size_t i = 0; i < numbers; ++i)
    out.other.push_back(number(r));
  if (numbers == 4)
    out.other[3] = radius(r);
  return out;
}
round_rows lattice(random_numbers &r, std::size_t numbers, int most) {
  return rows_of(
      r, numbers, [most](random_numbers &x) { return static_cast<float>(whole(x, -most, most)); },
      [most](random_numbers &x) { return static_cast<float>(whole(x, 0, most)); });
}
round_rows scaled(round_rows rows, int by) {
  for (float &x : rows.ball)
    x = std::ldexp(x, by);
  for (float &x : rows.other)
    x = std::ldexp(x, by);
  return rows;
}
// Moved by (x, y, z), rounded.
round_rows moved(round_rows rows, float x, float y, float z) {
  const std::array<float, 3> by{x, y, z};
  for (std::size_t k = 0; k < 3; ++k)
    rows.ball[k] += by[k];
  for (std::size_t i = 0; i < (rows.other.size() == 4 ? 3 : rows.other.size()); ++i)
    rows.other[i] += by[i % 3];
  return rows;
}
float any_number(random_numbers &r) {
  const auto bits = static_cast<std::uint32_t>(r());
  const auto x = std::bit_cast<float>(bits);
  return std::isfinite(x) ? x : 0;
}
// The point of the surface in a direction with a whole length.
void put_on_surface(random_numbers &r, const std::array<float, 4> &ball, float *at) {
  static constexpr int directions[5][4] = {{1, 2, 2, 3}, {2, 3, 6, 7}, {0, 3, 4, 5}, {1, 4, 8, 9}, {0, 0, 1, 1}};
  const int *const d = directions[whole(r, 0, 4)];
  const int turn = whole(r, 0, 2);
  for (int k = 0; k < 3; ++k)
    at[k] = ball[static_cast<std::size_t>(k)] +
            static_cast<float>(d[(k + turn) % 3] * (whole(r, 0, 1) ? 1 : -1)) * ball[3] / static_cast<float>(d[3]);
}

} // namespace

std::vector<round_family> round_families(std::size_t n) {
  const auto unit = [](random_numbers &r) { return uniform(r, -1, 1); };
  const auto positive = [](random_numbers &r) { return uniform(r, 0, 1); };
  const float top = std::numeric_limits<float>::max();
  std::vector<round_family> out = {
      {"lattice", [n](random_numbers &r) { return lattice(r, n, 3); }},
      {"coarse lattice", [n](random_numbers &r) { return lattice(r, n, 1); }},
      {"lattice of 24 bits", [n](random_numbers &r) { return lattice(r, n, (1 << 24) - 1); }},
      {"subnormal lattice", [n](random_numbers &r) { return scaled(lattice(r, n, 3), -149); }},
      {"lattice at the top", [n](random_numbers &r) { return scaled(lattice(r, n, 3), 126); }},
      {"lattice far away", [n](random_numbers &r) { return moved(lattice(r, n, 3), 1000, -70000, 3e6F); }},
      {"general", [n, unit, positive](random_numbers &r) { return rows_of(r, n, unit, positive); }},
      {"far away",
       [n, unit, positive](random_numbers &r) { return moved(rows_of(r, n, unit, positive), 0, 12345, -1e6F); }},
      {"numbers of all sizes",
       [n](random_numbers &r) {
         return rows_of(r, n, any_number, [](random_numbers &x) { return std::fabs(any_number(x)); });
       }},
      {"the ends of the type",
       [n, top, unit](random_numbers &r) {
         return rows_of(
             r, n, [=](random_numbers &x) { return top * (whole(x, 0, 2) ? unit(x) : 1.0F); },
             [=](random_numbers &x) { return top * std::fabs(unit(x)); });
       }},
      {"large radius",
       [n, unit](random_numbers &r) {
         round_rows rows = rows_of(r, n, unit, [](random_numbers &x) { return std::ldexp(1.0F, whole(x, 2, 40)); });
         rows.ball[0] = rows.ball[3];
         return rows;
       }},
      {"no radius, at a corner or in the middle",
       [n](random_numbers &r) {
         round_rows rows = lattice(r, n, 2);
         rows.ball[3] = 0;
         for (std::size_t k = 0; k < 3; ++k)
           rows.ball[k] = n == 4 || whole(r, 0, 3) == 0 ? rows.other[k] : (rows.other[k] + rows.other[k + 3]) / 2;
         return rows;
       }},
      {"a corner on the surface",
       [n](random_numbers &r) {
         round_rows rows = lattice(r, n, 20);
         rows.ball[3] = static_cast<float>(whole(r, 1, 3) * 315);
         put_on_surface(r, rows.ball, rows.other.data());
         if (n > 4 && whole(r, 0, 1))
           put_on_surface(r, rows.ball, rows.other.data() + 3);
         return rows;
       }},
  };
  if (n == 9) // two sides that enclose next to no angle
    for (const int bits : {0, 11})
      out.push_back({bits == 0 ? "narrow triangles" : "narrower triangles", [bits](random_numbers &r) {
                       round_rows rows = rows_of(
                           r, 9, [](random_numbers &x) { return uniform(x, -1, 1); },
                           [](random_numbers &x) { return uniform(x, 0.5F, 2); });
                       for (std::size_t k = 0; k < 3; ++k) {
                         // With few bits, the third corner would be on the line; one step moves it.
                         const float step = std::ldexp(1.0F, bits - 24), p = std::round(rows.other[k] / step) * step;
                         const float d = std::round(rows.other[3 + k] / step) * step;
                         rows.other[k] = p, rows.other[3 + k] = p + d, rows.other[6 + k] = p + d / 2;
                       }
                       rows.other[6] = std::nextafter(rows.other[6], 2.0F);
                       return rows;
                     }});
  if (n == 6) {
    out.push_back({"no length", [](random_numbers &r) {
                     round_rows rows = lattice(r, 6, 2);
                     for (std::size_t k = 0; k < 3; ++k)
                       rows.other[k + 3] = rows.other[k];
                     return rows;
                   }});
    // Through the centre and along an axis: the roots are sums of 25 bits, and of 54.
    for (const int apart : {0, 30})
      out.push_back(
          {apart == 0 ? "ties of float32" : "ties of float64", [apart](random_numbers &r) {
             const auto axis = static_cast<std::size_t>(whole(r, 0, 2));
             round_rows rows{{0, 0, 0, static_cast<float>(whole(r, 1 << 23, (1 << 24) - 1))}, std::vector<float>(6, 0)};
             rows.ball[axis] = std::ldexp(static_cast<float>(whole(r, 1 << 23, (1 << 24) - 1)), apart);
             rows.other[axis] = whole(r, 0, 1) ? 0 : 0x1p60F;
             rows.other[axis + 3] = rows.other[axis] == 0 ? 0x1p60F : -1;
             return rows;
           }});
    out.push_back({"tangent", [](random_numbers &r) { // to the surface, through (0, 0, r) from the centre
                     round_rows rows = lattice(r, 6, 9);
                     const float height = rows.ball[2] + rows.ball[3];
                     rows.other[0] = rows.ball[0] + 3 * static_cast<float>(whole(r, -2, 1)) - 1;
                     rows.other[1] = rows.ball[1] + 3 * static_cast<float>(whole(r, -2, 1)) - 1;
                     for (std::size_t k = 0; k < 2; ++k)
                       rows.other[3 + k] =
                           rows.ball[k] - (rows.other[k] - rows.ball[k]) * static_cast<float>(whole(r, 1, 3));
                     rows.other[2] = rows.other[5] = height;
                     return rows;
                   }});
  }
  return out;
}

} // namespace meetc::contacts_test
