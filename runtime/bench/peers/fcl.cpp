// FCL: trees of oriented boxes (OBBRSS) over double.
#include "meet/bench/peers/each.hpp"

#include <fcl/config.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <limits>

namespace meetc::bench::peers {

namespace {

using model = fcl::BVHModel<fcl::OBBRSSd>;

class obb_finder final : public pair_finder {
public:
  obb_finder(packed_rows a, packed_rows b) : rows_a_(a), rows_b_(b) {}
  void build() override {
    a_ = model_of(rows_a_);
    b_ = model_of(rows_b_);
  }
  void query(std::vector<index_pair> &found) override {
    found.clear();
    fcl::CollisionRequestd request;
    request.num_max_contacts = std::numeric_limits<std::size_t>::max();
    request.enable_contact = false;
    fcl::CollisionResultd result;
    fcl::collide(a_.get(), fcl::Transform3d::Identity(), b_.get(), fcl::Transform3d::Identity(), request, result);
    for (std::size_t i = 0; i < result.numContacts(); ++i) {
      const fcl::Contactd &contact = result.getContact(i);
      found.push_back({static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
    }
  }

private:
  static std::unique_ptr<model> model_of(packed_rows rows) {
    auto m = std::make_unique<model>();
    m->beginModel(static_cast<int>(rows.count), static_cast<int>(3 * rows.count));
    for (std::size_t i = 0; i < rows.count; ++i) {
      const float *const row = rows.data + 9 * i;
      const auto point = [row](std::size_t p) { return fcl::Vector3d(row[3 * p], row[3 * p + 1], row[3 * p + 2]); };
      m->addTriangle(point(0), point(1), point(2));
    }
    m->endModel();
    return m;
  }
  packed_rows rows_a_, rows_b_;
  std::unique_ptr<model> a_, b_;
};

} // namespace

library fcl() {
  return {"FCL",
          true,
          FCL_VERSION,
          "its package's baseline build; it uses one thread",
          {{"FCL, OBBRSS", finds::touching,
            [](packed_rows a, packed_rows b, const finder_settings &) { return std::make_unique<obb_finder>(a, b); }}},
          {}};
}

} // namespace meetc::bench::peers
