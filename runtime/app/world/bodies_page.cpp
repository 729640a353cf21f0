#include "meet/app/world/bodies_page.hpp"

#include "meet/app/output/paint.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/report/sets_page.hpp"
#include "meet/report/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <list>

namespace meetc::app {

namespace {

std::array<double, 12> matrix_of(const pose &p) {
  std::array<double, 12> out{};
  std::copy(std::begin(p.m), std::end(p.m), out.begin());
  return out;
}

// Fewer frames where all poses together would make a page that no browser reads in seconds.
constexpr std::size_t most_poses = 20'000;
std::size_t shown_frames(std::span<const frame> frames) {
  std::size_t poses = 0, n = 0;
  while (n < frames.size() && poses + frames[n].moved.size() <= most_poses)
    poses += frames[n++].moved.size();
  return std::max<std::size_t>(n, 1);
}

// Two bodies in the list, the inner one first.
report::frame::touch listed(const nested_bodies &n) {
  if (n.how == nesting::overlapping)
    return {n.a, n.b, "overlap, no surfaces touch"};
  return n.how == nesting::a_inside_b ? report::frame::touch{n.a, n.b, "inside"}
                                      : report::frame::touch{n.b, n.a, "inside"};
}

std::string pairs_of_bodies(std::size_t n) {
  return n == 1 ? "1 pair of bodies" : grouped(n) + " pairs of bodies";
}

std::string answer_in_words(const std::vector<frame_answer> &answers) {
  std::size_t frames = 0, touching = 0, nested = 0;
  for (const frame_answer &f : answers) {
    const auto known =
        std::ranges::count_if(f.found.nested, [](const nested_bodies &n) { return n.how != nesting::unknown; });
    touching += f.found.touching.size(), nested += static_cast<std::size_t>(known);
    frames += !f.found.touching.empty() || known > 0;
  }
  if (answers.size() > 1)
    return fmt::format("in {} of {} frames some bodies touch{}", grouped(frames), grouped(answers.size()),
                       nested > 0 ? " or lie in one another" : "");
  std::string out = touching == 0
                        ? "nothing touches"
                        : fmt::format("{} {}", pairs_of_bodies(touching), touching == 1 ? "touches" : "touch");
  if (nested > 0)
    out += fmt::format(", {} {} in one another", pairs_of_bodies(nested), nested == 1 ? "lies" : "lie");
  return out;
}

} // namespace

void write_bodies_page(const std::filesystem::path &to, const bodies_scene &of, const world_source &from,
                       std::span<const frame> frames, const std::vector<frame_answer> &answers, rung precision) {
  constexpr std::span calm = picture::palette::calm;
  report::scene s;
  s.title = fmt::format("{} bodies", grouped(of.names.size()));
  const std::vector<std::uint8_t> no_hits; // bodies are coloured as a whole
  std::list<drawn_side> drawn;
  std::vector<const io::element_set *> sets;
  for (std::size_t i = 0; i < of.names.size(); ++i) {
    const std::string &name = of.names[i];
    const io::element_set &elements = of.shapes[i]->elements;
    const auto at = std::find(sets.begin(), sets.end(), &elements);
    const auto number = static_cast<std::size_t>(at - sets.begin());
    if (at == sets.end()) {
      sets.push_back(&elements);
      const drawn_side &one =
          drawn.emplace_back(painted{elements, no_hits, name, calm[number % calm.size()], picture::palette::yellow});
      s.shapes.push_back({one.shape, one.owner, elements.items, counted(elements)});
      for (const std::string &note : elements.notes)
        s.notes.push_back(fmt::format("{}: {}", name, note));
    }
    s.bodies.push_back({name, number, matrix_of(from.bodies[i].at)});
  }
  const std::size_t shown = shown_frames(frames);
  for (std::size_t i = 0; i < std::min(shown, frames.size()); ++i) {
    report::frame &f = s.frames.emplace_back();
    f.name = frames[i].name;
    for (const auto &[body, at] : frames[i].moved)
      f.moved.emplace_back(body, matrix_of(at));
    for (const touching_bodies &t : answers[i].found.touching)
      f.touching.push_back(
          {t.a, t.b, fmt::format("{} {}", grouped(t.found.count), t.found.count == 1 ? "pair" : "pairs")});
    for (const nested_bodies &n : answers[i].found.nested)
      if (n.how != nesting::unknown)
        f.touching.push_back(listed(n));
  }
  s.facts = {{"Bodies", grouped(of.names.size())},
             {"Answer", answer_in_words(answers)},
             {"Precision", report::precision_in_words(precision, name_of(precision))}};
  io::rounded_numbers rounded;
  for (const io::element_set *const set : sets)
    rounded.add(set->rounded);
  s.facts.emplace_back("Rounding", report::rounding_in_words(rounded));
  for (const std::string &line : unknown_in_lines(of, answers))
    s.notes.push_back(line);
  s.notes.insert(s.notes.end(), of.notes.begin(), of.notes.end());
  if (shown < frames.size())
    s.notes.push_back(
        fmt::format("This page shows the first {} of {} frames.", grouped(shown), grouped(frames.size())));
  io::write_file(to, report::as_html(s));
}

} // namespace meetc::app
