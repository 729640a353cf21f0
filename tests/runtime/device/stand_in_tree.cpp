// The kernels of orders and hierarchies that depend on no kind of element, on the host: see stand_in.cpp.
#include "core/device/order_kernels.hpp"
#include "core/device/tree_kernels.hpp"
#include "core/two_balls.hpp"
#include "tests/runtime/device/stand_in_levels.hpp"

#include <algorithm>

namespace meetc {

cudaError_t sort_places(void *space, std::size_t &bytes, const std::uint32_t *places, std::uint32_t *sorted,
                        const std::uint32_t *numbers, std::uint32_t *slots, std::uint32_t n, int, cudaStream_t) {
  bytes = 1;
  if (!space)
    return cudaSuccess;
  std::copy_n(numbers, n, slots);
  std::stable_sort(slots, slots + n, [places](std::uint32_t i, std::uint32_t j) { return places[i] < places[j]; });
  for (std::uint32_t i = 0; i < n; ++i)
    sorted[i] = places[slots[i]];
  return cudaSuccess;
}
cudaError_t enclose_levels(cuda::tree_node *nodes, std::uint32_t elements, int levels, cudaStream_t) {
  const cuda::tree_shape shape(elements);
  for (int level = levels - 1; level + 1 < shape.depth; ++level)
    cuda::enclose_level(nodes, shape, level);
  return cudaSuccess;
}

namespace {

// Each element goes down alone; a part is a range of nodes of level 0.
void go_down(const tree_walk &w, const cuda::tree_box &own, const two_points *points, std::uint32_t slot, int level,
             std::uint32_t node) {
  const cuda::tree_shape &shape = w.tree.shape;
  for (std::uint32_t lane = 0; lane < cuda::tree_width; ++lane) {
    const cuda::tree_box b = cuda::box_of(w.tree.nodes[shape.first[level] + node], lane);
    const bool touch = own.touches(b);
    if (!touch || (points && apart_from_box(*points, b.low, b.high)))
      continue;
    const std::uint32_t child = node * cuda::tree_width + lane;
    if (level > 0) {
      go_down(w, own, points, slot, level - 1, child);
      continue;
    }
    if (node < w.of.first_b || node >= w.of.end_b)
      continue;
    if (w.half && child < slot)
      continue;
    const auto append = [](const cuda::pair_list &to, index_pair p) {
      if (*to.count < to.capacity && to.pairs)
        to.pairs[*to.count] = p;
      ++*to.count;
    };
    const index_pair pair = w.swapped ? index_pair{child, slot} : index_pair{slot, child};
    const bool turned = w.out.both_ways && child != slot;
    if (w.balls) {
      const ball_verdict v = compare(ball_in_box(own.low, own.high), ball_in_box(b.low, b.high));
      if (v.apart)
        continue;
      *w.near += turned ? 2 : 1;
      if (!v.touch) {
        append(w.unsure, pair);
        continue;
      }
    }
    append(w.out, pair);
    if (turned)
      append(w.out, {child, slot});
  }
}

} // namespace

cudaError_t walk(const tree_walk &w, cudaStream_t) {
  if (*w.taken != 0)
    return cudaErrorInvalidValue;
  if (!w.is_to_be_done())
    return cudaSuccess;
  const std::uint32_t width = cuda::tree_width;
  for (std::uint32_t i = w.of.first_a * width; i < std::min(w.walker.elements, w.of.end_a * width); ++i) {
    two_points points{};
    if (w.rows)
      points = two_points_of(w.points, w.rows + i * static_cast<std::size_t>(w.fields));
    go_down(w, cuda::box_of(w.walker.nodes[i / width], i % width), w.rows ? &points : nullptr, i,
            w.tree.shape.depth - 1, 0);
    if (*w.out.count > w.out.capacity || (w.balls && *w.unsure.count > w.unsure.capacity))
      return cudaSuccess;
  }
  return cudaSuccess;
}

} // namespace meetc
