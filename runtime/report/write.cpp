#include "meet/report/write.hpp"

#include "meet/io/elements/words.hpp"
#include "meet/report/bytes.hpp"
#include "meet/report/detail.hpp"
#include "meet/report/empty_page.hpp"
#include "meet/report/surface.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace meetc::report {

namespace {

using json = nlohmann::ordered_json;

// The box around points in fp64, in which no difference of float32 numbers overflows.
struct extent_of_points {
  std::array<double, 3> lo, hi;
  bool empty = true;

  void add(const double *p, double radius = 0) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lo[axis] = empty ? p[axis] - radius : std::min(lo[axis], p[axis] - radius);
      hi[axis] = empty ? p[axis] + radius : std::max(hi[axis], p[axis] + radius);
    }
    empty = false;
  }
  std::array<double, 3> middle() const {
    if (empty)
      return {};
    return {lo[0] / 2 + hi[0] / 2, lo[1] / 2 + hi[1] / 2, lo[2] / 2 + hi[2] / 2};
  }
  double diagonal() const { return empty ? 0 : std::hypot(hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]); }
};

void add_element(extent_of_points &to, const picture::shape &s, std::size_t element) {
  const auto add = [&to](const float *p, float radius) {
    const double wide[] = {p[0], p[1], p[2]};
    to.add(wide, radius);
  };
  if (s.what == picture::form::triangles)
    for (std::size_t k = 0; k < 3; ++k)
      add(corner(s, element, k), 0);
  else if (s.what == picture::form::spheres)
    add(&s.rows[4 * element], s.rows[4 * element + 3]);
  else
    for (std::size_t k = 0; k < 2; ++k)
      add(&s.rows[6 * element + 3 * k], 0);
}

// The box of all elements, or of those of the items named.
extent_of_points around(const shape &s, const std::vector<std::uint8_t> *named = nullptr) {
  extent_of_points out;
  for (std::size_t e = 0; e < picture::elements(s.drawn); ++e)
    if (!named || (*named)[s.item_of(e)])
      add_element(out, s.drawn, e);
  return out;
}

double unit_of(double diagonal) {
  return diagonal > 0 ? std::ldexp(1.0, std::ilogb(diagonal)) : 1;
}

json colour(picture::colour c) {
  return {c.r, c.g, c.b};
}

json surface_in(const surface &s, byte_arrays &to) {
  return {{"lo", s.lo},
          {"step", s.step},
          {"count", s.points.size()},
          {"points", to.points(s.points)},
          {"faces", s.index.size() / 3},
          {"hits", s.hits},
          {"index", to.corners(s.index)}};
}

json detail_in(const detail &d, bool mesh, byte_arrays &to) {
  json out = {{"count", d.elements.size()},
              {"numbers", to.floats(d.numbers)},
              {"items", to.differences(d.items)},
              {"hit", to.bytes(d.hit)}};
  if (mesh)
    out["index"] = to.corners(d.index);
  return out;
}

json shape_in(const shape &s, std::span<const std::uint8_t> named, const placing &at, byte_arrays &to) {
  constexpr const char *forms[] = {"triangles", "spheres", "segments"};
  const bool mesh = s.drawn.what == picture::form::triangles;
  const std::vector<std::uint8_t> chosen = detailed(s, named);
  json out = {{"form", forms[static_cast<std::size_t>(s.drawn.what)]},
              {"name", s.drawn.name},
              {"counted", s.counted},
              {"items", s.items},
              {"hit", colour(s.drawn.hit_colour)},
              {"centre", at.centre},
              {"detail", detail_in(detail_of(s, chosen, at), mesh, to)}};
  if (mesh)
    out["surface"] = surface_in(surface_of(s.drawn, chosen), to);
  return out;
}

json contacts_in(const contact_lines &c, const placing &at, byte_arrays &to) {
  std::vector<float> numbers;
  numbers.reserve(c.points.size());
  for (std::size_t i = 0; i < c.points.size(); ++i)
    numbers.push_back(at.coordinate(c.points[i], i % 3));
  return {{"points", to.floats(numbers)},
          {"pieces", to.differences(c.pieces)},
          {"triangles", to.differences(c.triangles)},
          {"single", to.differences(c.single)}};
}

json pairs_in(std::span<const index_pair> pairs, byte_arrays &to) {
  std::vector<std::uint32_t> a, b;
  for (const index_pair p : pairs)
    a.push_back(p.a), b.push_back(p.b);
  return {{"count", pairs.size()}, {"a", to.differences(a)}, {"b", to.differences(b)}};
}

json frames_in(const std::vector<frame> &frames) {
  json out = json::array();
  for (const frame &f : frames) {
    json moved = json::array(), touching = json::array();
    for (const auto &[body, pose] : f.moved)
      moved.push_back({body, pose});
    for (const frame::touch &t : f.touching)
      touching.push_back({t.a, t.b, t.how});
    out.push_back({{"name", f.name}, {"moved", moved}, {"touching", touching}});
  }
  return out;
}

// The page with text in its two places. Text of a user stands in JSON alone, where no byte ends an element of HTML.
std::string filled(const std::string &header, const std::string &bytes) {
  const std::string_view page = empty_page();
  const std::size_t first = page.find(place_of_json), second = page.find(place_of_bytes);
  if (first == std::string_view::npos || second == std::string_view::npos || second < first)
    throw std::logic_error("the page has no place for data");
  std::string out;
  out.reserve(page.size() + header.size() + bytes.size());
  out += page.substr(0, first);
  out += header;
  out += page.substr(first + place_of_json.size(), second - first - place_of_json.size());
  out += bytes;
  out += page.substr(second + place_of_bytes.size());
  return out;
}

} // namespace

std::string as_html(const scene &s, const limits &most) {
  const listed_pairs listed = list_pairs(s, most);
  extent_of_points near, all;
  double diagonal = 0;
  std::vector<extent_of_points> extents;
  for (std::size_t i = 0; i < s.shapes.size(); ++i) {
    extents.push_back(around(s.shapes[i]));
    for (const auto &[box, to] : {std::pair{extents.back(), &all}, {around(s.shapes[i], &listed.named[i]), &near}})
      if (!box.empty)
        to->add(box.lo.data()), to->add(box.hi.data());
    diagonal = std::max(diagonal, extents.back().diagonal());
  }
  const bool stand = s.frames.empty(); // at their own coordinates: all shapes have one centre
  placing at{(near.empty ? all : near).middle(), unit_of(stand ? all.diagonal() : diagonal)};

  byte_arrays arrays;
  json shapes = json::array(), bodies = json::array();
  for (std::size_t i = 0; i < s.shapes.size(); ++i)
    shapes.push_back(
        shape_in(s.shapes[i], listed.named[i], stand ? at : placing{extents[i].middle(), at.unit}, arrays));
  for (const body &b : s.bodies)
    bodies.push_back({{"name", b.name},
                      {"shape", b.shape},
                      {"pose", b.pose},
                      {"base", colour(b.base.value_or(s.shapes[b.shape].drawn.base))}});
  json notes = s.notes;
  if (listed.count < s.pairs.size())
    notes.push_back(
        fmt::format("This page lists the first {} of {} pairs; faces of the others alone are rounded to 16 bits "
                    "here. The option --pairs writes all.",
                    io::grouped(listed.count), io::grouped(s.pairs.size())));
  json header = {{"title", s.title},
                 {"centre", at.centre},
                 {"unit", at.unit},
                 {"curve", colour(picture::palette::contact)},
                 {"facts", s.facts},
                 {"notes", notes},
                 {"shapes", shapes},
                 {"bodies", bodies},
                 {"pairs", pairs_in(s.pairs.first(listed.count), arrays)},
                 {"all_pairs", s.pairs.size()},
                 {"contacts", contacts_in(s.contacts, at, arrays)},
                 {"frames", frames_in(s.frames)}};
  std::string text = header.dump(-1, ' ', false, json::error_handler_t::replace);
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i))
    text.replace(i, 1, "\\u003c");
  return filled(text, arrays.as_text());
}

} // namespace meetc::report
