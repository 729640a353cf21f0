// Shared by the tests of whole queries on the device: sets, the CPU's answers next to the device's, and a table.
#pragma once
#include "meet/core/device/collide.hpp"
#include "meet/core/device/every_pair/engine.hpp"

#include <cga/cga_runtime.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace cuda_test {

using engine = std::mt19937_64;

const char *name_of(meetc::rung r);
const char *name_of(meetc::every_pair::filter f);
inline constexpr meetc::rung all_rungs[] = {meetc::rung::fp32, meetc::rung::fp64, meetc::rung::fp64x2,
                                            meetc::rung::exact, meetc::rung::certified};
const meetc::predicate_info &predicate_named(std::string_view name);
void each_predicate(const std::function<void(const meetc::predicate_info &)> &f);

// Whether a rung that is never wrong looks at fewer candidates on the CPU, which tests the two points of an element.
bool fewer_candidates_on_cpu(const meetc::predicate_info &p);
// The CPU's catalogue whose lanes fuse as a device does; null: none runs here.
const meetc::catalogue *fusing();
// Whether `certified` may leave fewer pairs unsure on the CPU, which also normalises very small and very large sets, and where
// nothing fuses has other bounds.
bool fewer_unsure_on_cpu(const meetc::predicate_info &p, const meetc::prepared &a, const meetc::prepared &b);

// ---- sets ----

// Rows of a kind, in the caller's order.
struct rows_of {
  const meetc::kind_info *kind;
  std::vector<float> rows;
  std::size_t size() const { return rows.size() / static_cast<std::size_t>(kind->fields); }
};
meetc::view view_of(const rows_of &r);
// Those of a set that was prepared, in the caller's order.
rows_of rows_in(const meetc::prepared &set);
// Makes of a box's corners, which may be any two opposite ones, the least and the greatest. Other kinds stay as they are.
void put_in_order(rows_of &r);
// The pose; for a kind whose edges lie along the axes one that keeps them there, as large and at the same place.
meetc::pose pose_for(const meetc::kind_info &kind, const meetc::pose &at);

// n elements about points of a cube, each about `size` large, half of them on a lattice so that they touch exactly.
// Numbers are multiplied by `scale`, moved by `offset` and then rounded.
struct place {
  double cube = 1, size = 0.1, scale = 1, offset = 0;
};
rows_of random_rows(const meetc::kind_info &kind, std::size_t n, const place &at, engine &random);
// The families of cuda_test.hpp: one of them, or all where it is below 0.
rows_of family_rows(const meetc::kind_info &kind, std::size_t n, int family, engine &random);
// One row, n times.
rows_of same_rows(const meetc::kind_info &kind, std::size_t n);

// ---- what a filter of every pair may pass ----

// Counts that a device may give: `least` if every doubtful pair is dropped, `most` if every one is kept. In float32 no
// pair is doubtful.
struct range {
  std::uint64_t least = 0, most = 0;
  bool holds(std::uint64_t n) const { return least <= n && n <= most; }
};
struct expectation {
  range near, candidates;
  std::uint64_t most_unsure = 0; // in fp32
};
// The expectation for `certified`, element by element, from the host's own columns, pair by pair.
expectation expect(const meetc::predicate_info &p, const meetc::prepared &a, const meetc::prepared &b,
                   meetc::every_pair::filter by);

// ---- comparing ----

struct options {
  std::span<const std::uint32_t> owner_a = {}, owner_b = {};
  std::size_t list_capacity = std::size_t{1} << 25;
  bool all_modes = false; // count and any, too
  bool expectations = false;
  bool all_filters = true; // of every pair; else the best
};

bool same_list(const std::vector<meetc::index_pair> &x, const std::vector<meetc::index_pair> &y);
// Whether a set that was made on the device lies in the order of its places, those with one place in that of their numbers.
bool is_in_order(const meetc::device_set &there, const meetc::prepared &set);

struct line {
  long queries = 0, differences = 0;
  std::uint64_t pairs = 0, candidates = 0, unsure = 0, most_parts = 0;
  double device_ms = 0;
};

class comparison {
public:
  explicit comparison(meetc::device &on);

  meetc::device &on() const { return on_; }
  meetc::every_pair::engine &every_pair() { return every_pair_; }
  // Those that the device offers.
  const std::vector<meetc::every_pair::filter> &filters() const { return filters_; }

  // Compares every rung of `rungs` with the CPU: by a query, by every pair with every filter, and by a query on sets as they
  // are given, culled or not. Differences are counted under the scene's name and printed.
  void same(const std::string &scene, const meetc::predicate_info &p, const meetc::prepared &a,
            const meetc::prepared &b, std::span<const meetc::rung> rungs, const options &o = {});
  // The same, but for given sets, for sets that are on the device already, in the poses in which a and b were prepared.
  void same(const std::string &scene, const meetc::predicate_info &p, const meetc::prepared &a, meetc::device_set &da,
            const meetc::prepared &b, meetc::device_set &db, std::span<const meetc::rung> rungs, const options &o = {});
  // The same for given sets.
  void same_given(const std::string &scene, const meetc::predicate_info &p, const meetc::prepared &a,
                  meetc::device_set &ga, const meetc::prepared &b, meetc::device_set &gb,
                  std::span<const meetc::rung> rungs, const options &o = {});
  // Any other condition.
  void require(const std::string &scene, bool holds, const std::string &what);
  // The figures of one query, or of every pair, under the scene's name.
  template <class Result> void add(const std::string &scene, const meetc::predicate_info &p, const Result &r) {
    add(scene, p, r, r.parts, r.device_seconds);
  }

  void print() const; // a line a scene and predicate
  long differences() const;

private:
  using key = std::pair<std::string, std::string>;
  struct way {
    const char *name;
    bool culled = false; // of sets as they are given
  };
  using query = std::function<meetc::device_result(const way &, meetc::rung, meetc::device_options &)>;
  void compare(const std::string &scene, const meetc::predicate_info &p, const meetc::prepared &a,
               const meetc::prepared &b, std::span<const meetc::rung> rungs, const options &o,
               const std::vector<way> &ways, const query &ask);
  void compare_every_pair(const std::string &scene, const meetc::predicate_info &p, const meetc::prepared &a,
                          meetc::device_set &da, const meetc::prepared &b, meetc::device_set &db,
                          std::span<const meetc::rung> rungs, const options &o);
  void add(const std::string &scene, const meetc::predicate_info &p, const meetc::result &r, std::uint64_t parts,
           double device_seconds);
  void fail(const key &of, const std::string &what);
  line &at(const key &of);

  meetc::device &on_;
  meetc::every_pair::engine every_pair_;
  std::vector<meetc::every_pair::filter> filters_;
  std::vector<key> order_;
  std::map<key, line> lines_;
  long printed_ = 0;
};

// ---- programs ----

struct settings {
  bool small = false; // few and small sets, for tools that slow everything down
  std::uint64_t seed = 1;
  std::string data; // a folder of meshes: those are compared, and nothing else
  std::string part; // of the scenes: a name of engine_main.cpp, or reset; empty: all
};
void pair_scenes(comparison &with, const settings &s);
void again_scenes(comparison &with, const settings &s);
void every_pair_scenes(comparison &with, const settings &s);
void caller_scenes(comparison &with, const settings &s); // of every pair, too
void made_scenes(comparison &with, const settings &s);
void order_scenes(comparison &with, const settings &s);
void given_scenes(comparison &with, const settings &s);
void device_scenes(comparison &with, const settings &s);
void pose_scenes(comparison &with, const settings &s);
void end_scenes(comparison &with, const settings &s);
void group_scenes(comparison &with, const settings &s);
void word_scenes(comparison &with, const settings &s);
void formula_scenes(comparison &with, const settings &s);
void body_scenes(comparison &with, const settings &s);
void contact_scenes(comparison &with, const settings &s);
void self_scenes(comparison &with, const settings &s);
void stop_scenes(comparison &with, const settings &s);
void mesh_scenes(comparison &with, const settings &s);
// Triangles: where these pairs meet, and where a mesh crosses itself, under the scene's name.
void same_contacts(comparison &with, const std::string &scene, const meetc::view &a, const meetc::view &b,
                   const meetc::predicate_info &p, std::span<const meetc::index_pair> pairs);
void same_self(comparison &with, const std::string &scene, const meetc::view &mesh);
// Whether a device that was reset answers as it did before. No other device object may exist meanwhile.
bool answers_after_reset();

} // namespace cuda_test
