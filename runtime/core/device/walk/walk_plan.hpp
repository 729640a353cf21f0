// core/device/walk/walk_plan.hpp: how a walk is cut into items.
#ifndef MEETC_CORE_DEVICE_WALK_WALK_PLAN_HPP
#define MEETC_CORE_DEVICE_WALK_WALK_PLAN_HPP

#include "meet/core/device/walk/walk_kernels.hpp"

namespace meetc::cuda {

// A walk is cut into items, so that every warp finds work. Each node of the walker's level 0 goes down from each chunk,
// which is a node of level `start`. Where that is too few, the long elements of the node are dealt out to groups, whose
// number is a power of two, and so are the children of nodes of the level `deal`: of the chunk, or, where few packets go
// down and each reaches few of these, of the lowest nodes. `batch` items are taken at once, at most 32: the first by the
// warp's number, others by a counter, which warps can change only one after another. So where there are few items for each
// warp, and none of them is far longer than others, all are taken by its number.
struct walk_plan {
  int start, deal;
  std::uint32_t first_chunk, chunks, long_groups, child_groups, batch, items;
  bool cut;       // not all of the tree is tested
  bool whole;     // an item is a node and goes down from the root
  bool by_number; // no counter says who takes an item
};

// `enough` items keep the device busy.
inline walk_plan plan_of(const tree_walk &w, unsigned enough) {
  // The nodes of a level that have a part of the tree below them.
  const auto nodes_of = [&w](int level) { return ((w.of.end_b - 1) >> 5 * level) - (w.of.first_b >> 5 * level) + 1; };
  walk_plan plan{w.tree.shape.depth - 1,
                 1,
                 0,
                 1,
                 1,
                 1,
                 1,
                 w.of.end_a - w.of.first_a,
                 w.half || w.of.first_b > 0 || w.of.end_b < w.tree.shape.count[0],
                 false,
                 false};
  // Twice as many, since some long elements pass many more boxes than others.
  for (; w.rows && plan.long_groups < tree_width && plan.items < 2 * enough; plan.items *= 2)
    plan.long_groups *= 2;
  const bool few_packets = !w.rows && 4 * plan.items <= enough;
  // Where more than half of the warps have a packet, to cut these costs more than it gains.
  const bool many_packets = !w.rows && 2 * plan.items > enough;
  // The wanted number may be exceeded twice. For long elements half as many are wanted, so that no warp has more than one.
  const unsigned wanted = few_packets ? 2 * enough : w.rows ? enough / 2 : enough;
  const unsigned cuts = many_packets ? 1 : (wanted + plan.items - 1) / plan.items;
  while (plan.start > 1 && nodes_of(plan.start - 1) < cuts)
    --plan.start;
  plan.first_chunk = w.of.first_b >> 5 * plan.start;
  plan.chunks = nodes_of(plan.start);
  while (plan.child_groups < tree_width && plan.chunks * plan.child_groups < cuts)
    plan.child_groups *= 2;
  plan.items *= plan.chunks * plan.child_groups; // below 2^32 for sets of any size, as a test shows
  // Packets then go down together. Those of triangles or boxes can have very different numbers of pairs, so that warps
  // rather take fewer at a time.
  while (plan.batch < 8 && plan.items > (w.balls ? 2 : 16) * plan.batch * enough)
    plan.batch *= 2;
  plan.whole = plan.items == w.of.end_a - w.of.first_a;
  plan.deal = few_packets ? 1 : plan.start;
  plan.by_number = plan.items <= (w.rows ? 1 : 4) * enough;
  return plan;
}

} // namespace meetc::cuda

#endif
