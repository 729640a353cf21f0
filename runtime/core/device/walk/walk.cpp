#include "meet/core/device/walk/walk.hpp"

#include "meet/core/device/memory/buffers.hpp"

namespace meetc {

walk_lists lists_of(const cuda::predicate_launchers &by, rung precision) {
  if (!never_wrong(precision))
    return walk_lists::candidates;
  return by.by_boxes ? walk_lists::hits : by.by_balls ? walk_lists::balls : walk_lists::candidates;
}

std::uint32_t lowest_nodes(const device_rows &s) {
  return s.elements() / cuda::tree_width + (s.elements() % cuda::tree_width != 0);
}

namespace {

// The trees of both, made beside each other where neither is there.
void take_trees(const device &on, device_rows &walker, device_rows &tree, tree_walk &w) {
  device_buffers &buffers = on.buffers();
  const bool beside = &tree != &walker && !tree.has_tree() && !walker.has_tree();
  if (beside)
    buffers.fork();
  w.tree = tree.tree(beside ? buffers.beside : on.stream());
  w.walker = walker.tree(on.stream());
  if (beside)
    buffers.join();
  w.found_walker = walker.findings(), w.found_tree = tree.findings();
}

} // namespace

// The elements of the larger set walk, but those with two points before others. A plain rung may say yes where nothing
// touches, so that its candidates are all pairs whose boxes touch.
tree_walk walk_of(const device &on, device_rows &a, device_rows &b, rung precision, walk_lists what, bool half) {
  const bool points = never_wrong(precision) && what != walk_lists::hits,
             by_points_a = points && has_two_points(a.kind()), by_points_b = points && has_two_points(b.kind());
  tree_walk w{};
  w.half = half;
  w.swapped = by_points_a == by_points_b ? a.elements() < b.elements() : by_points_b;
  device_rows &walker = w.swapped ? b : a;
  take_trees(on, walker, w.swapped ? a : b, w);
  if (by_points_a || by_points_b) {
    w.rows = walker.data();
    w.fields = walker.kind().fields;
    w.points = point_fields_of(walker.kind());
  }
  w.balls = what == walk_lists::balls;
  w.taken = on.buffers().count_of(counter::taken);
  return w;
}

} // namespace meetc
