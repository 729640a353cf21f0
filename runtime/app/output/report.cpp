#include "meet/app/output/report.hpp"

#include "meet/app/input/sets.hpp"
#include "meet/app/text/boxes.hpp"
#include "meet/app/text/words.hpp"
#include "meet/report/sets_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

namespace meetc::app {

namespace {

// Whether nothing touches although one set lies within a mesh's box. The report says that meshes are surfaces, since
// many users expect containment to count.
bool may_be_contained(const collide_report &r) {
  const answers &f = r.found;
  return f.pairs == 0 &&
         ((is_mesh(r.a) && inside(f.b.bounds, f.a.bounds)) || (is_mesh(r.b) && inside(f.a.bounds, f.b.bounds)));
}

std::string predicate_in_words(const query &q, processor on) {
  const predicate_info &p = *q.by.predicate;
  const std::string mode = *p.mode ? fmt::format(" ({})", p.mode) : "";
  const std::string tolerance = q.tolerance > 0 ? fmt::format(" within {}", q.tolerance) : "";
  const char *const caution = never_wrong(q.precision) || q.tolerance > 0 ? "" : ", which may be wrong";
  return fmt::format("{}{}, {}{}{}, on the {}", p.name, mode, name_of(q.precision), tolerance, caution,
                     on == processor::cuda ? "CUDA device" : "CPU");
}

std::string file_lines(const collide_report &r) {
  const std::string count_a = counted(r.a), count_b = counted(r.b);
  const std::size_t names = std::max(r.name_a.size(), r.name_b.size());
  const std::size_t counts = std::max(count_a.size(), count_b.size());
  std::string out;
  out += fmt::format("A  {:{}}  {:{}}  box {}{}\n", r.name_a, names, count_a, counts, in_words(r.found.a.bounds),
                     r.moved_a ? ", moved" : "");
  out += fmt::format("B  {:{}}  {:{}}  box {}{}\n", r.name_b, names, count_b, counts, in_words(r.found.b.bounds),
                     r.moved_b ? ", moved" : "");
  return out;
}

// The sets with their letters; one file that is given twice is read once.
std::vector<std::pair<char, const io::element_set *>> sets_of(const collide_report &r) {
  if (&r.a == &r.b)
    return {{'A', &r.a}};
  return {{'A', &r.a}, {'B', &r.b}};
}

// The count of numbers that float32 moved, as a line; empty where it moved none.
std::string rounded_line(const collide_report &r) {
  std::string out;
  for (const auto &[letter, set] : sets_of(r))
    if (set->rounded.numbers > 0)
      out += fmt::format("{}{}", out.empty() ? "" : ", ", in_words(set->rounded, fmt::format(" of {}", letter)));
  return out.empty() ? out : fmt::format("Rounded to float32: {}.\n", out);
}

// The rungs that were needed, each with the number of pairs that it left unsure.
std::string rungs_line(const answers &f) {
  std::string out;
  std::uint64_t left = f.candidates;
  for (int r = 0; r < bounded_rungs && left > 0; ++r) {
    left = f.rungs.unsure[r];
    out += fmt::format("{} ({} handed on), ", name_of(static_cast<rung>(r)), grouped(left));
  }
  if (left > 0)
    out += fmt::format("{}, ", name_of(rung::exact));
  return out.empty() ? "" : fmt::format("rungs used: {}\n", std::string_view(out).substr(0, out.size() - 2));
}

// The effect of a tolerance on the numbers and on the answer.
std::string tolerance_lines(const query &q) {
  return fmt::format("Numbers were rounded to multiples of 2^{}: an answer may be wrong only where moving one element\n"
                     "by at most {:.3g} changes it. The boxes above are those of the rounded numbers.\n",
                     std::ilogb(q.grid), moved_by_grid(*q.by.predicate, q.grid));
}

} // namespace

std::string answer_line(const collide_report &r) {
  const answers &f = r.found;
  if (r.asked.any)
    return f.pairs ? "They touch (stopped at the first pair found).\n" : "Nothing touches.\n";
  return report::touching_in_words(f.pairs, r.a, f.a.touched, r.b, f.b.touched) + ".\n";
}

std::string device_line(const device_account &d) {
  return fmt::format("on {}: {:.3f} s to start, {:.6f} s of kernels\n",
                     d.devices > 1 ? fmt::format("{} devices, the first {}", d.devices, d.device) : d.device,
                     d.start_seconds, d.device_seconds);
}

std::vector<std::string> all_notes(const collide_report &r) {
  std::vector<std::string> out;
  for (const auto &[letter, set] : sets_of(r))
    for (const std::string &note : set->notes)
      out.push_back(fmt::format("{}: {}", letter, note));
  out.insert(out.end(), r.found.notes.begin(), r.found.notes.end());
  out.insert(out.end(), r.notes.begin(), r.notes.end());
  return out;
}

std::string summary(const collide_report &r) {
  const answers &f = r.found;
  std::string out = file_lines(r);
  if (r.same_file)
    out += r.moved_a || r.moved_b ? fmt::format("A and B are the same file, {} moved.\n", !r.moved_b   ? "A"
                                                                                          : !r.moved_a ? "B"
                                                                                                       : "both")
           : r.a.kind->points == 3
               ? "A and B are the same file: every ordered pair (i, j) counts, i = j included, and neighbours\n"
                 "touch where they share a corner or an edge.\n"
               : "A and B are the same file: every ordered pair (i, j) counts, i = j included.\n";
  out += rounded_line(r);
  if (disjoint(f.a.bounds, f.b.bounds))
    out += "The boxes are disjoint.\n";
  out += '\n';
  out += answer_line(r);
  if (may_be_contained(r))
    out += fmt::format("Meshes are surfaces here: an element that lies wholly inside one does not touch it{}.\n",
                       never_wrong(r.asked.precision) && !r.moved_a && !r.moved_b &&
                               std::string_view(r.asked.by.predicate->mode) != "surface"
                           ? " (--bodies tells of it)"
                           : "");
  out += fmt::format("\n{}: {} candidate pair{} decided\n", predicate_in_words(r.asked, f.on), grouped(f.candidates),
                     f.candidates == 1 ? "" : "s");
  if (r.asked.precision == rung::certified)
    out += rungs_line(f);
  if (r.asked.grid > 0)
    out += tolerance_lines(r.asked);
  out += fmt::format("read {:.3f} s, prepare {:.3f} s, collide {:.3f} s\n", r.read_seconds, f.prepare_seconds,
                     f.collide_seconds);
  if (r.found.on == processor::cuda)
    out += device_line(f.by_device);
  for (const std::string &note : all_notes(r))
    out += note + "\n";
  if (r.contacts)
    out += fmt::format("contacts: {}; {:.3f} s\n", in_words(*r.contacts), r.contacts->seconds);
  for (const std::string &file : r.written)
    out += fmt::format("wrote {}\n", file);
  return out;
}

std::string box_warning(const query &asked, const answers &found) {
  const rung_report &r = found.rungs;
  std::string sets;
  for (const auto &[name, left, side] :
       {std::tuple("A", r.left_box_a, &found.a), std::tuple("B", r.left_box_b, &found.b)})
    if (left)
      sets += fmt::format("{}{} {}", sets.empty() ? "" : ", ", name, in_words(side->bounds));
  return sets.empty() ? ""
                      : fmt::format("warning: outside of the scene's box, {} to {} in each coordinate: {}; fp32 "
                                    "then bounds each pair by itself, and the answer is as certain",
                                    -asked.box, asked.box, sets);
}

} // namespace meetc::app
