#include "meet/bench/scenes/paper_bodies.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/made_sets.hpp"
#include "meet/app/output/paint.hpp"
#include "meet/app/text/words.hpp"
#include "meet/io/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace meetc::bench {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t full_size = 6'000'000, quick_size = 100'000;

io::transform moved(double scale, double x, double y, double z) {
  io::transform t;
  t.scale = scale;
  t.translate = {x, y, z};
  return t;
}

// Polygons as the triangles of their fans.
bodies::mesh as_mesh(const io::element_set &set) {
  return {set.data, set.index};
}
io::element_set as_triangles(io::element_set set) {
  set.owner.clear();
  set.items = set.elements;
  return set;
}

// Whether the name is armadillo_345k.ply or similar.
bool is_armadillo(const fs::path &file) {
  const std::string name = file.filename().string();
  return name.rfind("armadillo_", 0) == 0 && file.extension() == ".ply" &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-';
         });
}

} // namespace

paper_bodies::paper_bodies(const catalogue &all, const std::optional<fs::path> &folder, bool quick)
    : all_(all), most_(quick ? quick_size : full_size) {
  if (folder) {
    read_folder(*folder);
  } else {
    bunny_ = app::of_mesh(all, bodies::torus(25, 20));
    bunny_name_ = "ring";
    armadillo_name_ = "knot";
    pose_ = moved(0.75, 0.25, 0.25, 0.125);
    constexpr std::array<std::array<int, 2>, 4> knots{{{100, 25}, {200, 50}, {400, 125}, {588, 294}}};
    for (const std::array<int, 2> &k : knots)
      given_.push_back({static_cast<std::size_t>(2 * k[0] * k[1]), {}, [k] { return bodies::knot(k[0], k[1]); }});
  }
  std::erase_if(given_, [this](const size &s) { return s.triangles > most_; });
  if (given_.empty())
    throw app::failure(
        fmt::format("{}: no armadillo_*.ply of up to {} triangles", folder->string(), app::grouped(most_)));
}

void paper_bodies::read_folder(const fs::path &folder) {
  std::error_code code;
  if (!fs::is_directory(folder, code))
    throw app::failure(fmt::format("--data {}: is not a folder", folder.string()));
  const std::vector<const kind_info *> kinds = app::kinds_of(all_);
  bunny_ = as_triangles(io::read(folder / "bunny_1k.ply", kinds));
  if (bunny_.elements == 0)
    throw app::failure(fmt::format("{}: holds no triangles", (folder / "bunny_1k.ply").string()));
  bunny_name_ = "Bunny";
  armadillo_name_ = "Armadillo";
  pose_ = moved(0.0013, 0, 0.08, 0.02);
  if (const fs::path fine = folder / "bunny_69k.ply"; fs::exists(fine, code))
    fine_ = as_triangles(io::read(fine, kinds));
  for (const fs::directory_entry &entry : fs::directory_iterator(folder, code))
    if (is_armadillo(entry.path()))
      given_.push_back({io::read(entry.path(), kinds).elements, entry.path()});
  if (code)
    throw app::failure(fmt::format("{}: cannot be read: {}", folder.string(), code.message()));
  std::sort(given_.begin(), given_.end(), [](const size &x, const size &y) {
    return std::pair(x.triangles, x.file) < std::pair(y.triangles, y.file);
  });
  std::erase_if(given_, [](const size &s) { return s.triangles == 0; });
  if (given_.empty())
    throw app::failure(fmt::format("--data {}: holds no armadillo_*.ply", folder.string()));
}

io::element_set paper_bodies::load(std::size_t i, const io::transform &move) const {
  const size &s = given_[i];
  return s.make ? app::of_mesh(all_, s.make(), move) : as_triangles(io::read(s.file, app::kinds_of(all_), move));
}

void paper_bodies::each_armadillo(const std::function<void(const io::element_set &, const std::string &)> &take) const {
  for (std::size_t i = 0; i < given_.size(); ++i)
    take(load(i, pose_), given_[i].file.filename().string());
  bodies::mesh m = as_mesh(load(given_.size() - 1, {}));
  for (int times = 1; 4 * m.triangles() <= most_; ++times) {
    m = bodies::subdivide(m);
    const std::string from = given_.back().file.filename().string();
    take(app::of_mesh(all_, m, pose_),
         fmt::format("{}cut in 4, {} time{}", from.empty() ? "" : from + ", ", times, times == 1 ? "" : "s"));
  }
}

std::size_t paper_bodies::sizes() const {
  std::size_t n = given_.size();
  for (std::size_t t = given_.back().triangles; 4 * t <= most_; t *= 4)
    ++n;
  return n;
}

std::string paper_bodies::pose_options() const {
  const auto &t = *pose_.translate;
  return fmt::format("{} {} {} {},{},{}", pose_.option("scale"), *pose_.scale, pose_.option("translate"), t[0], t[1],
                     t[2]);
}

std::string paper_bodies::in_words() const {
  if (given_.front().make)
    return "Built-in bodies in the place of the paper's: a ring for the Bunny, a knot for the Armadillo, of "
           "the "
           "same sizes.";
  std::string files;
  for (const size &s : given_)
    files += ", " + s.file.filename().string();
  return fmt::format("The meshes of {}: bunny_1k.ply{}.", given_.front().file.parent_path().filename().string(), files);
}

io::element_set paper_bodies::finer_bunny(int times) const {
  bodies::mesh m = as_mesh(bunny_);
  for (int i = 0; i < times; ++i)
    m = bodies::subdivide(m);
  return app::of_mesh(all_, std::move(m));
}

} // namespace meetc::bench
