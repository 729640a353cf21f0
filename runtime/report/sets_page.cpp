#include "meet/report/sets_page.hpp"

#include "meet/io/elements/words.hpp"
#include "meet/report/contact_lines.hpp"
#include "meet/report/write.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::report {

namespace {

using io::counted, io::grouped;

shape shape_of(const drawn_side &drawn, const painted &side) {
  return {drawn.shape, drawn.owner, side.set.items, counted(side.set)};
}

std::uint64_t touched(const painted &side) {
  return static_cast<std::uint64_t>(std::ranges::count_if(side.hit, [](std::uint8_t h) { return h != 0; }));
}

std::string promise_of(const page_question &q) {
  if (q.tolerance > 0)
    return fmt::format("{}, within {}: an answer may be wrong only where moving one element by {:.3g} changes it",
                       q.precision_name, q.tolerance, q.moved);
  return precision_in_words(q.precision, q.precision_name);
}

// That of both sets, where they are two.
std::string rounding_of(const io::element_set &a, const io::element_set &b) {
  if (&a == &b || b.rounded.numbers == 0)
    return rounding_in_words(a.rounded, " of A");
  if (a.rounded.numbers == 0)
    return rounding_in_words(b.rounded, " of B");
  return fmt::format("{}, {}", rounding_in_words(a.rounded, " of A"), io::in_words(b.rounded, " of B"));
}

void add_contacts(const page_answer &found, scene &to) {
  if (found.contacts) {
    to.contacts = lines_of(*found.contacts);
    to.facts.emplace_back("Contacts", in_words(counts_of(*found.contacts)));
  } else if (found.element_pairs > most_contacts) {
    to.notes.push_back(fmt::format("Where the pairs meet is left out, since there are more than {} of them; the option "
                                   "--contacts writes it.",
                                   grouped(most_contacts)));
  }
}

void add_notes(const char *letter, const io::element_set &set, scene &to) {
  for (const std::string &note : set.notes)
    to.notes.push_back(fmt::format("{}: {}", letter, note));
}

std::string named(const page_side &side) {
  return side.drawn.name + (side.moved ? ", moved" : "");
}

} // namespace

std::string precision_in_words(rung precision, const char *name) {
  if (precision == rung::certified || precision == rung::exact)
    return fmt::format("{}: no answer is wrong for the numbers as they were read", name);
  return fmt::format("{}: the sign of the rounded result, which may be wrong", name);
}

std::string rounding_in_words(const io::rounded_numbers &moved, std::string_view of) {
  return moved.numbers > 0 ? fmt::format("to float32: {}", io::in_words(moved, of))
                           : "none: all numbers of the files are float32";
}

std::string touching_in_words(std::uint64_t pairs, const io::element_set &a, std::uint64_t touched_a,
                              const io::element_set &b, std::uint64_t touched_b) {
  if (pairs == 0)
    return "Nothing touches: 0 pairs";
  return fmt::format("{} {}: {} of A, {} of B", grouped(pairs), pairs == 1 ? "pair touches" : "pairs touch",
                     counted(a, touched_a), counted(b, touched_b));
}

std::string page_of_two(const page_side &a, const page_side &b, const page_question &asked, const page_answer &found) {
  const drawn_side first(a.drawn), second(b.drawn);
  const io::element_set &set_a = a.drawn.set, &set_b = b.drawn.set;
  scene s;
  s.title = fmt::format("{} and {}", a.drawn.name, b.drawn.name);
  s.shapes = {shape_of(first, a.drawn), shape_of(second, b.drawn)};
  s.bodies = {{"A", 0}, {"B", 1}};
  s.pairs = found.pairs;
  s.facts = {{"A", named(a)},
             {"B", named(b)},
             {"Answer", touching_in_words(found.pairs.size(), set_a, touched(a.drawn), set_b, touched(b.drawn))},
             {"Predicate", fmt::format("{}{}", asked.predicate.name,
                                       *asked.predicate.mode ? fmt::format(" ({})", asked.predicate.mode) : "")},
             {"Precision", promise_of(asked)},
             {"Rounding", rounding_of(set_a, set_b)}};
  add_contacts(found, s);
  add_notes("A", set_a, s);
  if (&set_a != &set_b)
    add_notes("B", set_b, s);
  return as_html(s);
}

std::string page_of_one(const page_side &a, bool merged, const page_answer &found) {
  const drawn_side drawn(a.drawn);
  const io::element_set &set = a.drawn.set;
  scene s;
  s.title = fmt::format("{} with itself", a.drawn.name);
  s.shapes = {shape_of(drawn, a.drawn)};
  s.bodies = {{"A", 0}};
  s.pairs = found.pairs;
  s.facts = {{"A", named(a)},
             {"Answer", fmt::format("{} {} beyond their common corners: {}", grouped(found.pairs.size()),
                                    found.pairs.size() == 1 ? "pair of faces meets" : "pairs of faces meet",
                                    counted(set, touched(a.drawn)))},
             {"Corners", merged ? "those with equal coordinates are one" : "one where their vertex is"},
             {"Precision", precision_in_words(rung::certified, "certified")},
             {"Rounding", rounding_in_words(set.rounded, " of A")}};
  add_contacts(found, s);
  add_notes("A", set, s);
  return as_html(s);
}

} // namespace meetc::report
