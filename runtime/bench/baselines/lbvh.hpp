// bench/baselines/lbvh.hpp: a linear bounding-volume hierarchy, with which the device's own hierarchy is compared.
//
// Method: leaves lie in the order of their boxes' Morton codes; each inner node finds its range and its split from the codes
// alone; boxes are fitted upwards from the leaves, where the second child to arrive goes on; a query walks down with a stack.
// Source: T. Karras, "Maximizing parallelism in the construction of BVHs, octrees, and k-d trees", High Performance Graphics
// 2012, sections 3 and 4.
// Layout: n leaves have n - 1 inner nodes, of which node 0 is the root. n is from 2 to 2^31 - 1.
#ifndef MEETC_BENCH_BASELINES_LBVH_HPP
#define MEETC_BENCH_BASELINES_LBVH_HPP

#include <meetc/support.hpp>

#include <bit>
#include <cstdint>

MEETC_NAMESPACE(meetc::baselines) {

struct lbvh_box {
  float lo[3], hi[3];
};
MEETC_HD inline bool overlap(const lbvh_box &a, const lbvh_box &b) {
  return a.lo[0] <= b.hi[0] && b.lo[0] <= a.hi[0] && a.lo[1] <= b.hi[1] && b.lo[1] <= a.hi[1] && a.lo[2] <= b.hi[2] &&
         b.lo[2] <= a.hi[2];
}
MEETC_HD inline lbvh_box around(const lbvh_box &a, const lbvh_box &b) {
  lbvh_box r = a;
  for (int d = 0; d < 3; ++d) {
    r.lo[d] = b.lo[d] < a.lo[d] ? b.lo[d] : a.lo[d];
    r.hi[d] = b.hi[d] > a.hi[d] ? b.hi[d] : a.hi[d];
  }
  return r;
}

// The box of a row of finite numbers: a ball (4 fields), or points of three fields each.
template <int Fields> MEETC_HD inline lbvh_box box_of(const float *row) {
  lbvh_box r{};
  for (int d = 0; d < 3; ++d) {
    if constexpr (Fields == 4) {
      r.lo[d] = row[d] - row[3], r.hi[d] = row[d] + row[3];
    } else {
      r.lo[d] = r.hi[d] = row[d];
      for (int f = d + 3; f < Fields; f += 3) {
        r.lo[d] = row[f] < r.lo[d] ? row[f] : r.lo[d];
        r.hi[d] = row[f] > r.hi[d] ? row[f] : r.hi[d];
      }
    }
  }
  return r;
}

// The Morton code of a box's centre in [lo, hi]: ten bits of each coordinate, in turns.
inline constexpr int morton_bits = 30;
MEETC_HD inline std::uint32_t morton_code(const lbvh_box &b, const float lo[3], const float hi[3]) {
  std::uint32_t code = 0;
  for (int d = 0; d < 3; ++d) {
    const float side = hi[d] - lo[d], share = side > 0 ? ((b.lo[d] + b.hi[d]) / 2 - lo[d]) / side : 0;
    const float cell = share * 1024;
    std::uint32_t c = cell >= 1023 ? 1023U : cell > 0 ? static_cast<std::uint32_t>(cell) : 0U;
    c = (c | c << 16) & 0x030000ffU; // each step parts the bits by twice as many places
    c = (c | c << 8) & 0x0300f00fU;
    c = (c | c << 4) & 0x030c30c3U;
    c = (c | c << 2) & 0x09249249U;
    code |= c << d;
  }
  return code;
}

// A child is an inner node, or a leaf: lbvh_leaf plus its position in the order of the codes.
inline constexpr std::uint32_t lbvh_leaf = 0x80000000U;

struct lbvh_node {
  lbvh_box boxes[2];
  std::uint32_t child[2];
  std::uint32_t last[2]; // of each child: the position of its last leaf
};

MEETC_HD inline int leading_zeros(std::uint32_t x) {
#ifdef __CUDA_ARCH__
  return __clz(static_cast<int>(x));
#else
  return std::countl_zero(x);
#endif
}

// How many leading bits the keys of two leaves share, and -1 beyond the ends. The key is the code followed by the position, so
// that no two are equal.
MEETC_HD inline int shared_bits(const std::uint32_t *codes, std::int64_t n, std::int64_t i, std::int64_t j) {
  if (j < 0 || j >= n)
    return -1;
  const std::uint32_t differ = codes[i] ^ codes[j];
  return differ != 0 ? leading_zeros(differ)
                     : 32 + leading_zeros(static_cast<std::uint32_t>(i) ^ static_cast<std::uint32_t>(j));
}

// Writes the children of inner node i, without their boxes, and this node as their parent: twice its number, plus which of its
// children each is. `of_nodes` has a place for each inner node, and `of_leaves` for each leaf.
MEETC_HD inline void link(const std::uint32_t *codes, std::int64_t n, std::int64_t i, lbvh_node *nodes,
                          std::uint32_t *of_nodes, std::uint32_t *of_leaves) {
  const int way = shared_bits(codes, n, i, i + 1) > shared_bits(codes, n, i, i - 1) ? 1 : -1;
  const int outside = shared_bits(codes, n, i, i - way);
  std::int64_t most = 2;
  while (shared_bits(codes, n, i, i + most * way) > outside)
    most *= 2;
  std::int64_t length = 0;
  for (std::int64_t step = most / 2; step > 0; step /= 2)
    if (shared_bits(codes, n, i, i + (length + step) * way) > outside)
      length += step;
  const std::int64_t end = i + length * way;
  const int inside = shared_bits(codes, n, i, end);
  std::int64_t split = 0, step = length;
  do {
    step = (step + 1) / 2;
    if (shared_bits(codes, n, i, i + (split + step) * way) > inside)
      split += step;
  } while (step > 1);
  const std::int64_t at = i + split * way + (way < 0 ? -1 : 0), first = way < 0 ? end : i, last = way < 0 ? i : end;
  const std::int64_t starts[2] = {first, at + 1}, ends[2] = {at, last}, inner[2] = {at, at + 1};
  for (int side = 0; side < 2; ++side) {
    const bool is_leaf = starts[side] == ends[side];
    const auto parent = static_cast<std::uint32_t>(2 * i + side), child = static_cast<std::uint32_t>(inner[side]);
    nodes[i].child[side] = is_leaf ? lbvh_leaf | child : child;
    nodes[i].last[side] = static_cast<std::uint32_t>(ends[side]);
    (is_leaf ? of_leaves : of_nodes)[child] = parent;
  }
}

// Fits boxes upwards from a leaf with this box. `arrive(node)` says whether both children of the node have been written, and
// `other(box)` reads a box that another thread may have written.
template <class Arrive, class Other>
MEETC_HD inline void fit(lbvh_box b, std::uint32_t parent, lbvh_node *nodes, const std::uint32_t *of_nodes,
                         Arrive arrive, Other other) {
  for (;;) {
    const std::uint32_t node = parent / 2, side = parent % 2;
    nodes[node].boxes[side] = b;
    if (!arrive(node) || node == 0)
      return;
    b = around(b, other(nodes[node].boxes[1 - side]));
    parent = of_nodes[node];
  }
}

// The query that walks down: a box, or a segment, which goes through the slabs between a box's sides (T. Kay and J. Kajiya,
// "Ray tracing complex scenes", SIGGRAPH 1986). In rounded numbers a segment can miss a box that it touches.
struct walking_box {
  lbvh_box box;
  MEETC_HD bool reaches(const lbvh_box &b) const { return overlap(box, b); }
};
struct walking_segment {
  float from[3], inverse[3];
  MEETC_HD explicit walking_segment(const float *row) {
    for (int d = 0; d < 3; ++d)
      from[d] = row[d], inverse[d] = 1 / (row[d + 3] - row[d]);
  }
  MEETC_HD bool reaches(const lbvh_box &b) const { return entry(b, 1) <= 1; }
  // Where the segment enters the box, as a part of its length, if that is at most `most`; else more than 1.
  MEETC_HD float entry(const lbvh_box &b, float most) const {
    float begin = 0, end = most;
    for (int d = 0; d < 3; ++d) {
      const float s = (b.lo[d] - from[d]) * inverse[d], t = (b.hi[d] - from[d]) * inverse[d];
      const float in = s < t ? s : t, out = s < t ? t : s;
      begin = in > begin ? in : begin, end = out < end ? out : end;
    }
    return begin <= end ? begin : 2;
  }
};

// Calls visit(position) for each leaf behind position `after` whose box q reaches; for all leaves, `after` is -1.
template <class Walking, class Visit>
MEETC_HD inline void walk(const lbvh_node *nodes, const Walking &q, std::int64_t after, Visit visit) {
  constexpr int deepest = 64; // keys have morton_bits + 32 bits, and each level spends one
  std::uint32_t waiting[deepest], at = 0;
  int count = 0;
  for (;;) {
    const lbvh_node &node = nodes[at];
    bool down[2];
    for (int side = 0; side < 2; ++side) {
      down[side] = node.last[side] > after && q.reaches(node.boxes[side]);
      if (down[side] && (node.child[side] & lbvh_leaf) != 0) {
        visit(node.child[side] & ~lbvh_leaf);
        down[side] = false;
      }
    }
    if (down[0] && down[1])
      waiting[count++] = node.child[1];
    if (down[0] || down[1])
      at = node.child[down[0] ? 0 : 1];
    else if (count > 0)
      at = waiting[--count];
    else
      return;
  }
}

// Calls visit(position, most) for the leaves whose boxes the segment enters before `most`, the nearer child first. `most` is 1
// at first; visit() makes it the position of the nearest hit so far.
template <class Visit>
MEETC_HD inline void walk_to_first(const lbvh_node *nodes, const walking_segment &q, Visit visit) {
  constexpr int deepest = 64;
  std::uint32_t waiting[deepest], at = 0;
  float entries[deepest], most = 1;
  int count = 0;
  for (;;) {
    const lbvh_node &node = nodes[at];
    float entry[2];
    for (int side = 0; side < 2; ++side) {
      entry[side] = q.entry(node.boxes[side], most);
      if (entry[side] <= most && (node.child[side] & lbvh_leaf) != 0) {
        visit(node.child[side] & ~lbvh_leaf, most);
        entry[side] = 2;
      }
    }
    const int nearer = entry[1] < entry[0] ? 1 : 0;
    if (entry[1 - nearer] <= most)
      waiting[count] = node.child[1 - nearer], entries[count++] = entry[1 - nearer];
    if (entry[nearer] <= most) {
      at = node.child[nearer];
      continue;
    }
    while (count > 0 && entries[count - 1] > most)
      --count;
    if (count == 0)
      return;
    at = waiting[--count];
  }
}

} // MEETC_NAMESPACE(meetc::baselines)

#endif
