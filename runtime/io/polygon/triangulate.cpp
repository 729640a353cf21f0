#include "meet/io/polygon/triangulate.hpp"

#include "meet/core/threads/threads.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/polygon/ears.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meetc::io {

namespace {

struct polygon_counts {
  std::size_t polygons = 0, not_planar = 0;
  double distance = 0;                    // the largest
  std::vector<std::size_t> far, crossing; // faces

  void add(const polygon_counts &more) {
    polygons += more.polygons;
    not_planar += more.not_planar;
    distance = std::max(distance, more.distance);
    far.insert(far.end(), more.far.begin(), more.far.end());
    crossing.insert(crossing.end(), more.crossing.begin(), more.crossing.end());
  }
};

// Cuts one polygon after another.
class polygon_cutter {
public:
  polygon_cutter(const std::vector<float> &xyz, double far, polygon_counts &found)
      : xyz_(xyz), far_(far), found_(found) {}

  void cut(std::size_t face, std::span<const std::uint32_t> corners, std::uint32_t *triangles) {
    if (corners.size() == 3) {
      std::ranges::copy(corners, triangles);
      return;
    }
    ++found_.polygons;
    points_.clear();
    for (const std::uint32_t c : corners)
      points_.insert(points_.end(),
                     {xyz_[3 * std::size_t{c}], xyz_[3 * std::size_t{c} + 1], xyz_[3 * std::size_t{c} + 2]});
    const polygon_plane plane(points_);
    if (const double d = plane.distance(); d > 0) {
      ++found_.not_planar;
      found_.distance = std::max(found_.distance, d);
      if (d > far_)
        found_.far.push_back(face);
    }
    bool whole = true;
    if (plane.axis() >= 0) {
      whole = cut_along(plane.axis(), plane.side() < 0, triangles);
    } else { // without area: projected along the first axis that leaves more than a line, or else along the last
      int axis = 0;
      while (axis < 2 && is_line(axis))
        ++axis;
      whole = cut_along(axis, false, triangles);
    }
    if (!whole)
      found_.crossing.push_back(face);
    for (std::size_t i = 0; i < 3 * (corners.size() - 2); ++i)
      triangles[i] = corners[triangles[i]];
  }

private:
  void project(int axis, bool mirrored) {
    const auto x = static_cast<std::size_t>((axis + 1) % 3), y = static_cast<std::size_t>((axis + 2) % 3);
    flat_.clear();
    for (std::size_t i = 0; i < points_.size(); i += 3) {
      const double a = static_cast<double>(points_[i + x]), b = static_cast<double>(points_[i + y]);
      flat_.push_back(mirrored ? projected{b, a} : projected{a, b});
    }
  }
  bool cut_along(int axis, bool mirrored, std::uint32_t *triangles) {
    project(axis, mirrored);
    return ears_.cut(flat_, triangles);
  }
  bool is_line(int axis) {
    project(axis, false);
    for (std::size_t i = 2; i < flat_.size(); ++i)
      if (turn(flat_[0], flat_[i - 1], flat_[i], room_) != 0)
        return false;
    return true;
  }

  const std::vector<float> &xyz_;
  double far_;
  polygon_counts &found_;
  std::vector<float> points_;
  std::vector<projected> flat_;
  ear_cutter ears_;
  exact_sum room_;
};

double longest_side(const std::vector<float> &xyz) {
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    float lo = HUGE_VALF, hi = -HUGE_VALF;
    for (std::size_t i = k; i < xyz.size(); i += 3) {
      lo = std::min(lo, xyz[i]);
      hi = std::max(hi, xyz[i]);
    }
    most = std::max(most, static_cast<double>(hi) - static_cast<double>(lo));
  }
  return most;
}

// "face 3", "faces 3, 7 and 12 more"
std::string in_words(const std::vector<std::size_t> &faces) {
  constexpr std::size_t most = 10;
  std::string out = faces.size() == 1 ? "face " : "faces ";
  for (std::size_t i = 0; i < std::min(faces.size(), most); ++i)
    out += fmt::format("{}{}", i == 0 ? "" : ", ", faces[i]);
  return faces.size() > most ? out + fmt::format(" and {} more", faces.size() - most) : out;
}

void note(const polygon_counts &f, std::vector<std::string> &notes) {
  if (f.not_planar > 0) {
    std::string text =
        fmt::format("{} of {} polygons {} not planar: a corner is {:.3g} from the plane through the first one "
                    "at most",
                    f.not_planar, f.polygons, f.not_planar == 1 ? "is" : "are", f.distance);
    if (!f.far.empty())
      text += fmt::format("; more than 2^-20 of the longest side: {}", in_words(f.far));
    notes.push_back(std::move(text));
  }
  if (!f.crossing.empty())
    notes.push_back(fmt::format("{} polygon{}: the rest, of which no corner can be cut off, is fanned: {}",
                                f.crossing.size(), f.crossing.size() == 1 ? " crosses itself" : "s cross themselves",
                                in_words(f.crossing)));
}

} // namespace

void cut_polygons(const std::string &file, vertex_lists &&faces, int threads, element_set &set) {
  set.items = faces.lists;
  if (faces.counts.empty()) {
    set.index = std::move(faces.vertices);
    return;
  }
  // The start of each block of faces among corners and triangles.
  constexpr std::size_t block = 256;
  struct start {
    std::size_t corner, triangle;
  };
  std::vector<start> starts{{0, 0}};
  std::size_t corners = 0, triangles = 0;
  for (std::size_t i = 0; i < faces.lists; ++i) {
    if (i > 0 && i % block == 0)
      starts.push_back({corners, triangles});
    corners += faces.count(i);
    triangles += faces.count(i) - 2;
  }
  if (triangles > most_elements)
    throw error(fmt::format("{}: {} triangles; at most {} can be numbered", file, triangles, most_elements));
  set.index.resize(3 * triangles);
  set.owner.resize(triangles);
  std::vector<polygon_counts> found(starts.size());
  const double far = longest_side(set.data) * 0x1p-20;
  for_chunks(threads, starts.size(), 1, [&](int, std::size_t b, std::size_t) {
    polygon_cutter cutter(set.data, far, found[b]);
    auto [corner, triangle] = starts[b];
    for (std::size_t i = b * block; i < std::min(faces.lists, (b + 1) * block); ++i) {
      const std::size_t n = faces.count(i);
      cutter.cut(i, std::span(faces.vertices).subspan(corner, n), &set.index[3 * triangle]);
      std::fill_n(set.owner.begin() + static_cast<std::ptrdiff_t>(triangle), n - 2, static_cast<std::uint32_t>(i));
      corner += n;
      triangle += n - 2;
    }
  });
  polygon_counts all;
  for (const polygon_counts &f : found)
    all.add(f);
  note(all, set.notes);
  set.polygons = std::move(faces);
}

} // namespace meetc::io
