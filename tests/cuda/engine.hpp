// What the tests of whole queries on the device share: sets, the CPU's answers beside the device's, and a table.
#pragma once
#include "core/device/collide.hpp"

#include <cga/cga_runtime.hpp>

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace cuda_test {

using engine = std::mt19937_64;

const char *name_of(meet::rung r);
const char *name_of(meet::cuda::filter f);
inline constexpr meet::rung all_rungs[] = {meet::rung::fp32, meet::rung::fp64, meet::rung::fp64x2, meet::rung::exact,
                                           meet::rung::certified};
inline bool never_wrong(meet::rung r) { return r == meet::rung::exact || r == meet::rung::certified; }
const meet::predicate_info &predicate_named(std::string_view name);

// ---- sets -------------------------------------------------------------------------------------------------------

// Rows of a kind, in the caller's order.
struct rows_of {
  const meet::kind_info *kind;
  std::vector<float> rows;
  std::size_t size() const { return rows.size() / static_cast<std::size_t>(kind->fields); }
};
meet::view view_of(const rows_of &r);

// n elements about points of a cube, each about `size` large; half of them on a lattice, so that they touch exactly.
// Numbers are multiplied by `scale` and moved by `offset`, then rounded.
struct place {
  double cube = 1, size = 0.1, scale = 1, offset = 0;
};
rows_of random_rows(const meet::kind_info &kind, std::size_t n, const place &at, engine &random);
// The families of cuda_test.hpp: one of them, or all where it is below 0.
rows_of family_rows(const meet::kind_info &kind, std::size_t n, int family, engine &random);
// One row, n times.
rows_of same_rows(const meet::kind_info &kind, std::size_t n);

// ---- what the filter may let through ------------------------------------------------------------------------------

// Counts that a device may give: `least` where every doubt falls one way, `most` where it falls the other. In float32
// there is no doubt.
struct range {
  std::uint64_t least = 0, most = 0;
  bool holds(std::uint64_t n) const { return least <= n && n <= most; }
};
struct expectation {
  range near_balls, candidates, unsure[meet::bounded_rungs];
};
// Of `certified`, element by element, from the host's own columns, pair by pair.
expectation expect(const meet::predicate_info &p, const meet::prepared &a, const meet::prepared &b, meet::cuda::filter by);

// ---- comparing ----------------------------------------------------------------------------------------------------

struct options {
  std::span<const std::uint32_t> owner_a = {}, owner_b = {};
  std::size_t list_capacity = std::size_t{1} << 25;
  bool all_modes = false; // count and any, too
  bool expectations = false;
  bool all_filters = true; // else the best
};

struct line {
  long queries = 0, differences = 0;
  std::uint64_t pairs = 0, near_balls = 0, candidates = 0, unsure = 0, most_parts = 0;
  double device_ms = 0;
};

class comparison {
public:
  explicit comparison(meet::device &on);

  meet::device &on() const { return on_; }
  const std::vector<meet::cuda::filter> &filters() const { return filters_; }
  // Filters by elements and by groups, as the options ask.
  std::vector<std::pair<meet::cuda::filter, meet::cuda::grouping>> ways(const options &o = {}) const;

  // Every rung of `rungs` by every filter against the CPU; differences are counted under the scene's name and printed.
  void same(const std::string &scene, const meet::predicate_info &p, const meet::prepared &a, const meet::prepared &b,
            std::span<const meet::rung> rungs, const options &o = {});
  // The same for sets that are on the device already, under whatever pose a and b were prepared with.
  void same(const std::string &scene, const meet::predicate_info &p, const meet::prepared &a, meet::device_set &da,
            const meet::prepared &b, meet::device_set &db, std::span<const meet::rung> rungs, const options &o = {});
  // Anything else that has to hold.
  void require(const std::string &scene, bool holds, const std::string &what);
  // One query's figures, under the scene's name.
  void add(const std::string &scene, const meet::predicate_info &p, const meet::device_result &r);

  void print() const; // a line a scene and predicate
  long differences() const;

private:
  using key = std::pair<std::string, std::string>;
  void fail(const key &of, const std::string &what);
  line &at(const key &of);

  meet::device &on_;
  std::vector<meet::cuda::filter> filters_;
  std::vector<key> order_;
  std::map<key, line> lines_;
  long printed_ = 0;
};

// ---- programs -----------------------------------------------------------------------------------------------------

struct settings {
  bool small = false; // few and small sets, for tools that slow everything down
  std::uint64_t seed = 1;
  std::string data; // a folder of meshes: those are compared, and nothing else
  std::string part; // of the scenes: pairs, poses or ends; empty: all
};
void pair_scenes(comparison &with, const settings &s);
void pose_scenes(comparison &with, const settings &s);
void end_scenes(comparison &with, const settings &s);
void mesh_scenes(comparison &with, const settings &s);

} // namespace cuda_test
