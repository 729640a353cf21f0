// OBJ: the vertices, polygons, polylines and points of a Wavefront file. It is written by hand, since tinyobjloader
// silently accepts bad numbers, wrong indices and short faces. Statements that carry no geometry (normals, groups,
// materials, …) are skipped; those that no OBJ has, and free-form curves, are noted.
#include "meet/io/files/error.hpp"
#include "meet/io/mesh/mesh.hpp"
#include "meet/io/mesh/obj_statements.hpp"
#include "meet/io/text/cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meetc::io {

namespace {

// The indices of a part that count from its own first vertex, since the file counts them from the last vertex so far.
struct relative_vertices {
  std::vector<std::size_t> at; // places in vertex_lists::vertices
  std::int64_t least = 0;      // of them; -1 is the vertex before the part's first
};

struct obj_part {
  mesh_part mesh;
  relative_vertices faces, lines, points;
  std::uint32_t greatest = 0; // of the indices that count from the start of the file
  bool any = false;           // whether there are indices from the start of the file
  skipped_statements skipped;
};

// Parses one piece. `alone`: the piece is the whole file, so that every index can be checked and messages name the
// line.
class obj_parser {
public:
  obj_parser(const text_file &text, std::string_view piece, bool alone, const misplaced *fault)
      : text_(text), c_(piece), alone_(alone), fault_(fault) {}

  obj_part parse() {
    if (alone_)
      if (const std::size_t nul = text_.whole().find('\0'); nul != std::string_view::npos)
        text_.fail(text_.whole().data() + nul, "a NUL byte, which no OBJ holds");
    while (!c_.done()) {
      c_.skip_blanks();
      start_ = c_.at;
      if (more())
        statement();
      if (*c_.at != '\n')
        c_.skip_line(); // a comment
      ++c_.at;
    }
    for (const forward &f : forward_)
      if (f.vertex >= vertices())
        text_.fail(f.at, fmt::format("{}: vertex {} does not exist; the file has {}", f.of, std::uint64_t{f.vertex} + 1,
                                     vertices()));
    return std::move(part_);
  }

private:
  // A corner that names a vertex which has not been read yet.
  struct forward {
    std::uint32_t vertex;
    const char *at;
    std::string of;
  };

  [[noreturn]] void fail(std::string_view message) const { text_.fail(start_, message); }
  std::size_t vertices() const { return part_.mesh.xyz.size() / 3; }

  void statement() {
    const char *const p = c_.at;
    const bool short_key = ends_word(p + 1);
    c_.at = p + 1;
    if (short_key && p[0] == 'v')
      return vertex();
    if (short_key && p[0] == 'f')
      return list("face", part_.mesh.faces, part_.faces, 3);
    if (short_key && p[0] == 'l')
      return list("line", part_.mesh.lines, part_.lines, 2);
    if (short_key && p[0] == 'p')
      return list("point", part_.mesh.points, part_.points, 1);
    c_.at = p;
    const std::string_view key = word();
    if (key == "fo")
      return list("face", part_.mesh.faces, part_.faces, 3);
    if (!part_.skipped.add(key, p))
      fail(fmt::format("unknown or unsupported statement {}", quote(key)));
    skip_statement();
  }

  // A backslash at the end of a line.
  static bool continues(const char *p) { return p[0] == '\\' && (p[1] == '\n' || (p[1] == '\r' && p[2] == '\n')); }

  // To the next word of the statement, over continued line ends. False at the end of the statement or at a comment.
  bool more() {
    for (;;) {
      c_.skip_blanks();
      if (!continues(c_.at))
        return *c_.at != '\n' && *c_.at != '#';
      c_.skip_line();
      if (++c_.at; c_.done())
        fail("the file ends after a backslash that continues the line");
    }
  }

  static bool ends_word(const char *p) { return cursor::space(*p) || *p == '#' || continues(p); }
  std::string_view word() {
    const char *const from = c_.at;
    while (!ends_word(c_.at))
      ++c_.at;
    return {from, static_cast<std::size_t>(c_.at - from)};
  }

  // A backslash at the end of a line with a comment continues nothing.
  void skip_statement() {
    for (;;) {
      const char *const from = c_.at;
      c_.skip_line();
      const char *last = c_.at;
      while (last > from && cursor::blank(last[-1]))
        --last;
      if (last == from || last[-1] != '\\' || !continues(last - 1) || std::find(from, last, '#') != last)
        return;
      if (c_.at + 1 == c_.end)
        fail("the file ends after a backslash that continues the line");
      ++c_.at;
    }
  }

  // x y z may be followed by a weight, a colour or both.
  void vertex() {
    const std::size_t number = vertices();
    if (number == most_elements)
      fail(fmt::format("more than {} vertices", most_elements));
    float p[3];
    std::array<std::string_view, 3> words;
    std::size_t count = 0;
    bool finite = true;
    for (rounded_numbers ignored; more(); ++count) {
      if (count == 7)
        fail(fmt::format("vertex {}: more than 7 numbers", number));
      float unused;
      float &to = count < 3 ? p[count] : unused;
      rounded_numbers &moved = count < 3 ? part_.mesh.rounded : ignored;
      const char *const from = c_.at;
      if (const char *const stop = read_decimal(from, to, moved); stop && ends_word(stop)) {
        c_.at = stop;
        continue;
      }
      const std::string_view text = word();
      if (!read_decimal_word(text, to, moved))
        fail(fmt::format("vertex {}: {} is not a number", number, quote(text)));
      if (count < 3)
        words[count] = text;
      finite = finite && (count >= 3 || std::isfinite(to));
    }
    if (count < 3 || count == 5)
      fail(fmt::format("vertex {}: {} numbers; x y z, and perhaps a weight or a colour, were expected", number, count));
    if (!finite)
      fail(fmt::format("vertex {}: {}", number, describe_non_finite_point(p, words)));
    if (fault_ && fault_->row == number)
      fail(fmt::format("vertex {}: {}", number, fault_->what));
    part_.mesh.xyz.insert(part_.mesh.xyz.end(), p, p + 3);
  }

  // Reads an index of at most 9 digits that is not 0; null: it is not one.
  static const char *short_index(const char *p, std::int64_t &n) {
    const bool negative = *p == '-';
    p += negative;
    std::uint64_t v = 0;
    const char *const first = p;
    p = decimal_detail::digits(p, v);
    n = negative ? -static_cast<std::int64_t>(v) : static_cast<std::int64_t>(v);
    return p - first <= 9 && v != 0 ? p : nullptr;
  }

  // One of v, v/vt, v//vn, v/vt/vn, perhaps with slashes at its end. Only v is used, but the rest must be well formed.
  std::int64_t corner(std::string_view of, std::size_t number) {
    std::int64_t v = 0, other = 0;
    const char *const from = c_.at;
    const char *p = short_index(from, v);
    for (int part = 1; p && part < 3 && *p == '/'; ++part)
      p = p[1] == '/' || ends_word(p + 1) ? p + 1 : short_index(p + 1, other);
    if (p && ends_word(p)) {
      c_.at = p;
      return v;
    }
    return long_corner(word(), of, number);
  }

  std::int64_t long_corner(std::string_view word, std::string_view of, std::size_t number) const {
    const std::string_view whole = word;
    std::int64_t v = 0;
    for (int part = 0; part < 3; ++part) {
      const std::size_t slash = word.find('/');
      const std::string_view text = word.substr(0, slash);
      std::int64_t n = 0;
      if (!(text.empty() && part > 0) && (!parse_integer(text, n) || n == 0))
        fail(fmt::format("{} {}: {} is not a corner: v, v/vt, v//vn or v/vt/vn, each an index that is not 0", of,
                         number, quote(whole)));
      if (part == 0)
        v = n;
      if (slash == std::string_view::npos)
        return v;
      word.remove_prefix(slash + 1);
    }
    fail(fmt::format("{} {}: {} has more than three parts", of, number, quote(whole)));
  }

  // An index counts from 1 at the start of the file, or from -1 at the last vertex so far. A vertex may follow its
  // face.
  void add_vertex(std::int64_t v, std::string_view of, std::size_t number, vertex_lists &to,
                  relative_vertices &relative) {
    const auto count = static_cast<std::int64_t>(vertices());
    if ((alone_ && v < -count) || v > static_cast<std::int64_t>(most_elements))
      fail(fmt::format("{} {}: vertex {} does not exist; the file has {} so far", of, number, v, count));
    if (v < 0) {
      relative.at.push_back(to.vertices.size());
      relative.least = std::min(relative.least, count + v);
      to.vertices.push_back(static_cast<std::uint32_t>(count + v)); // modulo 2^32 until the parts are joined
      return;
    }
    const auto index = static_cast<std::uint32_t>(v - 1);
    // The first index that is too large exceeds all before it, so keeping only new maxima is enough.
    if (alone_ && v > count && (forward_.empty() || index > forward_.back().vertex))
      forward_.push_back({index, start_, fmt::format("{} {}", of, number)});
    part_.greatest = std::max(part_.greatest, index);
    part_.any = true;
    to.vertices.push_back(index);
  }

  void list(std::string_view of, vertex_lists &to, relative_vertices &relative, std::size_t least) {
    const std::size_t number = to.lists, before = to.vertices.size();
    while (more())
      add_vertex(corner(of, number), of, number, to, relative);
    const std::size_t n = to.vertices.size() - before;
    if (n < least)
      fail(fmt::format("{} {}: {} {}; a {} has at least {}", of, number, n, least == 1 ? "vertices" : "corners", of,
                       least));
    if (least == 1) // each vertex of a statement p is a point
      for (std::size_t i = 0; i < n; ++i)
        to.end_list(1);
    else
      to.end_list(n);
  }

  const text_file &text_;
  cursor c_;
  bool alone_;
  const misplaced *fault_;
  const char *start_ = nullptr; // of the statement
  obj_part part_;
  std::vector<forward> forward_;
};

// A piece must not start inside a statement that a backslash continues. A backslash after a comment counts as well.
struct after_whole_statement {
  bool operator()(std::string_view, std::string_view before) const {
    before.remove_suffix(1);
    if (before.ends_with('\r'))
      before.remove_suffix(1);
    return !before.ends_with('\\');
  }
};

// Makes the parts' relative indices absolute. False if an index leads to no vertex.
bool resolve(std::vector<obj_part> &parts) {
  std::size_t vertices = 0;
  for (obj_part &p : parts) {
    for (const auto &[of, lists] : {std::pair(&p.faces, &p.mesh.faces), std::pair(&p.lines, &p.mesh.lines),
                                    std::pair(&p.points, &p.mesh.points)}) {
      if (of->least + static_cast<std::int64_t>(vertices) < 0)
        return false;
      for (const std::size_t i : of->at)
        lists->vertices[i] += static_cast<std::uint32_t>(vertices);
    }
    vertices += p.mesh.xyz.size() / 3;
  }
  return vertices <= most_elements &&
         std::ranges::all_of(parts, [&](const obj_part &p) { return !p.any || p.greatest < vertices; });
}

} // namespace

element_set read_obj(const file_bytes &file, const read_request &q) {
  text_file text(file, q.by);
  const auto parse = [&](std::string_view piece, std::size_t, bool alone) {
    return obj_parser(text, piece, alone, q.fault).parse();
  };
  std::vector<obj_part> parts;
  if (!q.fault)
    parts = parse_pieces<obj_part>(text, text.pieces(after_whole_statement()), parse);
  if (q.fault || (parts.size() > 1 && !resolve(parts)))
    parts = parse_pieces<obj_part>(text, {}, parse);
  std::vector<mesh_part *> meshes;
  for (obj_part &p : parts) {
    meshes.push_back(&p.mesh);
    if (&p != &parts.front())
      parts.front().skipped.add(p.skipped);
  }
  join_parts(meshes, q.by.threads);
  obj_part &all = parts.front();
  const std::vector<std::string> skipped = all.skipped.notes(text);
  return set_of(file.name, std::move(all.mesh), false, skipped, q);
}

} // namespace meetc::io
