#include "meet/app/world/bodies_page.hpp"

#include "meet/app/output/paint.hpp"
#include "meet/app/output/report_page.hpp"
#include "meet/app/text/words.hpp"
#include "meet/io/files/atomic_file.hpp"
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

std::string answer_in_words(std::span<const world_answer *const> answers, std::size_t frames_with_touch) {
  if (answers.size() > 1)
    return fmt::format("in {} of {} frames some bodies touch", grouped(frames_with_touch), grouped(answers.size()));
  const std::size_t n = answers[0]->touching.size();
  return n == 0
             ? "nothing touches"
             : fmt::format("{} of bodies {}", n == 1 ? "1 pair" : grouped(n) + " pairs", n == 1 ? "touches" : "touch");
}

} // namespace

void write_bodies_page(const std::filesystem::path &to, const std::vector<shown_body> &bodies,
                       std::span<const frame> frames, std::span<const world_answer *const> answers, rung precision) {
  constexpr picture::colour calm[] = {picture::palette::green, picture::palette::blue, picture::palette::red};
  report::scene s;
  s.title = fmt::format("{} bodies", grouped(bodies.size()));
  const std::vector<std::uint8_t> no_hits; // bodies are coloured as a whole
  std::list<drawn_side> drawn;
  std::vector<const io::element_set *> sets;
  for (const shown_body &b : bodies) {
    const auto at = std::find(sets.begin(), sets.end(), b.elements);
    const auto number = static_cast<std::size_t>(at - sets.begin());
    if (at == sets.end()) {
      sets.push_back(b.elements);
      const drawn_side &one = drawn.emplace_back(
          painted{*b.elements, no_hits, b.name, calm[number % std::size(calm)], picture::palette::yellow});
      s.shapes.push_back({one.shape, one.owner, b.elements->items, counted(*b.elements)});
      for (const std::string &note : b.elements->notes)
        s.notes.push_back(fmt::format("{}: {}", b.name, note));
    }
    s.bodies.push_back({b.name, number, matrix_of(b.at)});
  }
  const std::size_t shown = shown_frames(frames);
  std::size_t touching = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    touching += !answers[i]->touching.empty();
    if (i >= shown)
      continue;
    report::frame &f = s.frames.emplace_back();
    f.name = frames[i].name;
    for (const auto &[body, at] : frames[i].moved)
      f.moved.emplace_back(body, matrix_of(at));
    for (const touching_bodies &t : answers[i]->touching)
      f.touching.push_back({t.a, t.b, t.found.count});
  }
  s.facts = {{"Bodies", grouped(bodies.size())},
             {"Answer", answer_in_words(answers, touching)},
             {"Precision", precision_in_words(precision)}};
  io::rounded_numbers rounded;
  for (const io::element_set *const set : sets)
    rounded.add(set->rounded);
  s.facts.emplace_back("Rounding", rounding_in_words(rounded));
  if (shown < frames.size())
    s.notes.push_back(
        fmt::format("This page shows the first {} of {} frames.", grouped(shown), grouped(frames.size())));
  io::write_file(to, report::as_html(s));
}

} // namespace meetc::app
