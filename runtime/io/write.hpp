// Writers. Each file is there whole or not at all (atomic_file.hpp); io::error names it.
#ifndef MEETC_IO_WRITE_HPP
#define MEETC_IO_WRITE_HPP

#include "io/element_set.hpp"
#include "io/error.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

namespace meetc::io {

using rgb = std::array<std::uint8_t, 3>;

// A line `a,b`, then a row a pair, in the order given.
void write_pairs_csv(const std::filesystem::path &path, std::span<const index_pair> pairs);

// Binary little-endian PLY of triangles: float x y z a vertex, `list uchar int vertex_indices` a face, then
// uchar red green blue where there are colours: one a face, or none at all. `xyz` holds 3 floats a vertex,
// `index` 3 vertices a triangle.
void write_ply(const std::filesystem::path &path, std::span<const float> xyz, std::span<const std::uint32_t> index,
               std::span<const rgb> colours = {});

// The mesh with its own vertices and its own faces: what was fanned is one polygon again, and `colours` has
// one entry an item. The set is one of triangles.
void write_ply(const std::filesystem::path &path, const element_set &mesh, std::span<const rgb> colours = {});

} // namespace meetc::io

#endif
