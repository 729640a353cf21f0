#include "meet/app/output/self_report.hpp"

#include "meet/app/output/report.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/text/json.hpp"
#include "meet/app/text/words.hpp"
#include "meet/core/answers/pair_list.hpp"
#include "meet/io/write.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::app {

namespace {

// The faces of the pairs of elements, in their order.
std::vector<index_pair> faces_of_pairs(const self_report &r) {
  std::vector<index_pair> out = r.found.pairs;
  for (index_pair &p : out)
    p = {static_cast<std::uint32_t>(r.a.owner_of(p.a)), static_cast<std::uint32_t>(r.a.owner_of(p.b))};
  return out;
}

// "faces 3, 17 and 29 more"
std::string some_of(const std::vector<std::uint32_t> &faces) {
  constexpr std::size_t most = 8;
  std::string out = faces.size() == 1 ? "face " : "faces ";
  for (std::size_t i = 0; i < std::min(faces.size(), most); ++i)
    out += fmt::format("{}{}", i == 0 ? "" : ", ", faces[i]);
  return faces.size() > most ? fmt::format("{} and {} more", out, grouped(faces.size() - most)) : out;
}

std::string area_line(const self_report &r) {
  const std::size_t n = r.without_area.size();
  if (n == 0)
    return "";
  return fmt::format("{} {} no area ({}) and {} the segment{} or point{} that {}.\n", counted(r.a, n),
                     n == 1 ? "has" : "have", some_of(r.without_area), n == 1 ? "is" : "are", n == 1 ? "" : "s",
                     n == 1 ? "" : "s", n == 1 ? "it is" : "they are");
}

} // namespace

std::vector<index_pair> pairs_of_faces(const self_report &r) {
  std::vector<index_pair> out = faces_of_pairs(r);
  sort_pairs(out);
  drop_repeats(out);
  return out;
}

void name_faces(self_report &r) {
  const std::vector<index_pair> faces = pairs_of_faces(r);
  r.pairs = faces.size();
  r.hit.assign(r.a.items, 0);
  for (const index_pair p : faces)
    r.hit[p.a] = r.hit[p.b] = 1;
  r.touched = static_cast<std::uint64_t>(std::count(r.hit.begin(), r.hit.end(), 1));
  std::vector<std::uint32_t> left(r.a.items, 0); // triangles of each face with area
  for (std::size_t i = 0; i < r.a.elements; ++i)
    ++left[r.a.owner_of(i)];
  for (const std::uint32_t e : r.found.degenerate)
    if (--left[r.a.owner_of(e)] == 0)
      r.without_area.push_back(static_cast<std::uint32_t>(r.a.owner_of(e)));
}

void write_self_pairs(const std::filesystem::path &to, const self_report &r) {
  const std::vector<index_pair> faces = faces_of_pairs(r);
  if (r.a.owner.empty())
    return io::write_pairs_csv(to, faces);
  io::write_pairs_csv(to, faces, ",triangle_a,triangle_b", [&r](std::size_t i, std::string &line) {
    line += fmt::format(",{},{}", r.found.pairs[i].a, r.found.pairs[i].b);
  });
}

std::string summary(const self_report &r) {
  const self_result &f = r.found;
  std::string out =
      fmt::format("A  {}  {}  box {}{}\n", r.name, counted(r.a), in_words(r.bounds), r.moved ? ", moved" : "");
  if (r.a.rounded.numbers > 0)
    out += fmt::format("Rounded to float32: {}.\n", in_words(r.a.rounded, " of A"));
  out += r.pairs == 0
             ? "\nNo two faces meet beyond their common corners: 0 pairs.\n"
             : fmt::format("\n{} {} beyond their common corners: {}.\n", grouped(r.pairs),
                           r.pairs == 1 ? "pair of faces meets" : "pairs of faces meet", counted(r.a, r.touched));
  out += area_line(r);
  out += r.merged ? "Corners with equal coordinates are one.\n" : "Corners are one where their vertex is.\n";
  if (!r.a.owner.empty())
    out += "Common corners are those of the triangles into which polygons were cut.\n";
  out +=
      fmt::format("\n{} pairs with one common corner, {} with two, {} with three, and {} other candidates decided\n",
                  grouped(f.neighbours[0]), grouped(f.neighbours[1]), grouped(f.neighbours[2]), grouped(f.candidates));
  out +=
      fmt::format("read {:.3f} s, prepare {:.3f} s, collide {:.3f} s\n", r.read_seconds, r.prepare_seconds, f.seconds);
  if (r.on == processor::cuda)
    out += device_line(r.by_device);
  for (const std::string &note : r.a.notes)
    out += fmt::format("A: {}\n", note);
  for (const std::string &note : r.notes)
    out += note + '\n';
  for (const std::string &file : r.written)
    out += fmt::format("wrote {}\n", file);
  return out;
}

std::string as_json(const self_report &r) {
  const self_result &f = r.found;
  json unsure = json::object();
  for (int i = 0; i < bounded_rungs; ++i)
    unsure[name_of(static_cast<rung>(i))] = f.rungs.unsure[i];
  json out = {{"a", {{"kind", r.a.kind->name}, {"elements", r.a.items}}},
              {"self", true},
              {"merged", r.merged},
              {"pairs", r.pairs},
              {"touched_a", r.touched},
              {"triangle_pairs", f.pairs.size()},
              {"without_area", r.without_area},
              {"neighbours", {f.neighbours[0], f.neighbours[1], f.neighbours[2]}},
              {"candidates", f.candidates},
              {"rounded", {{"numbers", r.a.rounded.numbers}, {"largest", r.a.rounded.largest}}},
              {"precision", name_of(rung::certified)},
              {"device", r.on == processor::cuda ? "cuda" : "cpu"},
              {"unsure", unsure},
              {"seconds",
               {{"read", with_decimals(r.read_seconds, 6)},
                {"prepare", with_decimals(r.prepare_seconds, 6)},
                {"collide", with_decimals(f.seconds, 6)}}}};
  if (r.on == processor::cuda) {
    out["device_name"] = r.by_device.device;
    out["seconds"]["start"] = with_decimals(r.by_device.start_seconds, 6);
    out["seconds"]["device"] = with_decimals(r.by_device.device_seconds, 6);
  } else {
    out["instruction_set"] = r.instruction_set;
  }
  std::vector<std::string> notes = r.a.notes;
  notes.insert(notes.end(), r.notes.begin(), r.notes.end());
  if (!notes.empty())
    out["notes"] = notes;
  return in_one_line(out) + '\n';
}

} // namespace meetc::app
