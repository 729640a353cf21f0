#include "meet/report/bodies_page.hpp"

#include "meet/io/elements/words.hpp"
#include "meet/report/drawn_side.hpp"
#include "meet/report/sets_page.hpp"
#include "meet/report/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <list>
#include <map>

namespace meetc::report {

namespace {

using io::counted, io::grouped;

std::array<double, 12> matrix_of(const pose &p) {
  std::array<double, 12> out{};
  std::copy(std::begin(p.m), std::end(p.m), out.begin());
  return out;
}

// Fewer frames where all poses together would make a page that no browser reads in seconds.
constexpr std::size_t most_poses = 20'000;
std::size_t shown_frames(std::span<const page_frame> frames) {
  std::size_t poses = 0, n = 0;
  while (n < frames.size() && poses + frames[n].moved.size() <= most_poses)
    poses += frames[n++].moved.size();
  return std::max<std::size_t>(n, 1);
}

// Two bodies in the list, the inner one first.
frame::touch listed(const nested_bodies &n) {
  if (n.how == nesting::overlapping)
    return {n.a, n.b, "overlap, no surfaces touch"};
  return n.how == nesting::a_inside_b ? frame::touch{n.a, n.b, "inside"} : frame::touch{n.b, n.a, "inside"};
}
frame listed(const page_frame &of) {
  frame f;
  f.name = of.name;
  for (const auto &[body, at] : of.moved)
    f.moved.emplace_back(body, matrix_of(at));
  for (const touching_bodies &t : of.found.touching)
    f.touching.push_back(
        {t.a, t.b, fmt::format("{} {}", grouped(t.found.count), t.found.count == 1 ? "pair" : "pairs")});
  for (const nested_bodies &n : of.found.nested)
    if (n.how != nesting::unknown)
      f.touching.push_back(listed(n));
  return f;
}

std::string answer_in_words(std::span<const page_frame> all) {
  std::size_t frames = 0, touching = 0, nested = 0;
  for (const page_frame &f : all) {
    const auto known =
        std::ranges::count_if(f.found.nested, [](const nested_bodies &n) { return n.how != nesting::unknown; });
    touching += f.found.touching.size(), nested += static_cast<std::size_t>(known);
    frames += !f.found.touching.empty() || known > 0;
  }
  if (all.size() > 1)
    return fmt::format("in {} of {} frames some bodies touch{}", grouped(frames), grouped(all.size()),
                       nested > 0 ? " or lie in one another" : "");
  std::string out = touching == 0
                        ? "nothing touches"
                        : fmt::format("{} {}", pairs_of_bodies(touching), touching == 1 ? "touches" : "touch");
  if (nested > 0)
    out += fmt::format(", {} {} in one another", pairs_of_bodies(nested), nested == 1 ? "lies" : "lie");
  return out;
}

// Adds the bodies, and a shape for each of their sets, to the scene, and returns the sets.
std::vector<const io::element_set *> add_bodies(std::span<const page_body> bodies, std::list<drawn_side> &drawn,
                                                scene &to) {
  constexpr std::span calm = picture::palette::calm;
  const std::vector<std::uint8_t> no_hits; // bodies are coloured as a whole
  std::vector<const io::element_set *> sets;
  for (const page_body &b : bodies) {
    const auto at = std::find(sets.begin(), sets.end(), &b.set);
    const auto number = static_cast<std::size_t>(at - sets.begin());
    if (at == sets.end()) {
      sets.push_back(&b.set);
      const drawn_side &one =
          drawn.emplace_back(painted{b.set, no_hits, b.name, calm[number % calm.size()], picture::palette::yellow});
      to.shapes.push_back({one.shape, one.owner, b.set.items, counted(b.set)});
      for (const std::string &note : b.set.notes)
        to.notes.push_back(fmt::format("{}: {}", b.name, note));
    }
    to.bodies.push_back({b.name, number, matrix_of(b.at), calm[to.bodies.size() % calm.size()]});
  }
  return sets;
}

} // namespace

std::string pairs_of_bodies(std::size_t n) {
  return n == 1 ? "1 pair of bodies" : grouped(n) + " pairs of bodies";
}

std::vector<std::string> unknown_in_lines(std::span<const std::string> names,
                                          std::span<const world_answer *const> frames) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::string, std::size_t>> all;
  for (const world_answer *const f : frames)
    for (const nested_bodies &n : f->nested)
      if (n.how == nesting::unknown)
        ++all.try_emplace({n.a, n.b}, n.why, 0).first->second.second;
  constexpr std::size_t most = 8;
  std::vector<std::string> out;
  for (const auto &[bodies, why] : all)
    if (out.size() < most)
      out.push_back(fmt::format(
          "Unknown whether {} or {} is inside the other{}: {}.", names[bodies.first], names[bodies.second],
          frames.size() == 1 ? "" : fmt::format(", in {} of {} frames", why.second, frames.size()), why.first));
  if (all.size() > most)
    out.push_back(fmt::format("It is unknown of {} more, which JSON lists.", pairs_of_bodies(all.size() - most)));
  return out;
}

std::string page_of_bodies(std::span<const page_body> bodies, std::span<const page_frame> frames, rung precision,
                           const char *precision_name, std::span<const std::string> notes) {
  scene s;
  s.title = fmt::format("{} bodies", grouped(bodies.size()));
  std::list<drawn_side> drawn;
  const std::vector<const io::element_set *> sets = add_bodies(bodies, drawn, s);
  const std::size_t shown = std::min(shown_frames(frames), frames.size());
  for (const page_frame &f : frames.first(shown))
    s.frames.push_back(listed(f));
  io::rounded_numbers rounded;
  for (const io::element_set *const set : sets)
    rounded.add(set->rounded);
  s.facts = {{"Bodies", grouped(bodies.size())},
             {"Answer", answer_in_words(frames)},
             {"Precision", precision_in_words(precision, precision_name)},
             {"Rounding", rounding_in_words(rounded)}};
  std::vector<std::string> names;
  std::vector<const world_answer *> answers;
  for (const page_body &b : bodies)
    names.push_back(b.name);
  for (const page_frame &f : frames)
    answers.push_back(&f.found);
  for (std::string &line : unknown_in_lines(names, answers))
    s.notes.push_back(std::move(line));
  s.notes.insert(s.notes.end(), notes.begin(), notes.end());
  if (shown < frames.size())
    s.notes.push_back(
        fmt::format("This page shows the first {} of {} frames.", grouped(shown), grouped(frames.size())));
  return as_html(s);
}

} // namespace meetc::report
