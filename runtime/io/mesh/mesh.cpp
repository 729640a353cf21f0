#include "meet/io/mesh/mesh.hpp"

#include "meet/core/threads/threads.hpp"
#include "meet/core/views/nouns.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/polygon/triangulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace meetc::io {

namespace {

// Moves vectors of all parts into those of the first one: the first step makes room, and the second copies one part's.
class joint {
public:
  explicit joint(const std::vector<mesh_part *> &parts) : parts_(parts) {}

  template <class T> void add(std::vector<T> &(*of)(mesh_part &)) {
    std::vector<std::size_t> start(parts_.size() + 1, 0);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      start[i + 1] = start[i] + of(*parts_[i]).size();
    std::vector<T> &all = of(*parts_.front());
    if (start.back() == all.size())
      return;
    std::vector<T> first = std::move(all);
    all.resize(start.back());
    std::ranges::copy(first, all.begin());
    copies_.emplace_back([this, of, &all, start = std::move(start)](std::size_t i) {
      std::vector<T> &from = of(*parts_[i]);
      std::ranges::copy(from, all.begin() + static_cast<std::ptrdiff_t>(start[i]));
      from = {};
    });
  }
  void copy(int threads) const {
    for_chunks(threads, parts_.size() - 1, 1, [&](int, std::size_t i, std::size_t) {
      for (const auto &one : copies_)
        one(i + 1);
    });
  }

private:
  const std::vector<mesh_part *> &parts_;
  std::vector<std::function<void(std::size_t)>> copies_;
};

template <vertex_lists mesh_part::*Lists> void add_lists(const std::vector<mesh_part *> &parts, joint &all) {
  if (std::ranges::any_of(parts, [&](mesh_part *p) { return !(p->*Lists).counts.empty(); })) {
    for (mesh_part *const p : parts)
      if (vertex_lists &l = p->*Lists; l.counts.empty())
        l.counts.assign(l.lists, static_cast<std::uint32_t>(l.common));
    all.add<std::uint32_t>([](mesh_part & p) -> auto & { return (p.*Lists).counts; });
  }
  all.add<std::uint32_t>([](mesh_part & p) -> auto & { return (p.*Lists).vertices; });
  for (std::size_t i = 1; i < parts.size(); ++i)
    (parts.front()->*Lists).lists += (parts[i]->*Lists).lists;
}

std::string several(std::size_t n, const char *one) {
  return n == 1 ? fmt::format("1 {}", one)
                : fmt::format("{} {}", n, std::string_view(one) == "vertex" ? "vertices" : plural_of(one));
}

struct holdings {
  std::size_t vertices, faces, lines, points;

  // "3 vertices, 1 line"; "nothing"
  std::string in_words() const {
    std::string out;
    for (const auto &[n, one] : {std::pair(vertices, "vertex"), std::pair(faces, "face"), std::pair(lines, "line"),
                                 std::pair(points, "point")})
      if (n > 0)
        out += fmt::format("{}{}", out.empty() ? "" : ", ", several(n, one));
    return out.empty() ? "nothing" : out;
  }
};

enum class part_of_file : std::uint8_t { faces, lines, points, vertices };

part_of_file chosen(const std::string &file, const holdings &has, bool vertices_are_points,
                    const std::vector<std::string> &notes, const read_request &q) {
  const std::string option = fmt::format("--kind-{}", q.side);
  const bool points = has.points > 0 || (vertices_are_points && has.vertices > 0);
  const part_of_file as_points = has.points > 0 ? part_of_file::points : part_of_file::vertices;
  const bool none = q.kind.empty();
  if (!none && q.kind != "triangle" && q.kind != "segment" && q.kind != "point")
    throw error(fmt::format("{}: {} {}: the file can hold triangle, segment or point", file, option, quote(q.kind)));
  if (has.faces > 0 && (none || q.kind == "triangle"))
    return part_of_file::faces;
  if (none && has.lines > 0 && has.points > 0)
    throw error(fmt::format("{}: it holds {} and {}; choose with {} segment or {} point", file,
                            several(has.lines, "line"), several(has.points, "point"), option, option));
  if (has.lines > 0 && (none || q.kind == "segment"))
    return part_of_file::lines;
  if (points && (none || q.kind == "point"))
    return as_points;
  std::string also;
  for (const std::string &note : notes)
    also += "; " + note;
  throw error(fmt::format("{}: no {} to collide; it holds {}{}", file,
                          none                   ? "faces, lines or points"
                          : q.kind == "triangle" ? "faces"
                          : q.kind == "segment"  ? "lines"
                                                 : "points",
                          has.in_words(), also));
}

std::string left_out(const holdings &has, part_of_file used) {
  const holdings beside{0, used == part_of_file::faces ? 0 : has.faces, used == part_of_file::lines ? 0 : has.lines,
                        used == part_of_file::points ? 0 : has.points};
  if (beside.faces + beside.lines + beside.points == 0)
    return {};
  return fmt::format("left out beside the {}: {}",
                     used == part_of_file::faces   ? "faces"
                     : used == part_of_file::lines ? "lines"
                                                   : "points",
                     beside.in_words());
}

// Segments between consecutive vertices of each line.
void cut_lines(vertex_lists &&lines, element_set &set) {
  set.items = lines.lists;
  if (lines.counts.empty()) {
    set.index = std::move(lines.vertices);
    return;
  }
  const std::uint32_t *v = lines.vertices.data();
  for (std::size_t i = 0; i < lines.lists; ++i, ++v)
    for (std::size_t k = 1; k < lines.count(i); ++k, ++v) {
      set.index.insert(set.index.end(), v, v + 2);
      set.owner.push_back(static_cast<std::uint32_t>(i));
    }
}

} // namespace

void join_parts(const std::vector<mesh_part *> &parts, int threads) {
  if (parts.size() < 2)
    return;
  joint all(parts);
  all.add<float>([](mesh_part & p) -> auto & { return p.xyz; });
  add_lists<&mesh_part::faces>(parts, all);
  add_lists<&mesh_part::lines>(parts, all);
  add_lists<&mesh_part::points>(parts, all);
  all.copy(threads);
  for (std::size_t i = 1; i < parts.size(); ++i)
    parts.front()->rounded.add(parts[i]->rounded);
}

element_set set_of(const std::string &file, mesh_part &&all, bool vertices_are_points,
                   const std::vector<std::string> &notes, const read_request &q) {
  const holdings has{all.xyz.size() / 3, all.faces.lists, all.lines.lists, all.points.lists};
  const part_of_file used = chosen(file, has, vertices_are_points, notes, q);
  element_set set;
  set.rounded = all.rounded;
  set.vertices = has.vertices;
  set.data = std::move(all.xyz);
  switch (used) {
  case part_of_file::faces:
    set.kind = &q.need(file, "triangle", 3, 9);
    cut_polygons(file, std::move(all.faces), q.by.threads, set);
    break;
  case part_of_file::lines:
    set.kind = &q.need(file, "segment", 2, 6);
    cut_lines(std::move(all.lines), set);
    break;
  case part_of_file::points:
    set.kind = &q.need(file, "point", 1, 3);
    set.items = all.points.lists;
    set.index = std::move(all.points.vertices);
    break;
  case part_of_file::vertices:
    set.kind = &q.need(file, "point", 1, 3);
    set.items = has.vertices;
  }
  set.elements = set.index.empty() ? set.items : set.index.size() / static_cast<std::size_t>(set.kind->points);
  if (set.elements > most_elements)
    throw error(fmt::format("{}: {} {}; at most {} can be numbered", file, set.elements, plural_of(set.kind->name),
                            most_elements));
  if (const std::string note = left_out(has, used); !note.empty())
    set.notes.push_back(note);
  set.notes.insert(set.notes.end(), notes.begin(), notes.end());
  return set;
}

void check_rules(const element_set &set, const std::string &file, const char *item) {
  if (!set.kind->fault)
    return;
  std::vector<float> row(static_cast<std::size_t>(set.kind->fields));
  for (std::size_t i = 0; i < set.elements; ++i) {
    set.row(i, row.data());
    if (const char *const fault = set.kind->fault(row.data()))
      throw error(fmt::format("{}: {} {}: {}", file, item, set.owner_of(i), fault));
  }
}

} // namespace meetc::io
