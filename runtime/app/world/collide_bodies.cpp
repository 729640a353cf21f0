#include "meet/app/world/collide_bodies.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/output/output_files.hpp"
#include "meet/app/output/report_page.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/text/json.hpp"
#include "meet/app/text/progress.hpp"
#include "meet/app/text/words.hpp"
#include "meet/app/world/bodies_page.hpp"
#include "meet/app/world/poses_file.hpp"
#include "meet/app/world/world_on.hpp"
#include "meet/core/world/world.hpp"
#include "meet/io/read.hpp"
#include "meet/io/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

using clock = std::chrono::steady_clock;

double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

// A file is read and prepared once, though many bodies have it.
struct shape {
  io::element_set elements;
  std::shared_ptr<const prepared> set;
};

struct scene {
  std::vector<std::string> names;
  std::vector<const shape *> shapes; // of each body
  std::map<fs::path, shape> by_file;
  world bodies;
  std::string device; // empty: the CPU
  double read_seconds = 0, prepare_seconds = 0;

  scene(const catalogue &all, const bodies_request &q) : bodies(all, q.mode) {}
};

// The answer to one frame.
struct frame_answer {
  std::string name;
  world_answer found;
};

void load(const catalogue &all, const bodies_request &q, const world_source &from, scene &to) {
  const std::vector<const kind_info *> kinds = kinds_of(all);
  for (const body_source &b : from.bodies) {
    auto [at, is_new] = to.by_file.try_emplace(b.file);
    shape &s = at->second;
    if (is_new) {
      auto start = clock::now();
      io::read_options how;
      how.threads = q.threads;
      s.elements = io::read(b.file, kinds, how);
      to.read_seconds += seconds_since(start);
      start = clock::now();
      s.set = std::make_shared<prepared>(prepare(s.elements, q.threads));
      to.prepare_seconds += seconds_since(start);
    }
    to.bodies.add(b.name, s.set, b.at, s.elements.owner);
    to.names.push_back(b.name);
    to.shapes.push_back(&s);
  }
}

void ignore_pairs(const bodies_request &q, const std::vector<name_pair> &allowed, scene &to) {
  require_names(allowed, to.names);
  if (q.only)
    require_names({*q.only}, to.names);
  for (std::uint32_t a = 0; a < to.names.size(); ++a)
    for (std::uint32_t b = a + 1; b < to.names.size(); ++b) {
      const auto holds = [&](const name_pair &p) { return p.holds(to.names[a], to.names[b]); };
      if (std::ranges::any_of(allowed, holds) || (q.only && !holds(*q.only)))
        to.bodies.ignore(a, b);
    }
}

std::string touching_in_words(const scene &s, const frame_answer &f, bool any) {
  std::string out;
  for (const touching_bodies &t : f.found.touching)
    out +=
        fmt::format("{}{} - {}{}", out.empty() ? "" : ", ", s.names[t.a], s.names[t.b],
                    any ? "" : fmt::format(" ({} {})", grouped(t.found.count), t.found.count == 1 ? "pair" : "pairs"));
  return out.empty() ? "nothing touches" : out;
}

std::string summary(const bodies_request &q, const scene &s, const std::vector<frame_answer> &frames) {
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
    out += frames.size() == 1 && f.name.empty() ? "" : fmt::format("frame {:{}}  ", f.name, label);
    out += touching_in_words(s, f, q.any) + "\n";
    candidates += f.found.candidates, near += f.found.near;
    pose += f.found.pose_seconds, collide += f.found.collide_seconds;
  }
  out += fmt::format("\n{}, on the {}: {} pairs of bodies near each other, {} candidate pairs decided\n",
                     name_of(q.precision), s.device.empty() ? "CPU" : s.device, grouped(near), grouped(candidates));
  out += fmt::format("read {:.3f} s, prepare {:.3f} s, pose {:.3f} s, collide {:.3f} s\n", s.read_seconds,
                     s.prepare_seconds, pose, collide);
  for (const auto &[file, one] : s.by_file)
    for (const std::string &note : one.elements.notes)
      out += fmt::format("{}: {}\n", file.string(), note);
  return out;
}

json as_json(const bodies_request &q, const scene &s, const std::vector<frame_answer> &frames) {
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

// FRAME_A_B.csv, with the frame's name only where there are frames. Bytes that a file's name should not hold become '_'.
std::string file_name(const scene &s, const frame_answer &f, const touching_bodies &t) {
  std::string name = fmt::format("{}{}{}_{}.csv", f.name, f.name.empty() ? "" : "_", s.names[t.a], s.names[t.b]);
  for (char &c : name)
    if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < ' ')
      c = '_';
  return name;
}

std::vector<std::string> write_pairs(const bodies_request &q, const scene &s, const std::vector<frame_answer> &frames,
                                     output_files &outputs) {
  std::vector<std::string> written;
  outputs.make_folder(*q.pairs);
  for (const frame_answer &f : frames)
    for (const touching_bodies &t : f.found.touching) {
      const fs::path to = *q.pairs / file_name(s, f, t);
      if (std::ranges::find(written, to.string()) != written.end())
        throw failure(fmt::format("--pairs: two pairs of bodies would be written to {}; give the bodies other names",
                                  to.string()));
      outputs.write(to, [&t](const fs::path &file) { io::write_pairs_csv(file, t.found.pairs); });
      written.push_back(to.string());
    }
  return written;
}

std::string write_page(const bodies_request &q, const world_source &from, const scene &s,
                       const std::vector<frame> &frames, const std::vector<frame_answer> &answers,
                       output_files &outputs) {
  std::vector<shown_body> bodies;
  for (std::size_t i = 0; i < s.names.size(); ++i)
    bodies.push_back({s.names[i], &s.shapes[i]->elements, from.bodies[i].at});
  std::vector<const world_answer *> found;
  for (const frame_answer &f : answers)
    found.push_back(&f.found);
  outputs.write(*q.page, [&](const fs::path &to) { write_bodies_page(to, bodies, frames, found, q.precision); });
  return q.page->string();
}

} // namespace

bodies_report collide_bodies(const catalogue &all, const bodies_request &q) {
  if (q.any && (q.pairs || q.page))
    throw failure("--any stops at the first pair and keeps none; --pairs and --report need them all");
  world_source from = q.world ? read_world(*q.world) : world_of_files(q.files);
  std::vector<fs::path> inputs;
  for (const body_source &b : from.bodies)
    inputs.push_back(b.file);
  output_files outputs(inputs);
  if (q.pairs)
    outputs.expect(*q.pairs / "pairs.csv", true);
  if (q.page)
    outputs.expect(*q.page), check_page(*q.page);
  from.allowed.insert(from.allowed.end(), q.allowed.begin(), q.allowed.end());
  scene s(all, q);
  try {
    load(all, q, from, s);
  } catch (const std::invalid_argument &e) {
    throw failure(e.what());
  }
  ignore_pairs(q, from.allowed, s);
  std::vector<frame> frames;
  if (q.poses)
    frames = read_poses(*q.poses, s.names);
  else
    frames.emplace_back();

  world_options options;
  options.want = q.pairs ? answer_kind::pairs : q.any ? answer_kind::any : answer_kind::count;
  options.precision = q.precision;
  options.first = q.any;
  options.threads = q.threads;
  options.box = all.box;
  std::vector<frame_answer> answers;
  bodies_report report;
  world_on asked(q.on, s.bodies);
  s.device = asked.device_name();
  {
    progress_line progress("collide");
    for (std::size_t i = 0; i < frames.size(); ++i) {
      progress(static_cast<double>(i) / static_cast<double>(frames.size()));
      try {
        for (const auto &[body, at] : frames[i].moved)
          s.bodies.move(body, at);
        answers.push_back({frames[i].name, asked.touching(options)});
      } catch (const std::invalid_argument &e) {
        throw failure(frames[i].name.empty() ? e.what() : fmt::format("frame {}: {}", frames[i].name, e.what()));
      }
      report.touch = report.touch || !answers.back().found.touching.empty();
      if (q.any && report.touch)
        break;
    }
  }
  std::vector<std::string> written = q.pairs ? write_pairs(q, s, answers, outputs) : std::vector<std::string>{};
  if (q.page)
    written.push_back(write_page(q, from, s, frames, answers, outputs));
  outputs.commit();
  report.text = q.json ? in_one_line(as_json(q, s, answers)) + '\n' : summary(q, s, answers);
  if (!q.json)
    for (const std::string &file : written)
      report.text += fmt::format("wrote {}\n", file);
  return report;
}

} // namespace meetc::app
