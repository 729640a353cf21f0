#include "meet/app/output/report_page.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/output/contact_files.hpp"
#include "meet/app/text/words.hpp"
#include "meet/core/contacts/contacts.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/text/text.hpp"
#include "meet/report/write.hpp"

#include <fmt/format.h>

#include <optional>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

// Contacts of more pairs would make a page that no browser shows well.
constexpr std::size_t most_contacts = 200'000;

using facts = std::vector<std::pair<std::string, std::string>>;

report::contact_lines lines_of(const contact_set<double> &c) {
  report::contact_lines out;
  out.points = c.points;
  for (const auto &p : c.pieces)
    out.pieces.insert(out.pieces.end(), p.begin(), p.end());
  for (std::size_t i = 0; i < c.patches.size(); ++i) {
    const std::span<const std::uint32_t> corners = c.patches[i]; // convex
    for (std::size_t k = 2; k < corners.size(); ++k)
      out.triangles.insert(out.triangles.end(), {corners[0], corners[k - 1], corners[k]});
  }
  out.single = c.single_nodes;
  for (std::size_t i = 0; i < c.witness_pairs.size(); ++i)
    out.single.push_back(static_cast<std::uint32_t>(c.nodes() + i));
  out.points.insert(out.points.end(), c.witnesses.begin(), c.witnesses.end());
  return out;
}

report::shape shape_of(const drawn_side &drawn, const painted &side) {
  return {drawn.shape, drawn.owner, side.set.items, counted(side.set)};
}

// Without the line end and the stop before it.
std::string in_page(std::string line) {
  while (!line.empty() && (line.back() == '\n' || line.back() == '.'))
    line.pop_back();
  return line;
}

std::string promise_of(const query &q) {
  if (q.tolerance > 0)
    return fmt::format("{}, within {}: an answer may be wrong only where moving one element by {:.3g} changes it",
                       name_of(q.precision), q.tolerance, moved_by_grid(*q.by.predicate, q.grid));
  return precision_in_words(q.precision);
}

// That of both files, where they are two.
std::string rounding_of(const collide_report &r) {
  if (&r.a == &r.b || r.b.rounded.numbers == 0)
    return rounding_in_words(r.a.rounded, " of A");
  if (r.a.rounded.numbers == 0)
    return rounding_in_words(r.b.rounded, " of B");
  return fmt::format("{}, {}", rounding_in_words(r.a.rounded, " of A"), in_words(r.b.rounded, " of B"));
}

void add_contacts(const std::optional<contact_set<double>> &found, std::size_t pairs, report::scene &to) {
  if (found) {
    to.contacts = lines_of(*found);
    to.facts.emplace_back("Contacts", in_words(counts_of(*found)));
  } else if (pairs > most_contacts) {
    to.notes.push_back(fmt::format("Where the pairs meet is left out, since there are more than {} of them; the option "
                                   "--contacts writes it.",
                                   grouped(most_contacts)));
  }
}

void add_notes(const char *letter, const io::element_set &set, report::scene &to) {
  for (const std::string &note : set.notes)
    to.notes.push_back(fmt::format("{}: {}", letter, note));
}

} // namespace

void check_page(const fs::path &to) {
  const std::string extension = io::lower_case(to.extension().string());
  if (!extension.empty() && extension != ".html" && extension != ".htm")
    throw failure(fmt::format("--report {}: a report is a page of HTML; name it {}", to.string(),
                              fs::path(to).replace_extension(".html").string()));
}

std::string precision_in_words(rung precision) {
  if (precision == rung::certified || precision == rung::exact)
    return fmt::format("{}: no answer is wrong for the numbers as they were read", name_of(precision));
  return fmt::format("{}: the sign of the rounded result, which may be wrong", name_of(precision));
}

std::string rounding_in_words(const io::rounded_numbers &moved, std::string_view of) {
  return moved.numbers > 0 ? fmt::format("to float32: {}", in_words(moved, of))
                           : "none: all numbers of the files are float32";
}

bool page_has_contacts(const query &asked) {
  return asked.by.predicate->contacts && asked.tolerance == 0;
}

void write_page(const fs::path &to, const painted &a, const painted &b, const collide_report &r) {
  const drawn_side first(a), second(b);
  report::scene s;
  s.title = fmt::format("{} and {}", a.name, b.name);
  s.shapes = {shape_of(first, a), shape_of(second, b)};
  s.bodies = {{"A", 0}, {"B", 1}};
  s.pairs = r.found.list;
  s.facts = {
      {"A", fmt::format("{}{}", a.name, r.moved_a ? ", moved" : "")},
      {"B", fmt::format("{}{}", b.name, r.moved_b ? ", moved" : "")},
      {"Answer", in_page(answer_line(r))},
      {"Predicate", fmt::format("{}{}", r.asked.by.predicate->name,
                                *r.asked.by.predicate->mode ? fmt::format(" ({})", r.asked.by.predicate->mode) : "")},
      {"Precision", promise_of(r.asked)},
      {"Rounding", rounding_of(r)}};
  std::optional<contact_set<double>> found;
  if (page_has_contacts(r.asked) && r.found.element_pairs.size() <= most_contacts)
    found = find_contacts<double>(r.a, r.b, r.asked, r.found);
  add_contacts(found, page_has_contacts(r.asked) ? r.found.element_pairs.size() : 0, s);
  add_notes("A", r.a, s);
  if (&r.a != &r.b)
    add_notes("B", r.b, s);
  io::write_file(to, report::as_html(s));
}

void write_page(const fs::path &to, const painted &a, const predicate_info &predicate, const self_report &r,
                int threads) {
  const drawn_side drawn(a);
  report::scene s;
  s.title = fmt::format("{} with itself", a.name);
  s.shapes = {shape_of(drawn, a)};
  s.bodies = {{"A", 0}};
  const std::vector<index_pair> pairs = pairs_of_faces(r);
  s.pairs = pairs;
  s.facts = {
      {"A", fmt::format("{}{}", a.name, r.moved ? ", moved" : "")},
      {"Answer", fmt::format("{} {} beyond their common corners: {}", grouped(r.pairs),
                             r.pairs == 1 ? "pair of faces meets" : "pairs of faces meet", counted(r.a, r.touched))},
      {"Corners", r.merged ? "those with equal coordinates are one" : "one where their vertex is"},
      {"Precision", precision_in_words(rung::certified)},
      {"Rounding", rounding_in_words(r.a.rounded, " of A")}};
  std::optional<contact_set<double>> found;
  if (r.found.pairs.size() <= most_contacts) {
    contact_options options;
    options.threads = threads;
    found = contacts<double>(view_of(r.a), view_of(r.a), predicate, r.found.pairs, options);
  }
  add_contacts(found, r.found.pairs.size(), s);
  add_notes("A", r.a, s);
  io::write_file(to, report::as_html(s));
}

} // namespace meetc::app
