// CGAL: a tree of boxes, and a sweep over boxes, with its kernel of exact predicates.
#include "meet/bench/peers/each.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

namespace meetc::bench::peers {

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using triangles = std::vector<kernel::Triangle_3>;

triangles triangles_of(packed_rows rows) {
  triangles out;
  for (std::size_t i = 0; i < rows.count; ++i) {
    const float *const row = rows.data + 9 * i;
    const auto point = [row](std::size_t p) { return kernel::Point_3(row[3 * p], row[3 * p + 1], row[3 * p + 2]); };
    out.emplace_back(point(0), point(1), point(2));
  }
  return out;
}

std::uint32_t number(std::size_t i) {
  return static_cast<std::uint32_t>(i);
}

// The tree holds b; each triangle of a asks for what it touches.
class tree_finder final : public pair_finder {
public:
  tree_finder(packed_rows a, packed_rows b) : a_(triangles_of(a)), b_(triangles_of(b)) {}
  void build() override {
    tree_.clear();
    tree_.insert(b_.begin(), b_.end());
    tree_.build();
  }
  void query(std::vector<index_pair> &found) override {
    found.clear();
    std::vector<triangles::const_iterator> hit;
    for (std::size_t i = 0; i < a_.size(); ++i) {
      hit.clear();
      tree_.all_intersected_primitives(a_[i], std::back_inserter(hit));
      for (const auto &at : hit)
        found.push_back({number(i), number(static_cast<std::size_t>(at - b_.begin()))});
    }
  }

private:
  using primitive = CGAL::AABB_triangle_primitive<kernel, triangles::const_iterator>;
  const triangles a_, b_;
  CGAL::AABB_tree<CGAL::AABB_traits<kernel, primitive>> tree_;
};

class box_finder final : public pair_finder {
public:
  box_finder(packed_rows a, packed_rows b) : a_(triangles_of(a)), b_(triangles_of(b)) {}
  void build() override {
    boxes_a_ = boxes_of(a_);
    boxes_b_ = boxes_of(b_);
  }
  void query(std::vector<index_pair> &found) override {
    found.clear();
    CGAL::box_intersection_d(boxes_a_.begin(), boxes_a_.end(), boxes_b_.begin(), boxes_b_.end(),
                             [&](const box &x, const box &y) {
                               if (CGAL::do_intersect(a_[x.info()], b_[y.info()]))
                                 found.push_back({x.info(), y.info()});
                             });
  }

private:
  using box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
  static std::vector<box> boxes_of(const triangles &of) {
    std::vector<box> out;
    for (std::size_t i = 0; i < of.size(); ++i)
      out.emplace_back(of[i].bbox(), number(i));
    return out;
  }
  const triangles a_, b_;
  std::vector<box> boxes_a_, boxes_b_;
};

template <class Finder> std::unique_ptr<pair_finder> make(packed_rows a, packed_rows b, const finder_settings &) {
  return std::make_unique<Finder>(a, b);
}

} // namespace

library cgal() {
  return {"CGAL",
          true,
          CGAL_VERSION_STR,
          "with this program's baseline flags and -frounding-math; it uses one thread",
          {{"CGAL, AABB tree, EPICK", finds::touching, make<tree_finder>},
           {"CGAL, box_intersection_d, EPICK", finds::touching, make<box_finder>}},
          {}};
}

} // namespace meetc::bench::peers
