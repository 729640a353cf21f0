// Work on one set on the device: its pose. Included by nvcc only.
#ifndef MEETC_CUDA_SETS_HPP
#define MEETC_CUDA_SETS_HPP

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/table.hpp>
#include <meetc/cuda/warp.hpp>
#include <meetc/decide/tolerant.hpp>

#include <algorithm>

namespace meetc::cuda {

inline constexpr int set_threads = 128;
inline unsigned blocks_for(std::size_t n) {
  return static_cast<unsigned>((n + set_threads - 1) / set_threads);
}

__device__ inline float moved(const double *m, double x, double y, double z) {
  return __double2float_rn(
      __dadd_rn(__dadd_rn(__dadd_rn(__dmul_rn(m[0], x), __dmul_rn(m[1], y)), __dmul_rn(m[2], z)), m[3]));
}

// Whether a row is finite, and as the kind's rule says.
template <class Shape> __device__ bool is_good(const float *row) {
  bool good = Shape::obeys(row);
  for (int f = 0; f < Shape::fields; ++f)
    good &= isfinite(row[f]);
  return good;
}
// A row in the pose. Returns whether it is good.
template <class Shape> __device__ bool posed_row(const pose_matrix &at, const float *in, float *out) {
  for (int f = 0; f < Shape::fields; ++f)
    out[f] = in[f];
  if (!at.identity) {
    for (int f = 0; f < Shape::fields; ++f)
      if (Shape::role_of(f) == role::length) {
        out[f] = __double2float_rn(__dmul_rn(in[f], at.length_scale));
      } else if (Shape::role_of(f) == role::x) {
        const bool has_z = f + 2 < Shape::fields && Shape::role_of(f + 2) == role::z;
        const double x = in[f], y = in[f + 1], z = has_z ? in[f + 2] : 0.0F;
        out[f] = moved(at.m, x, y, z);
        out[f + 1] = moved(at.m + 4, x, y, z);
        if (has_z)
          out[f + 2] = moved(at.m + 8, x, y, z);
      }
  }
  if (at.on_grid)
    for (int f = 0; f < Shape::fields; ++f)
      out[f] = nearest_multiple(out[f], at.grid_low);
  return is_good<Shape>(out);
}

// Kinds that can be indexed consist of points, x y z each.
template <class Shape> bool can_be_indexed(const view &v) {
  return !v.index || (Shape::fields % 3 == 0 && Shape::pad < 0);
}

// The number of element i of a view among all.
__device__ inline std::uint32_t number_in(const view &v, std::uint32_t i) {
  return v.only ? v.only[i] : i;
}

// Reads element i of all. Returns whether it has all of its points.
template <class Shape> __device__ bool read_element(const view &v, std::uint32_t i, float (&in)[Shape::fields]) {
  constexpr int fields = Shape::fields;
  const auto *const bytes = reinterpret_cast<const char *>(v.data);
  const std::uintptr_t low_bits = reinterpret_cast<std::uintptr_t>(bytes) | v.stride_bytes;
  if (fields == 4 && !v.index && low_bits % 16 == 0) {
    const float4 row = *reinterpret_cast<const float4 *>(bytes + i * v.stride_bytes);
    const float all[4] = {row.x, row.y, row.z, row.w};
    for (int f = 0; f < fields; ++f)
      in[f] = all[f % 4];
    return true;
  }
  bool good = true;
  for (int f = 0; f < fields; ++f) {
    // Kinds that can be indexed consist of points, x y z each.
    const std::size_t vertex = v.index ? v.index[i * (std::size_t{fields} / 3) + static_cast<unsigned>(f / 3)] : i;
    const bool there = !v.index || vertex < v.vertices;
    const char *const at_field =
        bytes + vertex * v.stride_bytes + sizeof(float) * static_cast<unsigned>(v.index ? f % 3 : f);
    good &= there;
    in[f] = 0;
    if (there && low_bits % 4 == 0)
      in[f] = *reinterpret_cast<const float *>(at_field);
    else if (there)
      memcpy(in + f, at_field, sizeof(float)); // byte by byte
  }
  return good;
}
// Element i of a view in the pose. Returns whether it is one.
template <class Shape>
__device__ bool posed_element(const view &v, const pose_matrix &at, std::uint32_t i, float *out) {
  float in[Shape::fields];
  const bool there = read_element<Shape>(v, number_in(v, i), in);
  return posed_row<Shape>(at, in, out) && there;
}

// A warp writes the first rows, up to 32, from its shared memory, in one piece.
template <int Fields> __device__ void write_rows(const float *from, std::uint32_t rows, float *to) {
  __syncwarp();
  for (unsigned k = threadIdx.x % 32; k < (rows < 32 ? rows : 32) * Fields; k += 32)
    to[k] = from[k];
  __syncwarp();
}

template <class Shape>
__global__ void __launch_bounds__(set_threads) pose_kernel(view v, pose_matrix at, const std::uint32_t *order,
                                                           float *rows, unsigned long long *bad, joined_box *around) {
  constexpr unsigned fields = Shape::fields;
  __shared__ float rows_of_warps[set_threads / 32][32 * fields];
  const unsigned lane = threadIdx.x % 32;
  float *const of_warp = rows_of_warps[threadIdx.x / 32];
  tree_box all; // empty
  for (std::size_t base = blockIdx.x * std::size_t{set_threads} + threadIdx.x - lane; base < v.elements;
       base += gridDim.x * std::size_t{set_threads}) {
    const auto i = static_cast<std::uint32_t>(base + lane);
    float row[fields];
    if (i < v.elements && i >= base) {
      if (!posed_element<Shape>(v, at, i, row) && bad)
        atomicMin(bad, static_cast<unsigned long long>(order ? order[i] : number_in(v, i)) << 32 | i);
      if (around)
        all.widen(box_of_row<Shape>(row));
      for (unsigned f = 0; f < fields && rows; ++f)
        of_warp[lane * fields + f] = row[f];
    }
    if (rows)
      write_rows<Shape::fields>(of_warp, static_cast<std::uint32_t>(v.elements - base), rows + base * fields);
  }
  if (around)
    join_boxes<set_threads>(all, around);
}
template <class Shape>
cudaError_t pose_rows(const view &v, const pose_matrix &at, const std::uint32_t *order, float *rows,
                      unsigned long long *bad, joined_box *around, cudaStream_t stream) {
  const cudaError_t e = bad ? cudaMemsetAsync(bad, 0xff, sizeof *bad, stream) : cudaSuccess;
  if (e != cudaSuccess || v.elements == 0)
    return e;
  if (!can_be_indexed<Shape>(v))
    return cudaErrorInvalidValue;
  // No more than run at once, since all change the same box.
  const unsigned blocks = std::min(blocks_for(v.elements), blocks_at_once<pose_kernel<Shape>, set_threads>());
  return launch_after<pose_kernel<Shape>>(blocks, set_threads, stream, v, at, order, rows, bad, around);
}

template <class Shape>
__global__ void __launch_bounds__(set_threads) instances_kernel(const float *rows, unsigned n, const pose_matrix *at,
                                                                unsigned poses, float *to, unsigned long long *bad) {
  for (std::size_t i = blockIdx.x * std::size_t{set_threads} + threadIdx.x; i < std::size_t{n} * poses;
       i += gridDim.x * std::size_t{set_threads}) {
    const auto pose = static_cast<unsigned>(i / n);
    float out[Shape::fields];
    const bool good = posed_row<Shape>(at[pose], rows + (i - std::size_t{pose} * n) * Shape::fields, out);
    for (int f = 0; f < Shape::fields; ++f)
      to[i * Shape::fields + f] = out[f];
    if (!good)
      atomicMin(bad, static_cast<unsigned long long>(i));
  }
}
template <class Shape>
cudaError_t instances(const float *rows, std::uint32_t n, const pose_matrix *at, std::uint32_t poses, float *to,
                      unsigned long long *bad, cudaStream_t stream) {
  const cudaError_t e = cudaMemsetAsync(bad, 0xff, sizeof *bad, stream);
  const std::size_t all = std::size_t{n} * poses;
  if (e != cudaSuccess || all == 0)
    return e;
  const unsigned blocks = blocks_for(std::min(all, std::size_t{65536} * set_threads));
  return launch_after<instances_kernel<Shape>>(blocks, set_threads, stream, rows, n, at, poses, to, bad);
}

} // namespace meetc::cuda

#endif
