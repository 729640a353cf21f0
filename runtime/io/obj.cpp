// OBJ: the vertices and polygons of a Wavefront file. It is written by hand, since tinyobjloader silently accepts bad
// numbers, wrong indices and short faces. Statements that carry no polygon (normals, groups, materials, lines, …) are
// skipped. Those that would change the shape, and unknown ones, are refused, so that another kind of file with the
// extension .obj is not read as an empty mesh.
#include "io/error.hpp"
#include "io/mesh_builder.hpp"
#include "io/number.hpp"
#include "io/readers.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::io {

namespace {

constexpr std::string_view passed_over[] = {
    "vt", "vn", "vp",     "g",     "o",        "s",        "mg",  "usemtl",     "mtllib",    "usemap",
    "l",  "p",  "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj",
};

// A backslash at the end of a comment (in a path, say) does not continue it.
bool continues(std::string_view line) {
  return line.ends_with('\\') && line.find('#') == std::string_view::npos;
}

class obj_reader {
public:
  obj_reader(const file_bytes &file, const kind_info &triangle, const transform &move)
      : file_(file), lines_(file.text(), file.name), mesh_(triangle, move),
        target_(move.any() ? precision::float64 : precision::float32) {}

  element_set read() {
    std::string_view line;
    while (next_statement(line)) {
      const std::string_view key = take_word(line);
      if (key == "v")
        vertex(line);
      else if (key == "f" || key == "fo")
        face(line);
      else if (std::ranges::find(passed_over, key) == std::end(passed_over))
        fail(fmt::format("unknown or unsupported statement {}", quote(key)));
    }
    for (const forward &f : forward_)
      if (f.vertex >= mesh_.vertices())
        throw error(fmt::format("{}:{}: face {}: vertex {} does not exist; the file has {}", file_.name, f.line, f.face,
                                std::uint64_t{f.vertex} + 1, mesh_.vertices()));
    return mesh_.finish(file_.name);
  }

private:
  // A corner that names a vertex which has not been read yet.
  struct forward {
    std::uint32_t vertex;
    std::size_t line, face;
  };

  [[noreturn]] void fail(std::string_view message) const {
    throw error(fmt::format("{}:{}: {}", file_.name, start_, message));
  }

  // Reads the next line that holds a statement, joined with its continuation lines.
  bool next_statement(std::string_view &line) {
    while (lines_.next(line)) {
      start_ = lines_.number();
      if (continues(line)) {
        joined_.clear();
        bool more = true;
        while (more && continues(line)) {
          joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
          more = lines_.next(line);
        }
        if (!more)
          fail("the file ends after a backslash that continues the line");
        line = joined_.append(line);
      }
      line = line.substr(0, line.find('#'));
      if (!trim(line).empty())
        return true;
    }
    return false;
  }

  void vertex(std::string_view line) {
    const std::size_t number = mesh_.vertices();
    if (number == most_elements)
      fail(fmt::format("more than {} vertices", most_elements));
    // x y z may be followed by a weight, a colour or both.
    double values[8] = {};
    std::size_t count = 0;
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      if (count == 7)
        fail(fmt::format("vertex {}: more than 7 numbers", number));
      if (!parse_decimal(word, target_, values[count++]))
        fail(fmt::format("vertex {}: {} is not a number", number, quote(word)));
    }
    if (count < 3 || count == 5)
      fail(fmt::format("vertex {}: {} numbers; x y z, and perhaps a weight or a colour, were expected", number, count));
    mesh_.add_vertex({values[0], values[1], values[2]},
                     [&](std::string_view what) { fail(fmt::format("vertex {}: {}", number, what)); });
  }

  // One of v, v/vt, v//vn, v/vt/vn. Only v is used, but the rest must be well formed.
  std::uint32_t corner(std::string_view word) {
    const std::string_view whole = word;
    std::int64_t v = 0;
    for (int part = 0; part < 3; ++part) {
      const std::size_t slash = word.find('/');
      const std::string_view text = word.substr(0, slash);
      const bool last = slash == std::string_view::npos;
      std::int64_t n = 0;
      const bool may_lack = part == 1 && !last;
      if (!(text.empty() && may_lack) && (!parse_integer(text, n) || n == 0))
        fail(fmt::format("face {}: {} is not a corner: v, v/vt, v//vn or v/vt/vn, each an index that is not 0",
                         mesh_.faces(), quote(whole)));
      if (part == 0)
        v = n;
      if (last)
        return resolve(v);
      word.remove_prefix(slash + 1);
    }
    fail(fmt::format("face {}: {} has more than three parts", mesh_.faces(), quote(whole)));
  }

  // Counts from 1 at the start of the file, or from -1 at the last vertex so far. A vertex may follow its face.
  std::uint32_t resolve(std::int64_t v) {
    const auto count = static_cast<std::int64_t>(mesh_.vertices());
    if (v < -count || v > static_cast<std::int64_t>(most_elements))
      fail(fmt::format("face {}: vertex {} does not exist; the file has {} so far", mesh_.faces(), v, count));
    const auto index = static_cast<std::uint32_t>(v < 0 ? count + v : v - 1);
    // The first index that is too large exceeds all before it, so keeping only new maxima is enough.
    if (v > count && (forward_.empty() || index > forward_.back().vertex))
      forward_.push_back({index, start_, mesh_.faces()});
    return index;
  }

  void face(std::string_view line) {
    corners_.clear();
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line))
      corners_.push_back(corner(word));
    if (corners_.size() < 3)
      fail(fmt::format("face {}: {} corners; a face has at least 3", mesh_.faces(), corners_.size()));
    if (!mesh_.add_face(corners_))
      fail(fmt::format("face {}: more than {} triangles", mesh_.faces(), most_elements));
  }

  const file_bytes &file_;
  line_reader lines_;
  std::size_t start_ = 1; // the first line of the statement
  std::string joined_;
  mesh_builder mesh_;
  precision target_;
  std::vector<std::uint32_t> corners_;
  std::vector<forward> forward_;
};

} // namespace

element_set read_obj(const file_bytes &file, const kind_info &triangle, const transform &move) {
  return obj_reader(file, triangle, move).read();
}

} // namespace meetc::io
