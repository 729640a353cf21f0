// A stand-in for the device, on the host: memory is memory (stand_in_runtime.cpp), and the engine's kernels (stand_in_kernels.cpp,
// stand_in_tree.cpp, stand_in_cull.cpp) and the generated launchers are loops. What the engine itself does
// (parts, lists, owners, poses, frames) is thus tested by the same scenes where there is no device. Extents, frames,
// columns and the first step are computed by the functions that the kernels call, in the order in which the kernels
// join results. Two of its filters are the extremes that the model of the matrix unit allows: one drops every pair that
// it may drop, the other keeps every pair that it may keep.
#include "tests/runtime/device/stand_in_cull.hpp"
#include "tests/runtime/device/stand_in_levels.hpp"

#include <cga/ball_form.hpp>
#include <cga/cga.hpp>
#include <cga/cga_cuda.hpp>
#include <cga/cga_runtime.hpp>
#include <cga/shapes.hpp>
#include <meetc/frame.hpp>
#include <meetc/matrix.hpp>
#include <meetc/near.hpp>
#include <meetc/take_first.hpp>
#include <meetc/tolerant.hpp>
#include <meetc/tree_order.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

namespace {

using namespace meetc;
using namespace meetc::stand_in;
using cuda::operand;
using cuda::pair_list;
using form = cga::ball_form;

cudaError_t clear_extent(extent *around, cudaStream_t) {
  for (int k = 0; k < 3; ++k)
    clear(*around, k);
  return cudaSuccess;
}
template <class Shape>
cudaError_t pose_rows(const cuda::view &v, const cuda::pose_matrix &at, const std::uint32_t *order, float *to,
                      unsigned long long *bad, cuda::joined_box *around, cudaStream_t) {
  constexpr int fields = Shape::fields;
  *bad = ~0ULL;
  for (std::uint32_t i = 0; i < v.elements; ++i) {
    float row[fields];
    if (!posed_element<Shape>(v, at, number_in(v, i), row))
      *bad = std::min(*bad, static_cast<unsigned long long>(order ? order[i] : number_in(v, i)) << 32 | i);
    if (to)
      std::copy_n(row, fields, to + i * std::size_t{fields});
    if (around)
      join(*around, cuda::box_of_row<Shape>(row));
  }
  return cudaSuccess;
}
template <class Shape>
cudaError_t instances(const float *rows, std::uint32_t n, const cuda::pose_matrix *at, std::uint32_t poses, float *to,
                      unsigned long long *bad, cudaStream_t) {
  *bad = ~0ULL;
  for (std::size_t i = 0; i < std::size_t{n} * poses; ++i)
    if (!posed_row<Shape>(at[i / n], rows + i % n * std::size_t{Shape::fields}, to + i * std::size_t{Shape::fields}))
      *bad = std::min(*bad, static_cast<unsigned long long>(i));
  return cudaSuccess;
}
// As on the device: lanes go through the set in strides, a warp joins what its lanes have found, and the bits of that are
// joined with those of other warps.
template <class Shape> cudaError_t enclose(const float *rows, std::uint32_t n, extent *around, cudaStream_t) {
  constexpr std::uint32_t warps = 16, width = 32;
  for (std::uint32_t warp = 0; warp < warps; ++warp) {
    interval lanes[width][3];
    for (std::uint32_t lane = 0; lane < width; ++lane)
      for (std::size_t i = warp * width + lane; i < n; i += warps * width)
        widen<Shape>(lanes[lane], rows + i * std::size_t{Shape::fields});
    for (int k = 0; k < 3; ++k) {
      for (std::uint32_t d = width / 2; d > 0; d /= 2)
        for (std::uint32_t lane = 0; lane < d; ++lane) // what becomes of the others, lane 0 does not see
          lanes[lane][k] = joined(lanes[lane][k], lanes[lane + d][k]);
      if (!(lanes[0][k].lo <= lanes[0][k].hi))
        continue;
      around->low[k] = std::min(around->low[k], ordered(lanes[0][k].lo));
      around->high[k] = std::max(around->high[k], ordered(lanes[0][k].hi));
    }
  }
  return cudaSuccess;
}
template <class Shape>
cudaError_t columns(cuda::filter by, cuda::grouping g, cover c, bool first, const float *rows, std::uint32_t n,
                    const extent *around, void *out, cudaStream_t) {
  const std::uint32_t objects = operand{rows, n, g, nullptr}.objects(), size = cuda::size_of(g);
  for (std::size_t i = 0; i < matrix_padded(objects); ++i) {
    double ball[4] = {0, 0, 0, 0};
    placing where = placing::nowhere;
    if (i < objects) {
      const auto begin = static_cast<std::uint32_t>(i) * size;
      where = place_object<Shape>(frame_of(*around), c, rows, begin, std::min(n - begin, size) + begin, ball);
    }
    if (by == cuda::filter::float32) {
      float *const to = static_cast<float *>(out) + i * (form::products + 1);
      first ? to_floats<form, true>(ball, where, to) : to_floats<form, false>(ball, where, to);
      continue;
    }
    std::uint16_t halves[matrix_columns];
    first ? to_columns<form, true>(ball, where, halves) : to_columns<form, false>(ball, where, halves);
    for (int k = 0; k < matrix_columns; ++k)
      static_cast<std::uint16_t *>(out)[matrix_place(i, k)] = halves[k];
  }
  return cudaSuccess;
}

// Fills the first levels of a tree.
template <class Shape> void boxes_of_levels(const float *rows, std::uint32_t n, cuda::tree_node *nodes, int levels) {
  const cuda::tree_shape shape(n);
  for (std::uint32_t i = 0; i < shape.count[0] * cuda::tree_width; ++i) {
    cuda::tree_box b;
    if (i < n)
      b = cuda::box_of_row<Shape>(rows + std::size_t{i} * Shape::fields);
    put_box(nodes[i / cuda::tree_width], i % cuda::tree_width, b);
  }
  for (int level = 0; level + 1 < std::min(levels, shape.depth); ++level)
    cuda::enclose_level(nodes, shape, level);
}
template <class Shape>
cudaError_t boxes(const float *rows, std::uint32_t n, cuda::tree_node *nodes, unsigned *arrived, cudaStream_t) {
  if (*arrived != 0)
    return cudaErrorInvalidValue;
  boxes_of_levels<Shape>(rows, n, nodes, cuda::levels_with_boxes(n));
  return cudaSuccess;
}

template <class Shape>
cudaError_t places(const float *rows, std::uint32_t n, const cuda::joined_box *around, int bits, std::uint32_t *places,
                   std::uint32_t *numbers, unsigned long long *bad, cudaStream_t) {
  const cuda::hilbert_cells cells(cuda::box_of(*around), bits);
  for (std::uint32_t i = 0; i < n; ++i) {
    const float *const row = rows + i * std::size_t{Shape::fields};
    if (bad && !is_good<Shape>(row))
      *bad = std::min(*bad, static_cast<unsigned long long>(i) << 32 | i);
    places[i] = cells.place_of(cuda::box_of_row<Shape>(row));
    numbers[i] = i;
  }
  return cudaSuccess;
}
template <class Shape> cudaError_t gather(const cuda::gather_job &job, cudaStream_t) {
  constexpr std::size_t fields = Shape::fields, width = cuda::tree_width;
  for (std::size_t i = 0; i < job.elements; ++i) {
    std::copy_n(job.from + job.slots[i] * fields, fields, job.rows + i * fields);
    job.slots[i] = job.names ? job.names[job.slots[i]] : job.slots[i];
    *job.crowded += i >= width && job.sorted[i] == job.sorted[i - width];
  }
  if (job.nodes)
    boxes_of_levels<Shape>(job.rows, job.elements, job.nodes, 2);
  return cudaSuccess;
}
// As on the device. Where most elements are in one place, they have none.
template <class Shape> cudaError_t arrange_one(const cuda::arrange_job &job, cudaStream_t stream) {
  const std::uint32_t n = job.from.elements;
  if (n == 0 || n > cuda::most_to_arrange || job.keys.n != n ||
      std::any_of(job.keys.counted, job.keys.counted + cuda::counted_to_distribute,
                  [](std::uint32_t number) { return number != 0; }))
    return cudaErrorInvalidValue;
  cuda::joined_box around{};
  pose_rows<Shape>(job.from, job.at, nullptr, job.posed, &job.found->bad, job.posed ? &around : nullptr, stream);
  const float *const posed = job.posed ? job.posed : job.from.data;
  const cuda::sample some(n);
  for (std::uint32_t i = some.first; !job.posed && i < n; i += some.step)
    join(around, cuda::box_of_row<Shape>(posed + i * std::size_t{Shape::fields}));
  if (job.common) {
    around = {};
    join(around, cuda::common_box(job.common[0], job.common[1]));
  }
  std::vector<std::uint32_t> places_of(n), numbers(n);
  places<Shape>(posed, n, &around, cuda::bits_to_arrange, places_of.data(), numbers.data(), nullptr, stream);
  for (std::uint32_t i = 0; i < n; ++i)
    job.keys.keys[i] = cuda::in_order(places_of[i], i);
  std::partial_sort_copy(job.keys.keys, job.keys.keys + n, job.keys.by_cell, job.keys.by_cell + n);
  job.found->crowded = job.found->unordered = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    job.found->crowded +=
        i >= cuda::tree_width && job.keys.by_cell[i] >> 32 == job.keys.by_cell[i - cuda::tree_width] >> 32;
    const auto from = static_cast<std::uint32_t>(job.keys.by_cell[i]);
    job.order[i] = number_in(job.from, from);
    std::copy_n(posed + from * std::size_t{Shape::fields}, Shape::fields, job.rows + i * std::size_t{Shape::fields});
  }
  constexpr std::uint32_t most_alike = 1024; // in one place; the device's limits are others
  for (std::uint32_t i = most_alike; i < n; ++i)
    if (job.keys.by_cell[i] >> 32 == job.keys.by_cell[i - most_alike] >> 32)
      job.found->unordered = 1;
  std::fill_n(job.cleared, job.clears, 0ULL);
  return job.nodes ? boxes<Shape>(job.rows, n, job.nodes, job.arrived, stream) : cudaSuccess;
}
template <class Shape> cudaError_t arrange(const cuda::arrange_job *jobs, int count, cudaStream_t stream) {
  cudaError_t e = count == 1 || count == 2 ? cudaSuccess : cudaErrorInvalidValue;
  for (int k = 0; k < count && e == cudaSuccess; ++k)
    e = arrange_one<Shape>(jobs[k], stream);
  return e;
}

void append(const pair_list &to, index_pair p) {
  if (*to.count < to.capacity)
    to.pairs[*to.count] = p;
  ++*to.count;
  if (to.both_ways && p.a != p.b)
    append({to.pairs, to.count, to.capacity}, {p.b, p.a});
}

bool negative(cuda::filter by, const double *x, const double *y) {
  double sum = 0, size = 0;
  for (int k = 0; k < matrix_columns; ++k)
    sum += x[k] * y[k], size += std::fabs(x[k] * y[k]);
  const double off = 17 * 0x1p-23 * size;
  return by == cuda::filter::mma ? sum + off < 0 : sum - off < 0;
}

// Whether all padding equals the first padded object.
bool padded_alike(cuda::filter by, const operand &o) {
  const std::size_t first = o.objects();
  bool alike = true;
  for (std::size_t i = first + 1; i < matrix_padded(first); ++i)
    if (by == cuda::filter::float32)
      alike = alike &&
              std::memcmp(static_cast<const float *>(o.columns) + first * (form::products + 1),
                          static_cast<const float *>(o.columns) + i * (form::products + 1), cuda::float_bytes) == 0;
    else
      for (int k = 0; k < matrix_columns; ++k)
        alike = alike && static_cast<const std::uint16_t *>(o.columns)[matrix_place(first, k)] ==
                             static_cast<const std::uint16_t *>(o.columns)[matrix_place(i, k)];
  return alike;
}

cudaError_t candidates(cuda::filter by, const operand &a, const operand &b, cuda::part of, pair_list out,
                       cudaStream_t) {
  // Where the part ends with the set, its padding is tested as well.
  const auto end_of = [](std::uint32_t end, const operand &o) { return end == o.objects() ? end + 1 : end; };
  if (!padded_alike(by, a) || !padded_alike(by, b))
    return cudaErrorIllegalAddress;
  if (of.first_a % cuda::part_step != 0 || of.first_b % cuda::part_step != 0 || of.end_a > a.objects() ||
      of.end_b > b.objects())
    return cudaErrorInvalidValue;
  const std::uint32_t end_a = end_of(of.end_a, a), end_b = end_of(of.end_b, b);
  const auto halves_of = [](const operand &o, std::uint32_t first, std::uint32_t end) {
    std::vector<double> v;
    for (std::uint32_t i = first; i < end; ++i)
      for (int k = 0; k < matrix_columns; ++k)
        v.push_back(from_half(static_cast<const std::uint16_t *>(o.columns)[matrix_place(i, k)]));
    return v;
  };
  std::vector<double> x, y;
  if (by != cuda::filter::float32)
    x = halves_of(a, of.first_a, end_a), y = halves_of(b, of.first_b, end_b);
  for (std::uint32_t i = of.first_a; i < end_a; ++i) {
    for (std::uint32_t j = of.first_b; j < end_b; ++j) {
      const bool keep = by == cuda::filter::float32
                            ? std::signbit(bilinear<form>(
                                  static_cast<const float *>(a.columns) + i * std::size_t{form::products + 1},
                                  static_cast<const float *>(b.columns) + j * std::size_t{form::products + 1}))
                            : negative(by, &x[(i - of.first_a) * std::size_t{matrix_columns}],
                                       &y[(j - of.first_b) * std::size_t{matrix_columns}]);
      if (keep && (i >= a.objects() || j >= b.objects()))
        return cudaErrorIllegalAddress; // padding
      if (keep)
        append(out, {i, j});
    }
    if (*out.count > out.capacity)
      return cudaSuccess;
  }
  return cudaSuccess;
}

// The steps of the predicate at this index of the catalogue, as in the kernels.
template <class P, class A, class B>
cudaError_t near(cuda::step which, const operand &a, const operand &b, pair_list in, pair_list yes, pair_list kept,
                 unsigned long long *touching, cudaStream_t) {
  const std::size_t n = std::min(*in.count, in.capacity);
  const std::uint32_t size = cuda::size_of(a.by);
  for (std::size_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < size * size; ++k) {
      const index_pair slots{in.pairs[i].a * size + k / size, in.pairs[i].b * size + k % size};
      if (slots.a >= a.elements || slots.b >= b.elements)
        continue;
      const float *const row_a = a.rows + slots.a * std::size_t{A::fields};
      const float *const row_b = b.rows + slots.b * std::size_t{B::fields};
      if (which != cuda::step::reject && !boxes_touch<A, B>(row_a, row_b))
        continue;
      ++*touching;
      if constexpr (P::reject_stage::atoms > 0)
        if (which != cuda::step::near_boxes && standard_environment()) {
          const progress at = try_to_reject<P>(row_a, row_b);
          if (at == progress::hit)
            append(yes, slots);
          if (at != progress::open)
            continue;
        }
      append(kept, slots);
    }
  return cudaSuccess;
}
template <int Which>
cudaError_t run(cuda::step which, const operand &a, const operand &b, pair_list in, pair_list yes, pair_list unsure,
                cudaStream_t) {
  const predicate_info &p = cga::catalogue().predicates[Which];
  const std::size_t n = std::min(*in.count, in.capacity);
  std::vector<index_pair> asked(in.pairs, in.pairs + n);
  // Appends the hits of this rung; the pairs that it leaves unsure are to be asked next.
  const auto decide = [&](decide_function f) {
    std::vector<answer> answers(asked.size());
    f({a.rows}, {b.rows}, asked.data(), asked.size(), answers.data());
    std::vector<index_pair> open;
    for (std::size_t i = 0; i < asked.size(); ++i)
      if (answers[i] == answer::yes)
        append(yes, asked[i]);
      else if (answers[i] == answer::unsure)
        open.push_back(asked[i]);
    asked = std::move(open);
  };
  if (which == cuda::step::certify_rest) {
    decide(p.certify[static_cast<int>(rung::fp64)]);
    unsure.count[0] += asked.size();
    decide(p.certify[static_cast<int>(rung::fp64x2)]);
    unsure.count[1] += asked.size();
    decide(p.decide[static_cast<int>(rung::exact)]);
  } else if (which == cuda::step::certify_fp32) {
    decide(p.certify[static_cast<int>(rung::fp32)]);
    for (const index_pair &q : asked)
      append(unsure, q);
  } else {
    decide(
        p.decide[which == cuda::step::tolerant ? static_cast<int>(rung::tolerant)
                                               : static_cast<int>(which) - static_cast<int>(cuda::step::plain_fp32)]);
  }
  return cudaSuccess;
}

// The last hit comes first, and each lane has seen its cell before any other filled it.
template <int Which> cudaError_t order_hits_of(const cuda::first_met_job &job, cudaStream_t) {
  const predicate_info &p = cga::catalogue().predicates[Which];
  const auto row = [](const float *rows, std::uint32_t slot, const kind_info &kind) {
    return rows + slot * static_cast<std::size_t>(kind.fields);
  };
  for (std::size_t i = job.count; i-- > 0;) {
    const index_pair hit = job.hits[i];
    const auto before = [&](std::uint32_t slot, std::uint32_t other) {
      return comes_before(p.first_met(row(job.a, hit.a, *p.a), row(job.b, slot, *p.b), row(job.b, other, *p.b)),
                          number_of_b(job, slot), number_of_b(job, other));
    };
    take_first(cuda::no_slot, hit.b, cuda::no_slot, before, [&](std::uint32_t expected, std::uint32_t slot) {
      const std::uint32_t held = job.first[hit.a];
      if (held == expected)
        job.first[hit.a] = slot;
      return held;
    });
  }
  return cudaSuccess;
}

cudaError_t probe(cuda::probe_result *out, cudaStream_t) {
  *out = {0, 0, 0, 1, 1};
  return cudaSuccess;
}
cudaError_t no_faults(unsigned *faults, cudaStream_t) {
  *faults = 0;
  return cudaSuccess;
}

template <class Shape> constexpr cuda::kind_launchers launchers_of(const char *name) {
  return {name,          Shape::fields, pose_rows<Shape>, instances<Shape>, enclose<Shape>,  columns<Shape>,
          places<Shape>, gather<Shape>, boxes<Shape>,     arrange<Shape>,   surround<Shape>, sift<Shape>};
}
const cuda::kind_launchers kinds[] = {
    launchers_of<cga::point_shape>("point"), launchers_of<cga::sphere_shape>("sphere"),
    launchers_of<cga::segment_shape>("segment"), launchers_of<cga::triangle_shape>("triangle"),
    launchers_of<cga::box_shape>("box")};

} // namespace

namespace cga::cuda {

const ::meetc::cuda::catalogue &catalogue() {
  static std::vector<::meetc::cuda::predicate_launchers> predicates;
  const ::meetc::catalogue &all = ::cga::catalogue();
  const auto place_of = [&](const kind_info *k) { return static_cast<int>(k - all.kinds); };
  const auto add = [&]<class P, class A, class B, int Which>(std::type_identity<P>, A, B,
                                                             std::integral_constant<int, Which>) {
    const predicate_info &p = all.predicates[Which];
    predicates.push_back({p.name, place_of(p.a), place_of(p.b), near<P, A, B>, run<Which>, nullptr, nullptr,
                          P::reject_stage::atoms > 0, p.first_met ? order_hits_of<Which> : nullptr,
                          std::is_same_v<P, ::cga::box_box>});
  };
  if (predicates.empty()) {
    add(std::type_identity<::cga::segment_segment>(), segment_shape(), segment_shape(),
        std::integral_constant<int, 0>());
    add(std::type_identity<::cga::point_triangle>(), point_shape(), triangle_shape(), std::integral_constant<int, 1>());
    add(std::type_identity<::cga::segment_triangle>(), segment_shape(), triangle_shape(),
        std::integral_constant<int, 2>());
    add(std::type_identity<::cga::triangle_triangle>(), triangle_shape(), triangle_shape(),
        std::integral_constant<int, 3>());
    add(std::type_identity<::cga::sphere_sphere>(), sphere_shape(), sphere_shape(), std::integral_constant<int, 4>());
    add(std::type_identity<::cga::ball_ball>(), sphere_shape(), sphere_shape(), std::integral_constant<int, 5>());
    add(std::type_identity<::cga::ball_segment>(), sphere_shape(), segment_shape(), std::integral_constant<int, 6>());
    add(std::type_identity<::cga::sphere_segment>(), sphere_shape(), segment_shape(), std::integral_constant<int, 7>());
    add(std::type_identity<::cga::ball_triangle>(), sphere_shape(), triangle_shape(), std::integral_constant<int, 8>());
    add(std::type_identity<::cga::sphere_triangle>(), sphere_shape(), triangle_shape(),
        std::integral_constant<int, 9>());
    add(std::type_identity<::cga::box_box>(), box_shape(), box_shape(), std::integral_constant<int, 10>());
  }
  static const ::meetc::cuda::catalogue c{"cga",        kinds,      5,     predicates.data(), 11,
                                          clear_extent, candidates, probe, no_faults};
  return c;
}

} // namespace cga::cuda
