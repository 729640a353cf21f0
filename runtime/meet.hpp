// meet.hpp: the library's front door: sets of points, segments, triangles, spheres and boxes from what a program has, and
// questions about two of them.
//
//   const meet::prepared floor = meet::prepare(meet::triangles(points, faces));
//   const meet::prepared balls = meet::prepare(meet::spheres(records, &record::ball));
//   for (const auto &[face, ball] : meet::pairs(floor, balls)) ...
//
// Each is a call of meetc::prepare() or meetc::collide(), and these are their types.
#ifndef MEET_MEET_HPP
#define MEET_MEET_HPP

#include "meet/core/query/ask.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/sets/moving_set.hpp"
#include "meet/front/rounded.hpp"
#include "meet/io/elements/element_set.hpp"
#include <cga/cga_runtime.hpp>

#include <utility>

namespace meet {

using meetc::collide_options, meetc::how, meetc::index_pair, meetc::input_error, meetc::no_element, meetc::per_element,
    meetc::moving_set, meetc::pose, meetc::prepared, meetc::rung, meetc::usage_error;

// ---- sets: borrowed memory, which must stay until they are prepared ----

// The shipped kinds are points x, y, z; segments and triangles of two and three points, either indices of points or rows of
// coordinates; spheres x, y, z, r; boxes low x, y, z, high x, y, z.
inline elements points(const rows<3> &of) {
  return elements_of(meetc::find_kind(cga::catalogue(), "point"), of);
}
inline elements segments(const rows<3> &points, const corners<2> &of) {
  return elements_of(meetc::find_kind(cga::catalogue(), "segment"), points, of);
}
inline elements segments(const rows<6> &of) {
  return elements_of(meetc::find_kind(cga::catalogue(), "segment"), of);
}
inline elements triangles(const rows<3> &points, const corners<3> &of) {
  return elements_of(meetc::find_kind(cga::catalogue(), "triangle"), points, of);
}
inline elements triangles(const rows<9> &of) {
  return elements_of(meetc::find_kind(cga::catalogue(), "triangle"), of);
}
inline elements spheres(const rows<4> &of) {
  return elements_of(meetc::find_kind(cga::catalogue(), "sphere"), of);
}
inline elements boxes(const rows<6> &of) {
  return elements_of(meetc::find_kind(cga::catalogue(), "box"), of);
}
// A file as it was read.
inline elements elements_of(const meetc::io::element_set &file) {
  return {view_of(file), file.kind};
}

// A set whose elements will lie elsewhere: moving_set::update(triangles(points, faces)) looks at them again.
inline moving_set moving(const elements &of, const pose &at = {}, int threads = 0) {
  return {of.view, *of.kind, at, threads};
}

// ---- questions about two prepared sets, in either order of their kinds ----

namespace detail {
inline meetc::result ask(const prepared &a, const prepared &b, how asked, meetc::answer_kind want, bool first,
                         const meetc::catalogue &all) {
  asked.with.want = want;
  asked.with.first_met = first;
  return meetc::ask(all, a, b, asked);
}
} // namespace detail

// All pairs of elements that touch, sorted by a, then b.
inline std::vector<index_pair> pairs(const prepared &a, const prepared &b, const how &asked = {},
                                     const meetc::catalogue &all = cga::catalogue()) {
  return std::move(detail::ask(a, b, asked, meetc::answer_kind::pairs, false, all).pairs);
}
// How many pairs touch.
inline std::uint64_t count(const prepared &a, const prepared &b, const how &asked = {},
                           const meetc::catalogue &all = cga::catalogue()) {
  return detail::ask(a, b, asked, meetc::answer_kind::count, false, all).count;
}
// For each element of both sets, the number of pairs that it is in.
inline per_element<std::uint64_t> counts(const prepared &a, const prepared &b, const how &asked = {},
                                         const meetc::catalogue &all = cga::catalogue()) {
  return std::move(detail::ask(a, b, asked, meetc::answer_kind::counts, false, all).counts);
}
// For each element of both sets, whether it touches any: 1 or 0.
inline per_element<std::uint8_t> flags(const prepared &a, const prepared &b, const how &asked = {},
                                       const meetc::catalogue &all = cga::catalogue()) {
  return std::move(detail::ask(a, b, asked, meetc::answer_kind::flags, false, all).flags);
}
// Whether anything touches.
inline bool any(const prepared &a, const prepared &b, const how &asked = {},
                const meetc::catalogue &all = cga::catalogue()) {
  return detail::ask(a, b, asked, meetc::answer_kind::any, false, all).count != 0;
}
// For each segment of a, the triangle of b that it meets first on its way; no_element: none.
inline std::vector<std::uint32_t> first_met(const prepared &a, const prepared &b, const how &asked = {},
                                            const meetc::catalogue &all = cga::catalogue()) {
  return std::move(detail::ask(a, b, asked, meetc::answer_kind::none, true, all).first_met);
}

} // namespace meet

#endif
