// trueform: trees of boxes over float, and its test of two polygons, on the threads of an arena of oneTBB.
#include "meet/bench/peers/each.hpp"

#include <tbb/task_arena.h>
#include <trueform/core.hpp>
#include <trueform/spatial.hpp>
#include <trueform/version.hpp>

#include <iterator>
#include <utility>

namespace meetc::bench::peers {

namespace {

// Its view of the rows: three points of each triangle's own, so corner k is point k.
auto polygons_of(packed_rows rows) {
  return tf::make_polygons(tf::make_blocked_range<3>(tf::make_sequence_range(static_cast<int>(3 * rows.count))),
                           tf::make_points<3>(tf::make_range(rows.data, 9 * rows.count)));
}

class tree_finder final : public pair_finder {
public:
  tree_finder(packed_rows a, packed_rows b, const finder_settings &by) : rows_a_(a), rows_b_(b), arena_(by.threads) {}
  void build() override {
    arena_.execute([this] {
      const tf::tree_config sizes = tf::config_tree(4, 4); // those of its own measurements
      a_.build(polygons_of(rows_a_), sizes);
      b_.build(polygons_of(rows_b_), sizes);
    });
  }
  void query(std::vector<index_pair> &found) override {
    pairs_.clear();
    arena_.execute([this] {
      tf::gather_ids(polygons_of(rows_a_) | tf::tag(a_), polygons_of(rows_b_) | tf::tag(b_), tf::intersects_f,
                     tf::intersects_f, std::back_inserter(pairs_));
    });
    found.clear();
    for (const auto &[a, b] : pairs_)
      found.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
  }

private:
  packed_rows rows_a_, rows_b_;
  tbb::task_arena arena_;
  tf::aabb_tree<int, float, 3> a_, b_;
  std::vector<std::pair<int, int>> pairs_;
};

} // namespace

library trueform() {
  return {"trueform",
          true,
          POLYDERA_TF_VERSION_STRING,
          "with this program's baseline flags",
          {{"trueform, AABB tree", finds::touching,
            [](packed_rows a, packed_rows b, const finder_settings &by) {
              return std::make_unique<tree_finder>(a, b, by);
            }}},
          {}};
}

} // namespace meetc::bench::peers
