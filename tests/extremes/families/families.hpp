// The hostile families: each makes a pair of rows for any two shapes to which it applies. Every row is finite and every
// radius >= 0. The declaration of each maker below says what its family tests.
#ifndef MEETC_TESTS_EXTREMES_FAMILIES_HPP
#define MEETC_TESTS_EXTREMES_FAMILIES_HPP

#include "subjects.hpp"

namespace meetc::extremes_test {

struct family {
  const char *name;
  bool (*applies)(shape a, shape b);
  pair_of_rows (*make)(shape a, shape b, random_numbers &random);
};
std::span<const family> families();
const family &family_named(const char *name);

// ---- makers ----

// Corners on integers whose orient3d determinants are -1, 0, 1, although their terms are 2^57 and more.
pair_of_rows determinant_one(shape a, shape b, random_numbers &random);

// Points around a line on a grid of one unit in the last place, embedded in planes of space.
pair_of_rows kettner(shape a, shape b, random_numbers &random);

// Corners on 2^-20 Z^3, the other's on sixteenths of them, 2^-24 off.
pair_of_rows near_coplanar(shape a, shape b, random_numbers &random);

// Spheres that touch corners, edges, faces and spheres exactly, and one ulp away from that.
pair_of_rows tangent(shape a, shape b, random_numbers &random);

// The cases of any_at_home at any power of two; subnormals, huge next to tiny numbers, any bit pattern.
pair_of_rows any_scale(shape a, shape b, random_numbers &random);

// The cases of any_at_home with corners and operands in another order.
pair_of_rows permuted(shape a, shape b, random_numbers &random);

// Shared corners and edges, duplicates, coplanar, collinear, flat and needle triangles.
pair_of_rows degenerate(shape a, shape b, random_numbers &random);

// A mesh against itself, as it is and moved by one ulp.
pair_of_rows mesh_on_itself(shape a, shape b, random_numbers &random);

// The cases of any_at_home at 1e4, 1e6, 1e7, rounded to float32.
pair_of_rows far(shape a, shape b, random_numbers &random);

// A power of two for each axis of the cases of any_at_home and placed: planes and lines stay, angles and spheres do
// not.
pair_of_rows axis_magnitudes(shape a, shape b, random_numbers &random);

// Every number is 0, a subnormal, the least normal, a small integer, a power of two or FLT_MAX, or a neighbour of one;
// of either sign.
pair_of_rows palette(shape a, shape b, random_numbers &random);

// A point placed exactly in a corner, an edge or the face of both bodies; half of them as they are, half with
// one number moved by one ulp.
pair_of_rows placed(shape a, shape b, random_numbers &random);

// The cases of placed before anything moves: closed sets that share that point, and lone signs that are 0.
pair_of_rows placed_exactly(shape a, shape b, random_numbers &random);

// Coordinates and radii within a factor of a few of FLT_MAX: differences overflow in float32.
pair_of_rows near_overflow(shape a, shape b, random_numbers &random);

// All points within a few ulps of one, at any exponent.
pair_of_rows cluster(shape a, shape b, random_numbers &random);

// Neighbours that share a corner or an edge bit for bit, coplanar except for one coordinate, moved by one ulp.
pair_of_rows bent(shape a, shape b, random_numbers &random);

// Points on small whole places at one subnormal height, now and then a step above or below it.
pair_of_rows flat_subnormal(shape a, shape b, random_numbers &random);

// Points of z = ax + by, for small a and b, with x and y over 26 binades.
pair_of_rows plane_binades(shape a, shape b, random_numbers &random);

// Whole coplanar points whose longest difference is within three steps of the longest for which the lanes of a predicate take
// doubles for exact, perhaps a step or two off their plane.
pair_of_rows at_exact_steps(shape a, shape b, random_numbers &random);

// An edge of 2^18 cells from one lattice point to another, through many, and corners on or beside these.
pair_of_rows long_lattice(shape a, shape b, random_numbers &random);

// One of the families above that keep their own scale and place.
pair_of_rows any_at_home(shape a, shape b, random_numbers &random);

// ---- parts of makers ----

using generated_test::graze;
using generated_test::padded;
using generated_test::points_of;
constexpr std::size_t corners(shape s) {
  return static_cast<std::size_t>(points_of(s));
}

// A point of Kettner's grid, moved to where its numbers are float32: version 0 is (1/2 + i 2^-24, 1/2 + j
// 2^-24) on the line through (12, 12) and (24, 24) where i = j; 1 has steps of 2^-53 and 2 of 2^-100, with
// the line moved by (-1/2, -1/2).
struct kettner_line {
  float step, base, q, r;
};
inline constexpr kettner_line kettner_lines[] = {
    {0x1p-24F, 0.5F, 12, 24}, {0x1p-53F, 0, 11.5F, 23.5F}, {0x1p-100F, 0, 11.5F, 23.5F}};

// Rows of a matrix of integers.
struct integer_rows {
  long v[3][3];
};
// Determinant 1, although its terms are about 2^57: naive fp32 and naive fp64 both get it wrong.
inline constexpr integer_rows known_rows = {
    {{36569, 5957284, 600211}, {-10110, 2276334, 232673}, {39676, 6450463, 649889}}};

// For each predicate on these shapes, the most steps for which doubles are exact.
std::span<const double> exact_limits(shape a, shape b);

// The faces of the built-in mesh, 9 numbers each.
std::span<const row> mesh_faces();

} // namespace meetc::extremes_test

#endif
