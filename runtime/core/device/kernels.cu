#include "core/device/kernels.hpp"

#include <cub/cub.cuh>

namespace meet {
namespace {

constexpr unsigned threads = 256;
unsigned blocks_for(std::size_t n) {
  const std::size_t blocks = (n + threads - 1) / threads;
  return static_cast<unsigned>(blocks < 65536 ? blocks : 65536);
}

// Which number of a row is what: at most so many fields of a kind.
constexpr int most_fields = 64;
struct roles {
  int fields;
  role of[most_fields];
};

__device__ float moved(const double *m, double x, double y, double z) {
  const double sum = __dadd_rn(__dadd_rn(__dadd_rn(__dmul_rn(m[0], x), __dmul_rn(m[1], y)), __dmul_rn(m[2], z)), m[3]);
  return __double2float_rn(sum);
}

__global__ void move_kernel(roles r, pose at, const float *rows, const std::uint32_t *order, unsigned n, float *to,
                            unsigned long long *bad) {
  for (unsigned i = blockIdx.x * threads + threadIdx.x; i < n; i += gridDim.x * threads) {
    const float *row = rows + i * static_cast<std::size_t>(r.fields);
    float *out = to + i * static_cast<std::size_t>(r.fields);
    bool finite = true;
    for (int f = 0; f < r.fields; ++f) {
      if (r.of[f] == role::length) {
        out[f] = __double2float_rn(__dmul_rn(row[f], at.length_scale));
      } else if (r.of[f] == role::x) {
        const bool has_z = f + 2 < r.fields && r.of[f + 2] == role::z;
        const double x = row[f], y = row[f + 1], z = has_z ? row[f + 2] : 0.0F;
        out[f] = moved(at.m, x, y, z);
        out[f + 1] = moved(at.m + 4, x, y, z);
        if (has_z)
          out[f + 2] = moved(at.m + 8, x, y, z);
      }
    }
    for (int f = 0; f < r.fields; ++f)
      finite = finite && isfinite(out[f]);
    if (!finite)
      atomicMin(bad, static_cast<unsigned long long>(order[i]) << 32 | i);
  }
}

__global__ void keys_kernel(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                            const std::uint32_t *order_b, const std::uint32_t *owner_b, std::uint64_t *keys) {
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads}) {
    std::uint32_t a = order_a[slots[i].a], b = order_b[slots[i].b];
    a = owner_a ? owner_a[a] : a;
    b = owner_b ? owner_b[b] : b;
    keys[i] = static_cast<std::uint64_t>(a) << 32 | b;
  }
}

__global__ void pairs_kernel(std::uint64_t *keys, std::size_t n) {
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < n; i += gridDim.x * std::size_t{threads})
    keys[i] = keys[i] >> 32 | keys[i] << 32;
}

} // namespace

cudaError_t move_rows(const kind_info &kind, const pose &at, const float *rows, const std::uint32_t *order,
                      std::uint32_t elements, float *to, unsigned long long *bad, cudaStream_t stream) {
  if (kind.fields > most_fields)
    return cudaErrorInvalidValue;
  roles r{kind.fields, {}};
  for (int f = 0; f < kind.fields; ++f)
    r.of[f] = kind.roles[f];
  const cudaError_t e = cudaMemsetAsync(bad, 0xff, sizeof *bad, stream);
  if (e != cudaSuccess || elements == 0)
    return e;
  move_kernel<<<blocks_for(elements), threads, 0, stream>>>(r, at, rows, order, elements, to, bad);
  return cudaGetLastError();
}

cudaError_t to_keys(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                    const std::uint32_t *order_b, const std::uint32_t *owner_b, std::uint64_t *keys, cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  keys_kernel<<<blocks_for(n), threads, 0, stream>>>(slots, n, order_a, owner_a, order_b, owner_b, keys);
  return cudaGetLastError();
}

cudaError_t to_pairs(std::uint64_t *keys, std::size_t n, cudaStream_t stream) {
  static_assert(sizeof(index_pair) == sizeof(std::uint64_t));
  if (n == 0)
    return cudaSuccess;
  pairs_kernel<<<blocks_for(n), threads, 0, stream>>>(keys, n);
  return cudaGetLastError();
}

cudaError_t sort_keys(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to, std::size_t n,
                      int bits, cudaStream_t stream) {
  return cub::DeviceRadixSort::SortKeys(space, bytes, keys, to, n, 0, bits, stream);
}

cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t stream) {
  return cub::DeviceSelect::Unique(space, bytes, keys, to, kept, static_cast<std::int64_t>(n), stream);
}

} // namespace meet
