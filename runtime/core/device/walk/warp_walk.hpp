// core/device/walk/warp_walk.hpp: how one warp walks down a tree.
#ifndef MEETC_CORE_DEVICE_WALK_WARP_WALK_HPP
#define MEETC_CORE_DEVICE_WALK_WARP_WALK_HPP

#include "meet/core/device/walk/walk_kernels.hpp"
#include "meet/core/device/walk/walk_plan.hpp"
#include "meet/core/device/walk/warp_room.hpp"
#include "meet/core/hierarchy/two_balls.hpp"
#include "meetc/cuda/lists.hpp"
#include "meetc/cuda/warp.hpp"

namespace meetc::cuda {

// One warp. A packet of 32 neighbours goes down together, its box against the 32 boxes of a node, one lane a box. The boxes
// that are left at the bottom wait until there are 32, so that the last test, of each element's own box, runs full. Elements
// that are long beside the nodes of the tree go down alone, by their two points. BothWays: a pair is put into the list in
// both orders, unless an element is paired with itself.
enum class walk_by : std::uint8_t { boxes, points, balls }; // of elements
template <walk_by By, bool BothWays = false> class warp_walk {
  static_assert(!(By == walk_by::points && BothWays)); // a long element puts its pairs one way
public:
  __device__ warp_walk(const tree_walk &w, const walk_plan &plan, warp_room &room)
      : w_(w), plan_(plan), room_(room), lane_(threadIdx.x % tree_width), below_((1U << lane_) - 1),
        hits_(w, room.hits), of_lane_(reinterpret_cast<const float2 *>(&w.tree.nodes->of[0][lane_])) {
#if defined(__CUDA_ARCH__)
    asm("" : "+l"(of_lane_)); // it is not computed anew for each node
#endif
  }

  // Does the items of this one of all warps, up to the pairs in the buffer.
  __device__ void run(std::uint32_t warp, std::uint32_t warps) {
    const tree_shape &s = w_.tree.shape;
    const tree_box all = around_warp(box_of(w_.tree.nodes[s.first[s.depth - 1]], lane_));
    // Longer than some nodes of level 0, if these were spread over a surface of the tree's extent.
    long_side_ = 4 * longest_side(all) * sqrtf(1.0F / static_cast<float>(s.count[0]));
    for (unsigned long long at = warp; at * plan_.batch < plan_.items;
         at = plan_.by_number ? at + warps : next(warps)) {
      const std::uint32_t first = static_cast<std::uint32_t>(at) * plan_.batch, items = plan_.items - first;
      unsigned left = ~0U >> (tree_width - (items < plan_.batch ? items : plan_.batch));
      if (plan_.whole)
        left = touching(all, first, left);
      descends_ = descends_ || ++batches_ % 16 == 0;
      listed_ = 0;
      if (left && plan_.whole && plan_.batch >= least_together && descends_ && w_.tree.shape.depth - 1 > coarse_level) {
        const unsigned near = touching_nodes(first, left);
        descends_ =
            listed_ > 0 || 4 * __popc(near) <= 3 * __popc(left); // or it costs more than it saves, for some time
        left = near;
      }
      for (unsigned k; left; left &= left - 1) {
        k = __ffs(left) - 1;
        enter(first + k, k);
      }
      if (full(w_.out) || (By == walk_by::balls && full(w_.unsure)))
        break;
    }
  }

  // The pairs that it has found and not written yet.
  __device__ hit_buffer<BothWays> &hits() {
    return hits_;
  }

private:
  __device__ unsigned long long next(std::uint32_t warps) {
    unsigned long long at = 0;
    if (lane_ == 0)
      at = atomicAdd(w_.taken, 1ULL);
    return warps + __shfl_sync(~0U, at, 0);
  }
  // The box of an item that is a whole node, a lane an item; empty where it is none of these.
  __device__ tree_box box_of_item(std::uint32_t first, unsigned items) const {
    if (!(items >> lane_ & 1))
      return {};
    const std::uint32_t node = w_.of.first_a + first + lane_;
    return box_of(w_.walker.nodes[w_.walker.shape.first[1] + node / tree_width], node % tree_width);
  }
  // Those of such items whose boxes touch the box of all of the tree.
  __device__ unsigned touching(const tree_box &all, std::uint32_t first, unsigned items) const {
    return __ballot_sync(~0U, all.touches(box_of_item(first, items)));
  }
  // Those of such items whose boxes touch that of a child of a node of the coarse level. They go down there together. These
  // children are listed, unless there are too many.
  __device__ unsigned touching_nodes(std::uint32_t first, unsigned items) {
    const tree_box mine = box_of_item(first, items), around = around_warp(mine);
    const int top = w_.tree.shape.depth - 1;
    int level = top;
    std::uint32_t node = 0;
    unsigned found = 0, listed = 0;
    first_b_ = first_leaf(w_.of.first_a + first);
    for (;;) {
      const tree_box b = box_at(level, node);
      unsigned children = __ballot_sync(~0U, around.touches(b));
      if (plan_.cut)
        children &= __ballot_sync(~0U, is_in_part(level, node * tree_width + lane_));
      if (level == coarse_level) {
        for (; children; children &= children - 1) {
          const unsigned child = __ffs(children) - 1, near = __ballot_sync(~0U, mine.touches(from_lane(b, child)));
          if (near && listed < tree_width && lane_ == 0)
            room_.near[listed] = node * tree_width + child, room_.near_items[listed] = near;
          listed += near != 0;
          found |= near;
        }
        if (found == items && listed > tree_width)
          break;
      } else {
        later_.enter(level, node, children);
        --level;
      }
      if (!later_.next(top, level, node))
        break;
    }
    listed_ = listed <= tree_width ? listed : 0;
    __syncwarp();
    return found;
  }
  // The first of the tree's nodes of level 0 that is tested with a node of the walker.
  __device__ std::uint32_t first_leaf(std::uint32_t node) const {
    return w_.half && node > w_.of.first_b ? node : w_.of.first_b;
  }
  __device__ tree_box box_at(int level, std::uint32_t node) const {
    return box_of_leaf(w_.tree.shape.first[level] + node);
  }
  // The box of this lane in a node of the array.
  __device__ tree_box box_of_leaf(std::uint32_t node) const {
    const float2 *const from = of_lane_ + node * std::size_t{3 * tree_width};
    tree_box b;
    for (unsigned k = 0; k < 3; ++k) {
      const float2 ends = __ldg(from + k * tree_width);
      b.low[k] = ends.x, b.high[k] = ends.y;
    }
    return b;
  }

  // It is the k-th of its batch.
  __device__ void enter(std::uint32_t item, unsigned k) {
    std::uint32_t before = item, chunk = plan_.first_chunk;
    unsigned long_group = 0;
    dealt_ = ~0U;
    if (!plan_.whole) {
      const unsigned child_group = item & (plan_.child_groups - 1);
      item >>= __ffs(plan_.child_groups) - 1;
      long_group = item & (plan_.long_groups - 1);
      item >>= __ffs(plan_.long_groups) - 1;
      before = item / plan_.chunks;
      chunk += item - before * plan_.chunks;
      dealt_ = __ballot_sync(~0U, (lane_ & (plan_.child_groups - 1)) == child_group);
    }
    const std::uint32_t node = w_.of.first_a + before;
    first_b_ = first_leaf(node);
    const tree_view &walker = w_.walker;
    const std::uint32_t at = node * tree_width + lane_;
    own_ = box_of(walker.nodes[node], lane_);
    slot_ = at < walker.elements ? at : 0;
    least_ = w_.half ? slot_ : 0;
    if constexpr (By == walk_by::points) {
      const bool is_long = longest_side(own_) > long_side_;
      unsigned alone = __ballot_sync(~0U, is_long);
      if (alone) {
        two_points mine{};
        if (is_long)
          mine = two_points_of(w_.points, w_.rows + slot_ * static_cast<std::size_t>(w_.fields));
        for (; alone; alone &= alone - 1) {
          const unsigned lane = __ffs(alone) - 1;
          if ((lane & (plan_.long_groups - 1)) != long_group)
            continue;
          single_ = from_lane(mine, lane);
          around_ = from_lane(own_, lane);
          single_slot_ = __shfl_sync(~0U, slot_, lane);
          down<true>(chunk);
        }
        own_ = is_long ? tree_box() : own_;
      }
      if (long_group != 0)
        return;
      around_ = around_warp(own_);
    } else {
      around_ = box_of(walker.nodes[walker.shape.first[1] + node / tree_width], node % tree_width);
    }
    if (!(around_.low[0] <= around_.high[0]))
      return;
    const packet_cells in_packet(around_);
    own_cells_ = in_packet.of(own_);
    __syncwarp();
    if (lane_ == 0)
      room_.in_packet = in_packet;
    float areas = half_area(own_);
    for (int d = 16; d > 0; d /= 2)
      areas += __shfl_xor_sync(~0U, areas, d);
    sparse_ = half_area(around_) > 2 * areas;
    if (listed_ > 0)
      visit_listed(k);
    else
      down<false>(chunk);
    while (waiting_ > 0)
      test_waiting();
  }

  // Whether the box in this lane is to be entered or kept: that of a child of the node, or of an element.
  template <bool Single> __device__ bool touches(const tree_box &b) const {
    bool touch = around_.touches(b);
    if constexpr (Single)
      touch = touch && !apart_from_box(single_, b.low, b.high);
    return touch;
  }

  // Goes down from a node of level `start`, until the list is full.
  template <bool Single> __device__ void down(std::uint32_t node) {
    int level = plan_.start;
    for (;;) {
      if (hits_.over()) {
        later_ = nodes_to_enter();
        return;
      }
      const unsigned touching = touching_children<Single>(level, node);
      if (level == 1) {
        leaves<Single>(node, touching);
      } else {
        later_.enter(level, node, touching);
        --level;
      }
      if (!later_.next(plan_.start, level, node))
        return;
    }
  }
  // Visits the nodes that are listed for the k-th item.
  __device__ void visit_listed(unsigned k) {
    unsigned left = __ballot_sync(~0U, lane_ < listed_ && (room_.near_items[lane_] >> k & 1));
    for (; left; left &= left - 1) {
      const std::uint32_t node = room_.near[__ffs(left) - 1];
      leaves<false>(node, touching_children<false>(1, node));
    }
  }
  // The children of a node that are to be visited.
  template <bool Single> __device__ unsigned touching_children(int level, std::uint32_t node) const {
    const tree_box b = box_at(level, node);
    unsigned touching = __ballot_sync(~0U, touches<Single>(b));
    if (level == plan_.deal)
      touching &= dealt_;
    if (plan_.cut)
      touching &= __ballot_sync(~0U, is_in_part(level, node * tree_width + lane_));
    return !Single && sparse_ ? touched_by_some(touching, b) : touching;
  }

  // Whether a child of a node of this level has a node of level 0 that is to be tested.
  __device__ bool is_in_part(int level, std::uint32_t child) const {
    const int shift = 5 * (level - 1);
    const unsigned long long first = static_cast<unsigned long long>(child) << shift;
    return first < w_.of.end_b && first + (1ULL << shift) > first_b_;
  }

  // Drops the lanes whose boxes no element of the packet touches.
  __device__ unsigned touched_by_some(unsigned lanes, const tree_box &b) const {
    unsigned kept = 0;
    for (unsigned left = lanes; left; left &= left - 1) {
      const unsigned lane = __ffs(left) - 1;
      kept |= static_cast<unsigned>(__any_sync(~0U, own_.touches(from_lane(b, lane)))) << lane;
    }
    return kept;
  }

  __device__ static unsigned highest(unsigned bits) {
    return 31 - __clz(static_cast<int>(bits));
  }
  // Visits some children of a node of level 1, two at a time, so that the boxes of both are loaded together.
  template <bool Single> __device__ void leaves(std::uint32_t node, unsigned children) {
    while (children) {
      const unsigned first = highest(children);
      children ^= 1U << first;
      const bool two = children != 0;
      const unsigned second = two ? highest(children) : first;
      children &= ~(1U << second);
      const std::uint32_t one = node * tree_width + first, other = node * tree_width + second;
      const tree_box of_one = box_of_leaf(one), of_other = box_of_leaf(other);
      leaf<Single>(one, of_one, ~0U);
      leaf<Single>(other, of_other, two ? ~0U : 0);
      if constexpr (!Single)
        while (waiting_ >= tree_width)
          test_waiting();
    }
  }
  // The boxes of a node of level 0 that the packet's box touches wait, or are hits of the element that goes alone; of these
  // lanes.
  template <bool Single> __device__ void leaf(std::uint32_t node, const tree_box &b, unsigned lanes) {
    const std::uint32_t slot = node * tree_width + lane_;
    if constexpr (Single) {
      hits_.add((lanes & 1) && touches<true>(b) && !(w_.half && slot < single_slot_), single_slot_, slot);
    } else {
      lanes &= __ballot_sync(~0U, touches<false>(b));
      const unsigned at = waiting_ + __popc(lanes & below_);
      if (lanes >> lane_ & 1) {
        room_.xy[at] = {b.low[0], b.high[0], b.low[1], b.high[1]};
        room_.z[at] = {b.low[2], b.high[2], __uint_as_float(slot), 0};
      }
      waiting_ += __popc(lanes);
    }
  }

  // Tests the last of the boxes that wait, up to 32, against all elements of the packet.
  __device__ void test_waiting() {
    __syncwarp();
    const unsigned n = waiting_ < tree_width ? waiting_ : tree_width;
    waiting_ -= n;
    const float4 *const xys = room_.xy + waiting_, *const zs = room_.z + waiting_;
    const auto waits = [&](unsigned i) {
      const float4 xy = xys[i], z = zs[i];
      return tree_box{{xy.x, xy.z, z.x}, {xy.y, xy.w, z.y}};
    };
    const tree_box of_lane = waits(lane_); // of what lies behind the last too
    room_.cells[lane_] = room_.in_packet.of(of_lane);
    if constexpr (By == walk_by::balls)
      put_ball(waiting_ + lane_, ball_in_box(of_lane.low, of_lane.high));
    __syncwarp();
    unsigned mine = 0;
    for (unsigned first = (n - 1) & ~7U; first < tree_width; first -= 8) // from the last eight to the first
#pragma unroll
      for (unsigned i = 8; i-- > 0;)
        packet_cells::push(mine, room_.cells[first + i], own_cells_);
    mine &= ~0U >> (tree_width - n);
    if constexpr (By == walk_by::balls)
      test_balls(mine);
    else
      while (__any_sync(~0U, mine != 0)) {
        const unsigned i = mine ? __ffs(mine) - 1 : 0;
        const std::uint32_t slot = __float_as_uint(zs[i].z);
        const bool touch = own_.touches(waits(i)) & (mine != 0) & (slot >= least_);
        mine &= mine - 1;
        hits_.add(touch, slot_, slot);
      }
    __syncwarp();
  }

  __device__ void put_ball(unsigned at, const boxed_ball &b) {
    room_.xy[at] = {b.centre[0], b.centre[1], b.centre[2], b.most};
    room_.z[at].w = b.least;
  }
  // Compares this lane's ball with those that wait whose bits are set. That of an empty lane is NaN, which proves nothing,
  // and its box touches none.
  __device__ void test_balls(unsigned with) {
    const boxed_ball own = ball_in_box(own_.low, own_.high);
    while (__any_sync(~0U, with != 0)) {
      const unsigned at = waiting_ + (with ? __ffs(with) - 1 : 0);
      const float4 ball = room_.xy[at], z = room_.z[at];
      const std::uint32_t slot = __float_as_uint(z.z);
      const ball_verdict v = compare(own, {{ball.x, ball.y, ball.z}, ball.w, z.w});
      const bool tested = (with != 0) & (slot >= least_);
      with &= with - 1;
      hits_.add(tested & v.touch, slot_, slot);
      if (const bool unsure = tested & !v.apart & !v.touch; __any_sync(~0U, unsure))
        put_unsure(unsure, slot);
    }
  }
  // Few pairs are, but at the ends of float32, where boxes say more.
  __device__ void put_unsure(bool unsure, std::uint32_t slot) {
    if (unsure)
      unsure = own_.touches(box_of(w_.tree.nodes[slot / tree_width], slot % tree_width));
    const unsigned lanes = __ballot_sync(~0U, unsure),
                   turned = BothWays ? __ballot_sync(~0U, unsure && slot != slot_) : 0;
    if (lanes == 0)
      return;
    if (lane_ == 0)
      atomicAdd(w_.near, static_cast<unsigned long long>(__popc(lanes) + __popc(turned)));
    const index_pair pair[1] = {w_.swapped ? index_pair{slot, slot_} : index_pair{slot_, slot}};
    append(unsure ? 1U : 0U, pair, w_.unsure);
  }

  const tree_walk &w_;
  const walk_plan &plan_;
  warp_room &room_;
  unsigned lane_, below_; // and the lanes below it
  hit_buffer<BothWays> hits_;
  const float2 *of_lane_; // this lane's ends in the tree's first node
  tree_box own_, around_; // of this lane's element, and of the packet, or of the element that goes alone
  cell_box own_cells_{};  // of this lane's element
  nodes_to_enter later_;
  std::uint32_t slot_ = 0, single_slot_ = 0;
  std::uint32_t least_ = 0;   // the first slot of the tree with which this lane's element is paired
  std::uint32_t first_b_ = 0; // of the tree's nodes of level 0 the first that is tested
  two_points single_{};
  bool descends_ = true; // items that are whole nodes go down together first
  unsigned listed_ = 0;  // nodes at which these are to go on; 0: at the root
  unsigned batches_ = 0;
  unsigned dealt_ = 0;  // the children of a node of the level `deal` that are this item's
  bool sparse_ = false; // the packet's box is large beside those of its elements
  float long_side_ = 0;
  unsigned waiting_ = 0; // boxes for the last test
};

} // namespace meetc::cuda

#endif
