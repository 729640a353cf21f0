// Embree: pairs of boxes of two scenes (rtcCollide), and all triangles on a segment, by rays whose filter keeps every hit.
#include "meet/bench/peers/each.hpp"

#include "meet/core/threads/threads.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>

namespace meetc::bench::peers {

namespace {

struct release_device {
  void operator()(RTCDeviceTy *d) const { rtcReleaseDevice(d); }
};
struct release_scene {
  void operator()(RTCSceneTy *s) const { rtcReleaseScene(s); }
};
using device = std::unique_ptr<RTCDeviceTy, release_device>;
using scene = std::unique_ptr<RTCSceneTy, release_scene>;

device new_device(const finder_settings &by) {
  const char *const isa = by.set == instruction_set::avx512 ? "avx512"
                          : by.set == instruction_set::avx2 ? "avx2"
                                                            : "sse2";
  device d(rtcNewDevice(("threads=" + std::to_string(by.threads) + ",max_isa=" + isa).c_str()));
  if (!d)
    throw std::runtime_error("Embree: no device");
  return d;
}

// A robust scene of one geometry.
scene new_scene(const device &on, RTCBuildQuality quality, RTCGeometry geometry) {
  scene s(rtcNewScene(on.get()));
  rtcSetSceneFlags(s.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(s.get(), quality);
  rtcSetGeometryBuildQuality(geometry, quality);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(s.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(s.get());
  if (rtcGetDeviceError(on.get()) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree: a scene could not be built");
  return s;
}

void bounds_of_triangle(const RTCBoundsFunctionArguments *args) {
  const float *const row =
      static_cast<const packed_rows *>(args->geometryUserPtr)->data + std::size_t{9} * args->primID;
  const auto ends = [row](std::size_t k) { return std::minmax({row[k], row[3 + k], row[6 + k]}); };
  const auto x = ends(0), y = ends(1), z = ends(2);
  RTCBounds &to = *args->bounds_o;
  to.lower_x = x.first, to.lower_y = y.first, to.lower_z = z.first;
  to.upper_x = x.second, to.upper_y = y.second, to.upper_z = z.second;
}

// Lists of pairs that several threads fill: each has its own, since a lock would cost more than a pair.
class lists_by_thread {
public:
  std::vector<index_pair> &mine() {
    thread_local std::uint64_t owner = 0;
    thread_local std::vector<index_pair> *list = nullptr;
    if (owner != number_) {
      const std::lock_guard lock(adding_);
      lists_.push_back(std::make_unique<std::vector<index_pair>>());
      list = lists_.back().get();
      owner = number_;
    }
    return *list;
  }
  void gather(std::vector<index_pair> &to) const {
    to.clear();
    for (const auto &list : lists_)
      to.insert(to.end(), list->begin(), list->end());
  }

private:
  static std::uint64_t next_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
  }
  const std::uint64_t number_ = next_number();
  std::mutex adding_;
  std::vector<std::unique_ptr<std::vector<index_pair>>> lists_;
};

class box_pairs final : public pair_finder {
public:
  box_pairs(RTCBuildQuality quality, packed_rows a, packed_rows b, const finder_settings &by)
      : quality_(quality), a_(a), b_(b), device_(new_device(by)) {}
  void build() override {
    scene_a_ = boxes_of(a_);
    if (b_.data != a_.data)
      scene_b_ = boxes_of(b_);
  }
  void query(std::vector<index_pair> &found) override {
    lists_by_thread lists;
    rtcCollide(
        scene_a_.get(), (scene_b_ ? scene_b_ : scene_a_).get(),
        [](void *to, RTCCollision *pairs, unsigned n) {
          std::vector<index_pair> &list = static_cast<lists_by_thread *>(to)->mine();
          for (unsigned i = 0; i < n; ++i)
            list.push_back({pairs[i].primID0, pairs[i].primID1});
        },
        &lists);
    lists.gather(found);
  }

private:
  scene boxes_of(packed_rows &rows) const { // only geometry of the user's own can be collided
    RTCGeometry g = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(rows.count));
    rtcSetGeometryUserData(g, &rows);
    rtcSetGeometryBoundsFunction(
        g, [](const RTCBoundsFunctionArguments *args) { bounds_of_triangle(args); }, nullptr);
    rtcSetGeometryIntersectFunction(g, [](const RTCIntersectFunctionNArguments *) {});
    rtcSetGeometryOccludedFunction(g, [](const RTCOccludedFunctionNArguments *) {});
    return new_scene(device_, quality_, g);
  }
  RTCBuildQuality quality_;
  packed_rows a_, b_;
  device device_;
  scene scene_a_, scene_b_;
};

// A query's context with what its filter writes to.
struct segment_context {
  RTCIntersectContext context;
  std::vector<std::uint32_t> *hits;
};

class segment_hits final : public pair_finder {
public:
  segment_hits(RTCBuildQuality quality, packed_rows segments, packed_rows triangles, const finder_settings &by)
      : quality_(quality), threads_(by.threads), segments_(segments), triangles_(triangles), device_(new_device(by)) {}
  void build() override {
    RTCGeometry g = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t corners = 3 * triangles_.count;
    auto *const xyz = static_cast<float *>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corners));
    std::copy_n(triangles_.data, 3 * corners, xyz);
    auto *const index = static_cast<unsigned *>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles_.count));
    for (std::size_t i = 0; i < corners; ++i)
      index[i] = static_cast<unsigned>(i);
    // A hit that the filter takes note of and rejects does not end the ray.
    rtcSetGeometryOccludedFilterFunction(g, [](const RTCFilterFunctionNArguments *args) {
      if (args->valid[0] == 0)
        return;
      reinterpret_cast<segment_context *>(args->context)->hits->push_back(RTCHitN_primID(args->hit, args->N, 0));
      args->valid[0] = 0;
    });
    scene_ = new_scene(device_, quality_, g);
  }
  void query(std::vector<index_pair> &found) override {
    lists_by_thread lists;
    for_chunks(threads_, segments_.count, 64, [&](int, std::size_t from, std::size_t end) {
      std::vector<index_pair> &list = lists.mine();
      std::vector<std::uint32_t> hits;
      for (std::size_t i = from; i < end; ++i) {
        ask(segments_.data + 6 * i, hits);
        // A tree of high quality may hold a triangle in several places, and the filter then meets it more than once.
        std::sort(hits.begin(), hits.end());
        hits.erase(std::unique(hits.begin(), hits.end()), hits.end());
        for (const std::uint32_t t : hits)
          list.push_back({static_cast<std::uint32_t>(i), t});
      }
    });
    lists.gather(found);
  }

private:
  void ask(const float *s, std::vector<std::uint32_t> &hits) const {
    hits.clear();
    segment_context c{};
    rtcInitIntersectContext(&c.context);
    c.hits = &hits;
    RTCRay ray{};
    ray.org_x = s[0], ray.org_y = s[1], ray.org_z = s[2];
    ray.dir_x = s[3] - s[0], ray.dir_y = s[4] - s[1], ray.dir_z = s[5] - s[2];
    ray.tnear = 0, ray.tfar = 1;
    ray.mask = ~0U;
    rtcOccluded1(scene_.get(), &c.context, &ray);
  }
  RTCBuildQuality quality_;
  int threads_;
  packed_rows segments_, triangles_;
  device device_;
  scene scene_;
};

template <class Finder, RTCBuildQuality quality>
std::unique_ptr<pair_finder> make(packed_rows a, packed_rows b, const finder_settings &by) {
  return std::make_unique<Finder>(quality, a, b, by);
}

} // namespace

library embree() {
  return {"Embree",
          true,
          std::to_string(RTC_VERSION_MAJOR) + "." + std::to_string(RTC_VERSION_MINOR) + "." +
              std::to_string(RTC_VERSION_PATCH),
          "its package's code for several instruction sets, of which max_isa allows no more than ours; robust scenes",
          {{"Embree, rtcCollide, low quality", finds::candidates, make<box_pairs, RTC_BUILD_QUALITY_LOW>},
           {"Embree, rtcCollide, high quality", finds::candidates, make<box_pairs, RTC_BUILD_QUALITY_HIGH>}},
          {{"Embree, rays, low quality", finds::touching, make<segment_hits, RTC_BUILD_QUALITY_LOW>},
           {"Embree, rays, high quality", finds::touching, make<segment_hits, RTC_BUILD_QUALITY_HIGH>}}};
}

} // namespace meetc::bench::peers
