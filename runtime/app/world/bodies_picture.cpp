#include "meet/app/world/bodies_picture.hpp"

#include "meet/app/output/paint.hpp"
#include "meet/app/text/words.hpp"
#include "meet/core/views/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <map>
#include <numeric>

namespace meetc::app {

namespace {

constexpr std::size_t drawn_alone = 40;

// Elements of one kind in their poses.
struct posed_elements {
  io::element_set set;
  std::vector<std::uint8_t> hit; // of each; empty: none is hit
  std::size_t bodies = 0;
  std::string name; // of one body

  void add(const io::element_set &of, const pose &at, const std::vector<std::uint8_t> &hit_items) {
    const auto fields = static_cast<std::size_t>(of.kind->fields);
    const std::size_t before = set.elements;
    set.kind = of.kind;
    set.elements = set.items = before + of.elements;
    set.data.resize(set.elements * fields);
    fetch(view_of(of), *of.kind, at, 0, of.elements, set.data.data() + before * fields);
    if (!hit.empty() || !hit_items.empty())
      hit.resize(set.elements);
    for (std::size_t i = 0; i < of.elements && !hit_items.empty(); ++i)
      hit[before + i] = hit_items[of.owner_of(i)];
    ++bodies;
  }
};

// The items of each body that touch those of another one; empty: there are none.
std::vector<std::vector<std::uint8_t>> touching_items(const bodies_scene &s, const world_answer &found) {
  std::vector<std::vector<std::uint8_t>> out(s.names.size());
  for (const touching_bodies &t : found.touching) {
    out[t.a].resize(s.shapes[t.a]->elements.items), out[t.b].resize(s.shapes[t.b]->elements.items);
    for (const index_pair &p : t.found.pairs)
      out[t.a][p.a] = out[t.b][p.b] = 1;
  }
  return out;
}

} // namespace

bodies_picture::bodies_picture(const bodies_scene &s, const world_source &from, std::span<const frame> frames,
                               std::span<const frame_answer> answers)
    : s_(s) {
  const auto touch = [](const frame_answer &f) { return !f.found.touching.empty(); };
  const auto first = std::ranges::find_if(answers, touch);
  const auto number = first == answers.end() ? 0 : static_cast<std::size_t>(first - answers.begin());
  answer_ = &answers[number];
  for (const body_source &b : from.bodies)
    at_.push_back(b.at);
  for (const frame &f : frames.first(number + 1))
    for (const auto &[body, at] : f.moved)
      at_[body] = at;
}

std::string bodies_picture::frame_in_words() const {
  return answer_->name.empty() ? "" : fmt::format(", frame {}", answer_->name);
}

void bodies_picture::write(const std::filesystem::path &to, const picture_view &view) const {
  const std::vector<std::vector<std::uint8_t>> hit = touching_items(s_, answer_->found);
  std::vector<std::size_t> order(s_.names.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return !hit[i].empty(); });
  std::list<posed_elements> alone;
  std::map<std::string, posed_elements> together; // by kind
  for (const std::size_t i : order) {
    const io::element_set &of = s_.shapes[i]->elements;
    const bool last = alone.size() == drawn_alone;
    posed_elements &one = last ? together[of.kind->name] : alone.emplace_back();
    one.add(of, at_[i], hit[i]);
    one.name = s_.names[i];
  }
  constexpr std::span calm = picture::palette::calm;
  std::vector<painted> sides;
  const auto paint = [&](const posed_elements &one) {
    const std::string name = one.bodies == 1 ? one.name : fmt::format("{} bodies", grouped(one.bodies));
    sides.push_back({one.set, one.hit, name, calm[sides.size() % calm.size()], picture::palette::yellow});
  };
  for (const posed_elements &one : alone)
    paint(one);
  for (const auto &[kind, all] : together)
    paint(all);
  write_picture(to, sides, view);
}

} // namespace meetc::app
