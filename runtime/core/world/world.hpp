// core/world/world.hpp: many bodies, each a set in a pose, and which of them touch.
//
// A set is prepared once, in its own frame. Moving a body costs nothing until it is asked what touches: then the bounds of all
// bodies are posed, and of the bodies that come near each other those elements that lie near the other's bounds
// (core/sets/posed_blocks.hpp). Answers are those of sets that were prepared in the poses, bit for bit.
#ifndef MEETC_CORE_WORLD_WORLD_HPP
#define MEETC_CORE_WORLD_WORLD_HPP

#include "meet/core/query/collide.hpp"
#include "meet/core/query/fitting.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace meetc {

struct execution;

struct world_options {
  answer_kind want = answer_kind::count; // for each pair of bodies
  rung precision = rung::certified;
  std::span<const std::uint32_t> of = {}; // only pairs of one of these bodies and another one; empty: all
  bool first = false;                     // stop at the first pair of bodies that touches: of all of them the least
  // Also tell of two bodies near each other that do not touch whether one lies inside the other. With `first`, only where
  // nothing touches, up to the first two of which it is known.
  bool nested = false;
  int threads = 0;                                    // 0: all cores
  float box = 0;                                      // as collide_options::box
  std::function<void(double fraction)> progress = {}; // on the calling thread, about ten times a second
  std::stop_token stop = {};                          // as in collide_options
};

// Two bodies that touch, a < b. In the answer, a's elements (or items) come first.
struct touching_bodies {
  std::uint32_t a, b;
  result found;
};

// How the one of two bodies that do not touch lies in the other.
enum class nesting : std::uint8_t {
  a_inside_b, // all of a
  b_inside_a,
  overlapping, // a part of one lies inside the other, and neither lies inside the other as a whole
  unknown
};

// The two, a < b.
struct nested_bodies {
  std::uint32_t a, b;
  nesting how;
  std::string why; // of unknown
};

struct world_answer {
  std::vector<touching_bodies> touching; // sorted by a, then b
  std::vector<nested_bodies> nested;     // likewise; of bodies that are apart there is none
  std::uint64_t near = 0;                // pairs of bodies whose bounds touch and that are not ignored
  std::uint64_t candidates = 0;          // pairs of elements that were decided
  double pose_seconds = 0, collide_seconds = 0;
};

// Two bodies whose bounds touch and that are not ignored, a < b, and the predicate that decides them.
struct near_bodies {
  std::uint32_t a, b;
  choice by;

  // The operands of the predicate.
  std::uint32_t first() const { return by.swapped ? b : a; }
  std::uint32_t second() const { return by.swapped ? a : b; }
  // Its answer, about the bodies.
  touching_bodies told(result found) const;
};

// It may be asked by several threads at once, and changed by one at a time while none asks.
class world {
public:
  // The predicate of two bodies is the first of the catalogue, which must outlive this, that fits and answers for the mode,
  // "solid" or "surface".
  explicit world(const catalogue &all, std::string_view mode = "solid");

  // Adds a body, and returns its number; bodies are numbered from 0. One shape may be that of many bodies. owners: as
  // collide_options::owner_a. Throws usage_error where the name is taken or empty, the shape is not whole, owners are
  // not one for each element, or the kind cannot stand in this pose.
  std::uint32_t add(std::string name, std::shared_ptr<const prepared> shape, const pose &at = {},
                    std::vector<std::uint32_t> owners = {});
  // Throws std::out_of_range for a body that is not there; usage_error where the kind cannot stand in the pose.
  void move(std::uint32_t body, const pose &at);
  // Whether the two bodies are asked about; at first, all are. Throws std::out_of_range.
  void ignore(std::uint32_t a, std::uint32_t b, bool ignored = true);

  std::size_t size() const { return bodies_.size(); }
  const std::string &name(std::uint32_t body) const { return bodies_.at(body).name; }
  const pose &at(std::uint32_t body) const { return bodies_.at(body).at; }
  const prepared &shape(std::uint32_t body) const { return *bodies_.at(body).shape; }
  std::span<const std::uint32_t> owners(std::uint32_t body) const { return bodies_.at(body).owners; }
  std::optional<std::uint32_t> find(std::string_view name) const;

  // Throws usage_error where no predicate fits two bodies that are near each other, or is not generated for the
  // precision, or `nested` is asked in the mode "surface", for a precision that may be wrong or of a catalogue without winding
  // numbers; std::out_of_range for a body of options.of that is not there; input_error where an element is not finite in its
  // pose, or breaks a rule of its kind there; std::bad_alloc; cancelled.
  world_answer touching(const world_options &options = {}) const;
  // The pairs of bodies that touching() decides, sorted by a, then b. of: as in the options. Throws likewise.
  std::vector<near_bodies> near(std::span<const std::uint32_t> of = {}) const;
  // The part of touching() with `nested`, for those of these that do not touch. Throws likewise.
  std::vector<nested_bodies> nested(std::span<const near_bodies> apart, const world_options &options) const;

private:
  struct entry {
    std::string name;
    std::shared_ptr<const prepared> shape;
    pose at;
    std::vector<std::uint32_t> owners;
  };
  choice predicate_of(const entry &a, const entry &b) const;
  std::vector<box> bounds() const;
  std::vector<near_bodies> near_pairs(std::span<const box> bounds, std::span<const std::uint32_t> of,
                                      const execution &on) const;
  void pose_shapes(std::span<const box> bounds, std::span<const near_bodies> pairs, const execution &on,
                   std::vector<prepared> &shapes) const;
  result collide_pair(const near_bodies &p, std::span<const prepared> shapes, const world_options &options,
                      int threads) const;
  std::vector<nested_bodies> nested_pairs(std::span<const near_bodies> apart, bool first, const execution &on) const;
  void require_nesting(const world_options &options) const;
  world_answer ask(const world_options &options) const;

  const catalogue &all_;
  std::string mode_;
  std::vector<entry> bodies_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> ignored_; // the lesser first
  // The posed shapes of an earlier question, whose memory the next one uses.
  std::unique_ptr<std::mutex> lock_ = std::make_unique<std::mutex>();
  mutable std::vector<prepared> spare_;
};

} // namespace meetc

#endif
