// Pairs of triangles in kernels of one's own: the first rung decides nearly all, and queues the others for a second kernel.
#include <cga/triangle_triangle.hpp>
#include <cstdio>
#include <cstdlib>
#include <vector>

using touch = cga::triangle_triangle;
using triangle = cga::triangle<float>;

struct lists {
  const triangle *a, *b;
  unsigned pairs, *queue, *queued, *touching; // queue: room for all pairs
};

// One thread a pair (i, i). It has neither the rare case nor a later rung, and few registers.
__global__ void filter_pairs(lists of) {
  const unsigned i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= of.pairs)
    return;
  auto known = meetc::first_answer::unsure;
  if (meetc::standard_environment()) { // false under -ftz=true: nothing is known then
    float a[touch::inputs_a], b[touch::inputs_b];
    to_row(of.a[i], a), to_row(of.b[i], b);
    known = meetc::look<touch, meetc::in_fp32>(a, b);
  }
  if (known == meetc::first_answer::yes)
    atomicAdd(of.touching, 1);
  else if (known != meetc::first_answer::no)
    of.queue[atomicAdd(of.queued, 1)] = i;
}

// One thread a queued pair.
__global__ void decide_queued(lists of) {
  const unsigned place = blockIdx.x * blockDim.x + threadIdx.x;
  if (place < *of.queued && touch::hit(of.a[of.queue[place]], of.b[of.queue[place]]))
    atomicAdd(of.touching, 1);
}

template <class T> T *on_device(std::size_t n) {
  T *data = nullptr;
  if (const cudaError_t e = cudaMalloc(&data, n * sizeof(T)); e != cudaSuccess) {
    std::printf("device: %s\n", cudaGetErrorString(e));
    std::exit(3);
  }
  return data;
}

int main() {
  // Pair i: a triangle, and its like lifted by i - 500 tiny steps, which touches the first for i = 500 alone.
  const unsigned n = 1000;
  std::vector<triangle> first(n, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), second = first;
  for (unsigned i = 0; i < n; ++i)
    for (cga::point<float> *const p : {&second[i].a, &second[i].b, &second[i].c})
      p->z = (static_cast<float>(i) - 500) * 1e-30F;
  triangle *const a = on_device<triangle>(n), *const b = on_device<triangle>(n);
  unsigned *const numbers = on_device<unsigned>(n + 2);
  const lists of{a, b, n, numbers + 2, numbers, numbers + 1};
  cudaMemcpy(a, first.data(), n * sizeof(triangle), cudaMemcpyHostToDevice);
  cudaMemcpy(b, second.data(), n * sizeof(triangle), cudaMemcpyHostToDevice);
  cudaMemset(numbers, 0, 2 * sizeof(unsigned));
  filter_pairs<<<(n + 127) / 128, 128>>>(of);
  decide_queued<<<(n + 127) / 128, 128>>>(of);
  unsigned found[2];
  const cudaError_t e = cudaMemcpy(found, numbers, sizeof found, cudaMemcpyDeviceToHost);
  if (e != cudaSuccess) {
    std::printf("device: %s\n", cudaGetErrorString(e));
    return 3;
  }
  std::printf("%u pairs touch; %u were queued\n", found[1], found[0]);
}
