#include "io/read.hpp"

#include "io/readers.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace meetc::io {

namespace {

const kind_info &find_triangle(const std::string &file, std::span<const kind_info *const> kinds) {
  for (const kind_info *const kind : kinds)
    if (std::string_view(kind->name) == "triangle" && kind->points == 3 && kind->fields == 9)
      return *kind;
  throw error(fmt::format("{}: a mesh needs a kind 'triangle' of three points, and there is none", file));
}

element_set dispatch(const std::filesystem::path &path, std::span<const kind_info *const> kinds,
                     const transform &move) {
  const std::string name = path.string();
  const std::string extension = lower_case(path.extension().string());
  using mesh_reader = element_set (*)(const file_bytes &, const kind_info &, const transform &);
  const mesh_reader mesh = extension == ".ply"   ? read_ply
                           : extension == ".obj" ? read_obj
                           : extension == ".stl" ? read_stl
                                                 : nullptr;
  if (mesh) {
    const kind_info &triangle = find_triangle(name, kinds);
    return mesh(load_file(path), triangle, move);
  }
  if (extension == ".csv")
    return read_csv(load_file(path), kinds, move);
  throw error(fmt::format("{}: {}; supported: .ply, .obj, .stl, .csv", name,
                          extension.empty() ? "the name has no extension"
                                            : fmt::format("unknown extension {}", quote(extension))));
}

} // namespace

element_set read(const std::filesystem::path &path, std::span<const kind_info *const> kinds, const transform &move) {
  move.check();
  try {
    return dispatch(path, kinds, move);
  } catch (const std::bad_alloc &) {
    throw error(fmt::format("{}: not enough memory to read it", path.string()));
  } catch (const std::length_error &) {
    throw error(fmt::format("{}: not enough memory to read it", path.string()));
  }
}

} // namespace meetc::io
