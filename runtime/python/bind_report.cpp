#include "meet/core/contacts/contacts.hpp"
#include "meet/io/files/error.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/signals.hpp"
#include "meet/python/worlds.hpp"
#include "meet/report/bodies_page.hpp"
#include "meet/report/sets_page.hpp"

#include <cga/cga_runtime.hpp>

#include <string>
#include <tuple>

namespace meetc::python {

namespace {

// A set as Python has it: its kind, numbers, index, owner, number of items, pose and name, the count of numbers that float32
// moved and how far at most, and its notes.
using set_of_page = std::tuple<std::string, py::array, std::optional<py::array>, std::optional<py::array>, std::size_t,
                               std::optional<py::array>, std::string, std::uint64_t, double, std::vector<std::string>>;

// The elements where they are in their pose: the numbers that the answer is about.
io::element_set elements_of(const set_of_page &of) {
  const auto &[kind, numbers, index, owner, items, at, name, moved, largest, notes] = of;
  io::element_set out;
  out.kind = &kind_named(kind);
  const view v = view_of(*out.kind, numbers, index);
  const kind_info &row = index ? kind_named("point") : *out.kind;
  const auto fields = static_cast<std::size_t>(row.fields);
  out.data.reserve(v.vertices * fields);
  for (std::size_t i = 0; i < v.vertices; ++i) {
    const auto *const from =
        reinterpret_cast<const float *>(reinterpret_cast<const char *>(v.data) + i * v.stride_bytes);
    out.data.insert(out.data.end(), from, from + fields);
  }
  if (at)
    move_rows(row, place_of(*at, *out.kind), out.data.data(), v.vertices);
  if (index) {
    out.index.assign(v.index, v.index + v.elements * static_cast<std::size_t>(out.kind->points));
    out.vertices = v.vertices;
  }
  const std::span<const std::uint32_t> owners = owners_of(owner);
  out.owner.assign(owners.begin(), owners.end());
  out.elements = v.elements;
  out.items = items;
  out.rounded = {moved, largest};
  out.notes = notes;
  return out;
}

// Which items of a side are in a pair.
std::vector<std::uint8_t> hits(std::span<const index_pair> pairs, std::uint32_t index_pair::*side, std::size_t items) {
  std::vector<std::uint8_t> out(items);
  for (const index_pair &p : pairs)
    out.at(p.*side) = 1;
  return out;
}

// The contacts of pairs of elements in the order of the predicate's kinds, if a page has these.
std::optional<contact_set<double>> found_contacts(const predicate_info &by, const set_of_page &first,
                                                  const set_of_page &second, std::span<const index_pair> elements,
                                                  int threads) {
  if (!by.contacts || elements.size() > report::most_contacts)
    return std::nullopt;
  const auto seen = [](const set_of_page &s, const kind_info &kind) {
    return std::pair(view_of(kind, std::get<1>(s), std::get<2>(s)),
                     std::get<5>(s) ? place_of(*std::get<5>(s), kind) : pose{});
  };
  const auto [a, at_a] = seen(first, *by.a);
  const auto [b, at_b] = seen(second, *by.b);
  contact_set<double> found;
  stoppable(elements.size(), [&](const std::stop_token &stop) {
    found = contacts<double>(a, b, by, elements, {at_a, at_b, threads, stop});
  });
  return found;
}

py::bytes page_of_two(const set_of_page &a, const std::optional<set_of_page> &other, const std::string &predicate,
                      bool turned, const std::string &precision, const py::array &pairs, const py::array &elements,
                      int threads) {
  const predicate_info &by = predicate_named(predicate);
  const std::span<const index_pair> items = pairs_of(pairs), parts = pairs_of(elements);
  const set_of_page &b = other ? *other : a;
  const io::element_set first = elements_of(a);
  std::optional<io::element_set> of_other; // unless A is collided with itself
  if (other)
    of_other = elements_of(b);
  const io::element_set &second = other ? *of_other : first;
  const auto contacts = found_contacts(by, turned ? b : a, turned ? a : b, parts, threads);
  const rung how = rung_named(precision);
  std::string page;
  {
    const py::gil_scoped_release others_run;
    namespace palette = picture::palette;
    const std::vector<std::uint8_t> hit_a = hits(items, &index_pair::a, first.items),
                                    hit_b = hits(items, &index_pair::b, second.items);
    const report::painted side_a{first, hit_a, std::get<6>(a), palette::calm[0], palette::yellow},
        side_b{second, hit_b, std::get<6>(b), palette::calm[1], palette::vermilion};
    page = report::page_of_two({side_a, std::get<5>(a).has_value()}, {side_b, std::get<5>(b).has_value()},
                               {by, how, precision.c_str()},
                               {items, contacts ? &*contacts : nullptr, by.contacts ? parts.size() : 0});
  }
  return page;
}

py::bytes page_of_one(const set_of_page &a, bool merged, const py::array &pairs, const py::array &elements,
                      int threads) {
  const std::span<const index_pair> items = pairs_of(pairs), parts = pairs_of(elements);
  const io::element_set set = elements_of(a);
  const auto contacts = found_contacts(predicate_named("triangle_triangle"), a, a, parts, threads);
  std::string page;
  {
    const py::gil_scoped_release others_run;
    std::vector<std::uint8_t> hit = hits(items, &index_pair::a, set.items);
    for (const index_pair &p : items)
      hit.at(p.b) = 1;
    const report::painted side{set, hit, std::get<6>(a), picture::palette::calm[0], picture::palette::yellow};
    page = report::page_of_one({side, std::get<5>(a).has_value()}, merged,
                               {items, contacts ? &*contacts : nullptr, parts.size()});
  }
  return page;
}

using named_pose = std::pair<std::uint32_t, py::array>;
// The name of a frame, the bodies that it moves, those that touch with the number of their pairs, and those that do not
// with how the one lies in the other, and the reason where that is unknown.
using frame_of_page = std::tuple<std::string, std::vector<named_pose>,
                                 std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>>,
                                 std::vector<std::tuple<std::uint32_t, std::uint32_t, std::string, std::string>>>;

world_answer answer_of(const frame_of_page &frame) {
  world_answer out;
  for (const auto &[a, b, count] : std::get<2>(frame)) {
    out.touching.push_back({a, b, {}});
    out.touching.back().found.count = count;
  }
  for (const auto &[a, b, how, why] : std::get<3>(frame))
    out.nested.push_back({a, b, nesting_named(how), why});
  return out;
}

// bodies: the name, the number of the shape and the pose of each.
py::bytes page_of_bodies(const std::vector<set_of_page> &shapes,
                         const std::vector<std::tuple<std::string, std::size_t, py::array>> &bodies,
                         const std::vector<frame_of_page> &frames, const std::string &precision) {
  std::vector<io::element_set> sets;
  for (const set_of_page &s : shapes)
    sets.push_back(elements_of(s));
  std::vector<report::page_body> of_bodies;
  for (const auto &[name, shape, at] : bodies)
    of_bodies.push_back({name, sets.at(shape), place_of(at, *sets.at(shape).kind)});
  std::vector<std::vector<std::pair<std::uint32_t, pose>>> moved;
  std::vector<world_answer> answers;
  for (const frame_of_page &f : frames) {
    for (moved.emplace_back(); const auto &[body, at] : std::get<1>(f))
      moved.back().emplace_back(body, place_of(at, *of_bodies.at(body).set.kind));
    answers.push_back(answer_of(f));
  }
  std::vector<report::page_frame> of_frames;
  for (std::size_t i = 0; i < frames.size(); ++i)
    of_frames.push_back({std::get<0>(frames[i]), moved[i], answers[i]});
  const rung how = rung_named(precision);
  std::string page;
  {
    const py::gil_scoped_release others_run;
    page = report::page_of_bodies(of_bodies, of_frames, how, precision.c_str(), {});
  }
  return page;
}

} // namespace

void bind_report(py::module_ &module) {
  module.def("page_of_two", &page_of_two, py::arg("a"), py::arg("b"), py::arg("predicate"), py::arg("turned"),
             py::arg("precision"), py::arg("pairs"), py::arg("elements"), py::arg("threads"));
  module.def("page_of_one", &page_of_one, py::arg("a"), py::arg("merged"), py::arg("pairs"), py::arg("elements"),
             py::arg("threads"));
  module.def("page_of_bodies", &page_of_bodies, py::arg("shapes"), py::arg("bodies"), py::arg("frames"),
             py::arg("precision"));
}

} // namespace meetc::python
