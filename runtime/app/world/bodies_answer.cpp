#include "meet/app/world/bodies_answer.hpp"

#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"
#include "meet/report/bodies_page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meetc::app {

namespace {

std::string nested_in_words(const bodies_scene &s, const nested_bodies &n) {
  const std::string &a = s.names[n.a], &b = s.names[n.b];
  if (n.how == nesting::overlapping)
    return fmt::format("{} - {} (overlap, no surfaces touch)", a, b);
  return n.how == nesting::a_inside_b ? fmt::format("{} inside {}", a, b) : fmt::format("{} inside {}", b, a);
}

// Two bodies behind another, or each two on a line.
std::string touching_in_words(const bodies_scene &s, const frame_answer &f, bool any, const char *between) {
  std::string out;
  for (const touching_bodies &t : f.found.touching)
    out +=
        fmt::format("{}{} - {}{}", out.empty() ? "" : between, s.names[t.a], s.names[t.b],
                    any ? "" : fmt::format(" ({} {})", grouped(t.found.count), t.found.count == 1 ? "pair" : "pairs"));
  for (const nested_bodies &n : f.found.nested)
    if (n.how != nesting::unknown)
      out += (out.empty() ? "" : between) + nested_in_words(s, n);
  return out.empty() ? "nothing touches" : out;
}

json nested_as_json(const bodies_scene &s, const world_answer &found) {
  json inside = json::array(), overlapping = json::array(), unknown = json::array();
  for (const nested_bodies &n : found.nested) {
    const std::string &a = s.names[n.a], &b = s.names[n.b];
    if (n.how == nesting::unknown)
      unknown.push_back({{"a", a}, {"b", b}, {"why", n.why}});
    else if (n.how == nesting::overlapping)
      overlapping.push_back({{"a", a}, {"b", b}});
    else
      inside.push_back(
          {{"inner", n.how == nesting::a_inside_b ? a : b}, {"outer", n.how == nesting::a_inside_b ? b : a}});
  }
  return {{"inside", inside}, {"overlapping", overlapping}, {"unknown", unknown}};
}

std::vector<const world_answer *> answers_of(const std::vector<frame_answer> &frames) {
  std::vector<const world_answer *> out;
  for (const frame_answer &f : frames)
    out.push_back(&f.found);
  return out;
}

} // namespace

std::string summary(const bodies_request &q, const bodies_scene &s, const std::vector<frame_answer> &frames) {
  std::string out;
  std::size_t width = 0;
  for (const std::string &name : s.names)
    width = std::max(width, name.size());
  for (std::size_t i = 0; i < s.names.size(); ++i)
    out += fmt::format("{:{}}  {}\n", s.names[i], width, counted(s.shapes[i]->elements));
  for (const auto &[file, one] : s.by_file)
    if (one.elements.rounded.numbers > 0)
      out += fmt::format("Rounded to float32: {}.\n",
                         in_words(one.elements.rounded, fmt::format(" of {}", file.string())));
  out += '\n';
  std::size_t label = 0;
  std::uint64_t candidates = 0, near = 0;
  double pose = 0, collide = 0;
  for (const frame_answer &f : frames)
    label = std::max(label, f.name.size());
  for (const frame_answer &f : frames) {
    const bool alone = frames.size() == 1 && f.name.empty();
    out += alone ? "" : fmt::format("frame {:{}}  ", f.name, label);
    out += touching_in_words(s, f, q.any, alone ? "\n" : ", ") + "\n";
    candidates += f.found.candidates, near += f.found.near;
    pose += f.found.pose_seconds, collide += f.found.collide_seconds;
  }
  for (const std::string &line : report::unknown_in_lines(s.names, answers_of(frames)))
    out += line + '\n';
  out += fmt::format("\n{}{}, on the {}: {} near each other, {} candidate pair{} decided\n", name_of(q.precision),
                     never_wrong(q.precision) ? "" : ", which may be wrong", s.device.empty() ? "CPU" : s.device,
                     report::pairs_of_bodies(near), grouped(candidates), candidates == 1 ? "" : "s");
  out += fmt::format("read {:.3f} s, prepare {:.3f} s, pose {:.3f} s, collide {:.3f} s\n", s.read_seconds,
                     s.prepare_seconds, pose, collide);
  for (const auto &[file, one] : s.by_file)
    for (const std::string &note : one.elements.notes)
      out += fmt::format("{}: {}\n", file.string(), note);
  for (const std::string &note : s.notes)
    out += note + '\n';
  return out;
}

json as_json(const bodies_request &q, const bodies_scene &s, const std::vector<frame_answer> &frames) {
  json bodies = json::array(), list = json::array();
  for (std::size_t i = 0; i < s.names.size(); ++i)
    bodies.push_back(
        {{"name", s.names[i]}, {"kind", s.shapes[i]->elements.kind->name}, {"elements", s.shapes[i]->elements.items}});
  double pose = 0, collide = 0;
  for (const frame_answer &f : frames) {
    json touching = json::array();
    for (const touching_bodies &t : f.found.touching)
      touching.push_back({{"a", s.names[t.a]}, {"b", s.names[t.b]}, {"pairs", t.found.count}});
    json one = {{"frame", f.name}, {"touching", touching}, {"near", f.found.near}, {"candidates", f.found.candidates}};
    if (asks_nested(q))
      one.update(nested_as_json(s, f.found));
    list.push_back(one);
    pose += f.found.pose_seconds, collide += f.found.collide_seconds;
  }
  io::rounded_numbers rounded;
  json notes = json::array();
  for (const auto &[file, one] : s.by_file) {
    rounded.add(one.elements.rounded);
    for (const std::string &note : one.elements.notes)
      notes.push_back(fmt::format("{}: {}", file.string(), note));
  }
  for (const std::string &note : s.notes)
    notes.push_back(note);
  json out = {{"bodies", bodies},
              {"frames", list},
              {"rounded", {{"numbers", rounded.numbers}, {"largest", rounded.largest}}},
              {"notes", notes},
              {"precision", name_of(q.precision)},
              {"mode", q.mode},
              {"seconds",
               {{"read", with_decimals(s.read_seconds, 6)},
                {"prepare", with_decimals(s.prepare_seconds, 6)},
                {"pose", with_decimals(pose, 6)},
                {"collide", with_decimals(collide, 6)}}}};
  out["device"] = s.device.empty() ? "cpu" : "cuda";
  if (!s.device.empty())
    out["device_name"] = s.device;
  return out;
}

} // namespace meetc::app
