// bench/scenes/paper_bodies.hpp: the meshes for the paper's tables: a Bunny of 1K triangles, and an Armadillo in many sizes.
//
// Method: from a folder, bunny_1k.ply and every armadillo_*.ply, in the order of their sizes; without one, procedural
// bodies of the same sizes, a ring for the Bunny and a knot for the Armadillo. For sizes beyond the largest mesh, its
// triangles are cut into four at the midpoints of their edges, in the file's own coordinates and before the pose, so
// that `meet collide` gives the same counts for the same files.
// Limits: the paper does not give its pose. Ours brings about as large a share of the first row's triangles into
// contact as the paper counted.
#ifndef MEETC_BENCH_SCENES_PAPER_BODIES_HPP
#define MEETC_BENCH_SCENES_PAPER_BODIES_HPP

#include "meet/bodies/meshes.hpp"
#include "meet/io/elements/element_set.hpp"
#include "meet/io/elements/transform.hpp"
#include "meetc/support.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

class paper_bodies {
public:
  // Throws io::error for a missing folder, missing files, or a file that cannot be read.
  paper_bodies(const catalogue &all, const std::optional<std::filesystem::path> &folder, bool quick);

  const io::element_set &bunny() const { return bunny_; }
  const std::string &bunny_name() const { return bunny_name_; }
  const std::string &armadillo_name() const { return armadillo_name_; }
  const io::element_set &fine_bunny() const { return fine_ ? *fine_ : bunny_; } // for pictures
  // Passes every size of the Armadillo in its pose, smallest first, with one in memory at a time.
  void each_armadillo(const std::function<void(const io::element_set &, const std::string &name)> &take) const;
  const io::transform &pose() const { return pose_; } // of the Armadillo
  std::string pose_options() const;                   // as options of `meet collide`
  std::size_t sizes() const;                          // that each_armadillo() will pass
  std::string in_words() const;
  // The Bunny with each triangle cut into four, repeated this many times.
  io::element_set finer_bunny(int times) const;

private:
  void read_folder(const std::filesystem::path &folder);
  io::element_set load(std::size_t i, const io::transform &move) const;

  const catalogue &all_;
  io::element_set bunny_;
  std::optional<io::element_set> fine_;
  std::string bunny_name_, armadillo_name_;
  io::transform pose_;
  std::size_t most_; // triangles in the largest mesh to make
  struct size {
    std::size_t triangles;
    std::filesystem::path file;              // or
    std::function<bodies::mesh()> make = {}; // a procedural body
  };
  std::vector<size> given_;
};

} // namespace meetc::bench

#endif
