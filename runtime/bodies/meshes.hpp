// Procedural bodies: closed triangle meshes, spheres and segments for demonstrations, benchmarks and tests.
//
// Problem: a demonstration and a test need bodies that may be redistributed, that look like something, and that are the
// same everywhere, since counts of touching triangles are printed and compared.
// Method: grids wrapped around a curve, a divided icosahedron, and smooth unions of rounded cones meshed on a lattice
// by marching tetrahedra (Doi and Koide 1991), relaxed on the surface. Only + - * / and sqrt are used, in double, in a
// fixed order (sine and cosine are computed by series), then every coordinate is rounded to a multiple of 2^-16.
// Without contraction to fma (the project's flags) the bytes are therefore the same on every IEEE machine; with it the
// rounding hides nearly every difference.
// Limits: all bodies fit into [-2, 2]^3. Every mesh is a closed oriented manifold with outward normals, and free of
// zero-area triangles within the given ranges of parameters; parameters outside are clamped. y points up.
#ifndef MEETC_BODIES_MESHES_HPP
#define MEETC_BODIES_MESHES_HPP

#include "meet/bodies/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meetc::bodies {

// A unit sphere of 20 * 4^subdivisions triangles; subdivisions 0..8. Euler characteristic 2.
mesh icosphere(int subdivisions);

// A tube of radius 0.375 around a circle of radius 1 in the plane y = 0: 2 * segments * rings triangles, both 3..4096.
// Euler characteristic 0.
mesh torus(int segments, int rings);

// A tube of radius 0.25 around a (2, 3) torus knot: 2 * segments * rings triangles, segments 48..16384, rings 3..1024.
// Euler characteristic 0.
mesh knot(int segments, int rings);

// A spur gear with a bore about the axis z, coplanar sides and chamfers: 2 * (8 * teeth * detail) * (8 * detail)
// triangles, teeth 5..256, detail 1..16, which divides every step. Euler characteristic 0.
mesh gear(int teeth, int detail);

// A box of nx * ny * nz cubic cells of edge 2^-log2_cell about the origin, nx, ny and nz 1..1024, log2_cell 0..12: 4
// (nx ny + ny nz + nz nx) triangles. Coordinates are exact multiples of half a cell, so faces of blocks moved by
// multiples of it are exactly coplanar. Not confined to [-2, 2]. Euler characteristic 2.
mesh block(int nx, int ny, int nz, int log2_cell);

// A sitting long-eared animal, and a standing horned figure with a ribbed shell: smooth implicit bodies on a lattice of
// about `resolution` cells along the height, 48..320 (96 gives some 80,000 triangles). Euler characteristic 2.
mesh blob(int resolution);
mesh figure(int resolution);

// Cuts every triangle into four at the midpoints of its edges: the same surface with exactly four times the triangles.
// A midpoint is exact while the sums of coordinates fit into 24 bits, and otherwise rounded once. Triangles that share
// an edge by index still do.
mesh subdivide(const mesh &m);

// Rows x y z r: centres in [-1, 1)^3, radii between r_min and r_max, all multiples of 2^-16 (radii at least 2^-16).
std::vector<float> sphere_cloud(std::size_t n, std::uint64_t seed, double r_min, double r_max);

// Rows x0 y0 z0 x1 y1 z1: midpoints in [-1, 1)^3, uniform directions, and a fixed length up to rounding.
std::vector<float> segment_cloud(std::size_t n, std::uint64_t seed, double length);

} // namespace meetc::bodies

#endif
