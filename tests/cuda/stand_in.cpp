// A stand-in for the device, on the host: memory is memory, and the launchers are loops. So what the engine itself does
// (parts, lists, owners, poses, frames) is tested by the same scenes where there is no device. Two of its filters are
// the worst and the best that the assumed matrix unit may be: one lets go what it may, one keeps what it may.
#include "core/device/kernels.hpp"

#include <cga/ball_form.hpp>
#include <cga/cga_cuda.hpp>
#include <cga/cga_runtime.hpp>
#include <cga/shapes.hpp>
#include <meet/enclosing.hpp>
#include <meet/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <vector>

// ---- the CUDA runtime's calls ------------------------------------------------------------------------------------

extern "C" {

cudaError_t cudaGetDeviceCount(int *count) {
  *count = 1;
  return cudaSuccess;
}
cudaError_t cudaDriverGetVersion(int *version) {
  *version = 0;
  return cudaSuccess;
}
cudaError_t cudaGetDevice(int *device) {
  *device = 0;
  return cudaSuccess;
}
cudaError_t cudaGetDeviceProperties(cudaDeviceProp *p, int) {
  *p = {};
  std::strcpy(p->name, "a stand-in on the host");
  p->major = 9;
  return cudaSuccess;
}
const char *cudaGetErrorString(cudaError_t) { return "an error of the stand-in"; }
cudaError_t cudaGetLastError() { return cudaSuccess; }
cudaError_t cudaMalloc(void **out, std::size_t bytes) {
  *out = std::malloc(bytes);
  std::memset(*out, 0xa5, bytes); // as stale as device memory
  return cudaSuccess;
}
cudaError_t cudaFree(void *data) {
  std::free(data);
  return cudaSuccess;
}
cudaError_t cudaMallocHost(void **out, std::size_t bytes) { return cudaMalloc(out, bytes); }
cudaError_t cudaFreeHost(void *data) { return cudaFree(data); }
cudaError_t cudaMemGetInfo(std::size_t *free, std::size_t *all) {
  *free = *all = 0;
  return cudaSuccess;
}
cudaError_t cudaMemcpy(void *to, const void *from, std::size_t bytes, cudaMemcpyKind) {
  if (bytes > 0)
    std::memcpy(to, from, bytes);
  return cudaSuccess;
}
cudaError_t cudaMemcpyAsync(void *to, const void *from, std::size_t bytes, cudaMemcpyKind kind, cudaStream_t) {
  return cudaMemcpy(to, from, bytes, kind);
}
cudaError_t cudaMemsetAsync(void *to, int value, std::size_t bytes, cudaStream_t) {
  std::memset(to, value, bytes);
  return cudaSuccess;
}
cudaError_t cudaStreamCreateWithFlags(cudaStream_t *stream, unsigned) {
  *stream = nullptr;
  return cudaSuccess;
}
cudaError_t cudaStreamDestroy(cudaStream_t) { return cudaSuccess; }
cudaError_t cudaStreamSynchronize(cudaStream_t) { return cudaSuccess; }
cudaError_t cudaEventCreate(cudaEvent_t *event) {
  *event = nullptr;
  return cudaSuccess;
}
cudaError_t cudaEventDestroy(cudaEvent_t) { return cudaSuccess; }
cudaError_t cudaEventRecord(cudaEvent_t, cudaStream_t) { return cudaSuccess; }
cudaError_t cudaEventSynchronize(cudaEvent_t) { return cudaSuccess; }
cudaError_t cudaEventElapsedTime(float *ms, cudaEvent_t, cudaEvent_t) {
  *ms = 0;
  return cudaSuccess;
}

} // extern "C"

// ---- the engine's own kernels -------------------------------------------------------------------------------------

namespace meet {

cudaError_t to_keys(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                    const std::uint32_t *order_b, const std::uint32_t *owner_b, std::uint64_t *keys, cudaStream_t) {
  for (std::size_t i = 0; i < n; ++i) {
    std::uint32_t a = order_a[slots[i].a], b = order_b[slots[i].b];
    a = owner_a ? owner_a[a] : a, b = owner_b ? owner_b[b] : b;
    keys[i] = static_cast<std::uint64_t>(a) << 32 | b;
  }
  return cudaSuccess;
}
cudaError_t to_pairs(std::uint64_t *keys, std::size_t n, cudaStream_t) {
  for (std::size_t i = 0; i < n; ++i)
    keys[i] = keys[i] >> 32 | keys[i] << 32;
  return cudaSuccess;
}
cudaError_t sort_keys(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to, std::size_t n, int bits,
                      cudaStream_t) {
  bytes = 1;
  if (!space)
    return cudaSuccess;
  std::copy_n(keys, n, to);
  const std::uint64_t mask = bits < 64 ? (std::uint64_t{1} << bits) - 1 : ~std::uint64_t{0}; // too few bits must show
  std::stable_sort(to, to + n, [mask](std::uint64_t x, std::uint64_t y) { return (x & mask) < (y & mask); });
  return cudaSuccess;
}
cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t) {
  bytes = 1;
  if (space)
    *kept = static_cast<unsigned long long>(std::unique_copy(keys, keys + n, to) - to);
  return cudaSuccess;
}

} // namespace meet

// ---- the generated launchers --------------------------------------------------------------------------------------

namespace {

using namespace meet;
using cuda::extent;
using cuda::operand;
using cuda::pair_list;
using form = cga::ball_form;

std::uint64_t ordered(double x) {
  std::uint64_t b;
  std::memcpy(&b, &x, sizeof b);
  return b >> 63 ? ~b : b | std::uint64_t{1} << 63;
}
double from_ordered(std::uint64_t b) {
  b = b >> 63 ? b & ~(std::uint64_t{1} << 63) : ~b;
  double x;
  std::memcpy(&x, &b, sizeof x);
  return x;
}

cudaError_t clear_extent(extent *around, cudaStream_t) {
  for (int k = 0; k < 3; ++k)
    around->low[k] = ~0ULL, around->high[k] = 0;
  return cudaSuccess;
}
template <class Shape>
cudaError_t place(const cuda::view &v, const cuda::placement &at, const std::uint32_t *order, float *to,
                  unsigned long long *bad, cudaStream_t) {
  constexpr int fields = Shape::fields;
  *bad = ~0ULL;
  for (std::uint32_t i = 0; i < v.elements; ++i) {
    const float *row = v.data + i * std::size_t{fields};
    float *out = to + i * std::size_t{fields};
    for (int f = 0; f < fields; ++f)
      if (Shape::role_of(f) == role::length)
        out[f] = static_cast<float>(static_cast<double>(row[f]) * at.length_scale);
      else if (Shape::role_of(f) == role::x)
        for (int k = 0; k < 3; ++k) {
          const double *m = at.m + 4 * k;
          const double x = row[f], y = row[f + 1], z = row[f + 2];
          out[f + k] = static_cast<float>(((m[0] * x + m[1] * y) + m[2] * z) + m[3]);
        }
    if (!std::all_of(out, out + fields, [](float x) { return std::isfinite(x); }))
      *bad = std::min(*bad, static_cast<unsigned long long>(order[i]) << 32 | i);
  }
  return cudaSuccess;
}
template <class Shape> cudaError_t enclose(const float *rows, std::uint32_t n, extent *around, cudaStream_t) {
  for (std::uint32_t i = 0; i < n; ++i) {
    double ball[4];
    ball_of_box<Shape>(rows + i * std::size_t{Shape::fields}, ball);
    for (int k = 0; k < 3; ++k) {
      around->low[k] = std::min<unsigned long long>(around->low[k], ordered(ball[k] - ball[3]));
      around->high[k] = std::max<unsigned long long>(around->high[k], ordered(ball[k] + ball[3]));
    }
  }
  return cudaSuccess;
}
template <class Shape>
cudaError_t columns(cuda::filter by, cuda::grouping g, cover c, bool first, const float *rows, std::uint32_t n,
                    const extent *around, void *out, cudaStream_t) {
  double lo[3], hi[3];
  for (int k = 0; k < 3; ++k)
    lo[k] = from_ordered(around->low[k]), hi[k] = from_ordered(around->high[k]);
  const std::uint32_t objects = operand{rows, n, g, nullptr}.objects(), size = cuda::size_of(g);
  for (std::size_t i = 0; i < matrix_padded(objects); ++i) {
    double ball[4] = {0, 0, 0, 0};
    placing where = placing::apart;
    if (i < objects) {
      const auto begin = static_cast<std::uint32_t>(i) * size;
      object_ball<Shape>(c, rows, begin, std::min(n, begin + size), ball);
      where = place_ball(frame_of(lo, hi), ball);
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

void append(const pair_list &to, index_pair p) {
  if (*to.count < to.capacity)
    to.pairs[*to.count] = p;
  ++*to.count;
}

bool negative(cuda::filter by, const double *x, const double *y) {
  double sum = 0, size = 0;
  for (int k = 0; k < matrix_columns; ++k)
    sum += x[k] * y[k], size += std::fabs(x[k] * y[k]);
  const double off = 17 * 0x1p-23 * size;
  return by == cuda::filter::mma ? sum + off < 0 : sum - off < 0;
}

cudaError_t candidates(cuda::filter by, const operand &a, const operand &b, cuda::part of, pair_list out, cudaStream_t) {
  // Where the part ends with the set, its padding is looked at, too.
  const auto end_of = [](std::uint32_t end, const operand &o) {
    return end == o.objects() ? static_cast<std::uint32_t>(matrix_padded(end)) : end;
  };
  if (of.first_a % cuda::part_step != 0 || of.first_b % cuda::part_step != 0 || of.end_a > a.objects() || of.end_b > b.objects())
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
      const bool keep =
          by == cuda::filter::float32
              ? std::signbit(bilinear<form>(static_cast<const float *>(a.columns) + i * std::size_t{form::products + 1},
                                            static_cast<const float *>(b.columns) + j * std::size_t{form::products + 1}))
              : negative(by, &x[(i - of.first_a) * std::size_t{matrix_columns}], &y[(j - of.first_b) * std::size_t{matrix_columns}]);
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

template <int Which>
cudaError_t run(cuda::step which, const operand &a, const operand &b, pair_list in, pair_list yes, pair_list unsure, cudaStream_t) {
  const predicate_info &p = cga::catalogue().predicates[Which];
  const auto fa = static_cast<std::size_t>(p.a->fields), fb = static_cast<std::size_t>(p.b->fields);
  const bool near = which == cuda::step::near_boxes || which == cuda::step::near_reject;
  std::vector<index_pair> taken_apart;
  for (std::size_t i = 0; i < std::min(*in.count, in.capacity); ++i) {
    const index_pair q = in.pairs[i];
    const std::uint32_t size = near ? cuda::size_of(a.by) : 1;
    for (std::uint32_t x = q.a * size; x < std::min(a.elements, (q.a + 1) * size); ++x)
      for (std::uint32_t y = q.b * size; y < std::min(b.elements, (q.b + 1) * size); ++y)
        taken_apart.push_back({x, y});
  }
  const std::size_t n = taken_apart.size();
  in.pairs = taken_apart.data();
  std::vector<answer> answers(n);
  if (!near) {
    const int at = static_cast<int>(which) - static_cast<int>(cuda::step::plain_fp32);
    const decide_function decide = which >= cuda::step::certify_fp32
                                       ? p.certify[static_cast<int>(which) - static_cast<int>(cuda::step::certify_fp32)]
                                       : p.decide[at];
    decide(a.rows, b.rows, in.pairs, n, answers.data());
  } else if (which == cuda::step::near_reject) {
    p.certify[0](a.rows, b.rows, in.pairs, n, answers.data()); // no: as if the reject stage had said so
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (near) {
      float lo_a[3], hi_a[3], lo_b[3], hi_b[3];
      p.a->box(a.rows + in.pairs[i].a * fa, lo_a, hi_a);
      p.b->box(b.rows + in.pairs[i].b * fb, lo_b, hi_b);
      bool touch = true;
      for (int k = 0; k < 3; ++k)
        touch = touch && lo_a[k] <= hi_b[k] && lo_b[k] <= hi_a[k];
      *unsure.count += touch;
      if (touch && (which == cuda::step::near_boxes || answers[i] != answer::no))
        append(yes, in.pairs[i]);
    } else if (answers[i] == answer::yes) {
      append(yes, in.pairs[i]);
    } else if (answers[i] == answer::unsure) {
      append(unsure, in.pairs[i]);
    }
  }
  return cudaSuccess;
}

cudaError_t probe(cuda::probe_result *out, cudaStream_t) {
  *out = {0, 0, 0, 1, 0, 1};
  return cudaSuccess;
}

const cuda::kind_launchers kinds[] = {{"point", 3, place<cga::point_shape>, enclose<cga::point_shape>, columns<cga::point_shape>},
                                      {"sphere", 4, place<cga::sphere_shape>, enclose<cga::sphere_shape>, columns<cga::sphere_shape>},
                                      {"segment", 6, place<cga::segment_shape>, enclose<cga::segment_shape>, columns<cga::segment_shape>},
                                      {"triangle", 9, place<cga::triangle_shape>, enclose<cga::triangle_shape>, columns<cga::triangle_shape>}};

} // namespace

namespace cga::cuda {

const ::meet::cuda::catalogue &catalogue() {
  static std::vector<::meet::cuda::predicate_launchers> predicates;
  const ::meet::catalogue &all = ::cga::catalogue();
  const auto place_of = [&](const kind_info *k) { return static_cast<int>(k - all.kinds); };
  const auto add = [&](int i, auto launch) {
    predicates.push_back({all.predicates[i].name, place_of(all.predicates[i].a), place_of(all.predicates[i].b), launch, nullptr, nullptr});
  };
  if (predicates.empty()) {
    add(0, run<0>), add(1, run<1>), add(2, run<2>), add(3, run<3>), add(4, run<4>);
    add(5, run<5>), add(6, run<6>), add(7, run<7>), add(8, run<8>), add(9, run<9>);
  }
  static const ::meet::cuda::catalogue c{"cga",       kinds,        4,     predicates.data(), 10,
                                         clear_extent, candidates, probe};
  return c;
}

} // namespace cga::cuda
