// Writers. Each writes its file whole or not at all (atomic_file.hpp) and throws io::error that names it.
#ifndef MEETC_IO_WRITE_HPP
#define MEETC_IO_WRITE_HPP

#include "meet/io/elements/element_set.hpp"
#include "meet/io/files/error.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace meetc::io {

using rgb = std::array<std::uint8_t, 3>;

// Writes a line `a,b`, then a row for each pair, in the given order.
void write_pairs_csv(const std::filesystem::path &path, std::span<const index_pair> pairs);
// The same with further columns: `names` follows "a,b" in the first line, and append(i, line) appends those of pair i, each
// after a comma.
void write_pairs_csv(const std::filesystem::path &path, std::span<const index_pair> pairs, std::string_view names,
                     const std::function<void(std::size_t i, std::string &line)> &append);

// Writes a binary little-endian PLY of triangles: float x y z for each vertex, `list uchar int vertex_indices` for each
// face, followed by uchar red green blue where there are colours (one for each face, or none at all). `xyz` holds 3
// floats for each vertex, `index` 3 vertices for each triangle.
void write_ply(const std::filesystem::path &path, std::span<const float> xyz, std::span<const std::uint32_t> index,
               std::span<const rgb> colours = {});

// Writes a mesh with its own vertices and faces: a polygon that was cut is one again, and `colours` has one entry for each
// item. The elements must be triangles.
void write_ply(const std::filesystem::path &path, const element_set &mesh, std::span<const rgb> colours = {});

} // namespace meetc::io

#endif
