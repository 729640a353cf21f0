#include "meet/app/world/collide_bodies.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/output/output_files.hpp"
#include "meet/app/output/report_page.hpp"
#include "meet/app/text/progress.hpp"
#include "meet/app/world/bodies_answer.hpp"
#include "meet/app/world/bodies_picture.hpp"
#include "meet/app/world/poses_file.hpp"
#include "meet/app/world/srdf_file.hpp"
#include "meet/app/world/world_on.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/read.hpp"
#include "meet/io/write.hpp"
#include "meet/report/bodies_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

using clock = std::chrono::steady_clock;

double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

void load(const catalogue &all, const bodies_request &q, const world_source &from, bodies_scene &to) {
  const std::vector<const kind_info *> kinds = kinds_of(all);
  for (const body_source &b : from.bodies) {
    auto [at, is_new] = to.by_file.try_emplace(b.file);
    body_shape &s = at->second;
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
    try {
      to.bodies.add(b.name, s.set, b.at, s.elements.owner);
    } catch (const std::invalid_argument &e) {
      throw failure(b.place.empty() ? e.what() : fmt::format("{}: {}", b.place, e.what()));
    }
    to.names.push_back(b.name);
    to.shapes.push_back(&s);
  }
}

void ignore_pairs(const bodies_request &q, const std::vector<name_pair> &allowed, bodies_scene &to) {
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

// FRAME_A_B.csv, with the frame's name only where there are frames. Bytes that a file's name should not hold become '_'.
std::string file_name(const bodies_scene &s, const frame_answer &f, const touching_bodies &t) {
  std::string name = fmt::format("{}{}{}_{}.csv", f.name, f.name.empty() ? "" : "_", s.names[t.a], s.names[t.b]);
  for (char &c : name)
    if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < ' ')
      c = '_';
  return name;
}

std::vector<std::string> write_pairs(const bodies_request &q, const bodies_scene &s,
                                     const std::vector<frame_answer> &frames, output_files &outputs) {
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

void write_page(const fs::path &to, const bodies_request &q, const bodies_scene &s, const world_source &from,
                std::span<const frame> frames, const std::vector<frame_answer> &answers) {
  std::vector<report::page_body> bodies;
  for (std::size_t i = 0; i < s.names.size(); ++i)
    bodies.push_back({s.names[i], s.shapes[i]->elements, from.bodies[i].at});
  std::vector<report::page_frame> shown;
  for (std::size_t i = 0; i < frames.size(); ++i)
    shown.push_back({frames[i].name, frames[i].moved, answers[i].found});
  io::write_file(to, report::page_of_bodies(bodies, shown, q.precision, name_of(q.precision), s.notes));
}

// The file of the poses in which a frame has its bodies, to stand before what is wrong with one of them.
std::string place_of(const bodies_request &q, const std::string &frame) {
  if (q.poses)
    return fmt::format("{}: {}", q.poses->string(), frame.empty() ? "" : "frame " + frame + ": ");
  return q.world ? q.world->string() + ": " : "";
}

std::vector<fs::path> inputs_of(const bodies_request &q, const world_source &from) {
  std::vector<fs::path> out;
  for (const body_source &b : from.bodies)
    out.push_back(b.file);
  for (const auto *const file : {&q.world, &q.poses, &q.srdf})
    if (*file)
      out.push_back(**file);
  return out;
}

void expect_outputs(const bodies_request &q, output_files &outputs) {
  if (q.any && (q.pairs || q.image || q.page))
    throw failure("--any stops at the first pair and keeps none; --pairs, --image and --report need them all");
  if (q.pairs && q.pairs->extension() == ".csv")
    throw failure(
        fmt::format("--pairs {}: for many bodies it is a folder, with a file for each two that touch; name it {}",
                    q.pairs->string(), fs::path(*q.pairs).replace_extension().string()));
  if (q.pairs)
    outputs.expect(*q.pairs / "pairs.csv", true);
  if (q.image)
    outputs.expect(*q.image), check_picture(*q.image);
  if (q.page)
    outputs.expect(*q.page), check_page(*q.page);
}

} // namespace

bodies_report collide_bodies(const catalogue &all, const bodies_request &q) {
  world_source from = q.world ? read_world(*q.world) : world_of_files(q.files);
  output_files outputs(inputs_of(q, from));
  expect_outputs(q, outputs);
  from.allowed.insert(from.allowed.end(), q.allowed.begin(), q.allowed.end());
  bodies_scene s(all, q.mode);
  try {
    load(all, q, from, s);
  } catch (const std::invalid_argument &e) {
    throw failure(e.what());
  }
  if (q.srdf) {
    const srdf_pairs links = read_srdf(*q.srdf, s.names);
    from.allowed.insert(from.allowed.end(), links.allowed.begin(), links.allowed.end());
    s.notes.push_back(fmt::format("{}: {} may touch; {} a link that is no body", q.srdf->string(),
                                  report::pairs_of_bodies(links.allowed.size()),
                                  links.others == 1 ? "1 line names" : fmt::format("{} lines name", links.others)));
  }
  ignore_pairs(q, from.allowed, s);
  std::vector<frame> frames;
  if (q.poses)
    frames = read_poses(*q.poses, s.names);
  else
    frames.emplace_back();

  world_options options;
  options.want = q.pairs || q.image ? answer_kind::pairs : q.any ? answer_kind::any : answer_kind::count;
  options.precision = q.precision;
  options.first = q.any;
  options.nested = asks_nested(q);
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
        throw failure(place_of(q, frames[i].name) + e.what());
      }
      const world_answer &found = answers.back().found;
      if (!q.pairs && !found.touching.empty() && options.want == answer_kind::pairs)
        options.want = answer_kind::count; // the image shows this frame
      report.touch = report.touch || !found.touching.empty() ||
                     std::ranges::any_of(found.nested, [](const auto &n) { return n.how != nesting::unknown; });
      if (q.any && report.touch)
        break;
    }
  }
  std::vector<std::string> written = q.pairs ? write_pairs(q, s, answers, outputs) : std::vector<std::string>{};
  if (q.image) {
    const bodies_picture picture(s, from, frames, answers);
    outputs.write(*q.image, [&](const fs::path &to) { picture.write(to, q.view); });
    written.push_back(q.image->string() + picture.frame_in_words());
  }
  if (q.page) {
    outputs.write(*q.page, [&](const fs::path &to) { write_page(to, q, s, from, frames, answers); });
    written.push_back(q.page->string());
  }
  outputs.commit();
  report.text = q.json ? in_one_line(as_json(q, s, answers)) + '\n' : summary(q, s, answers);
  if (!q.json)
    for (const std::string &file : written)
      report.text += fmt::format("wrote {}\n", file);
  return report;
}

} // namespace meetc::app
