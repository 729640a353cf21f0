// Shared by the parts of the device test.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cuda_runtime_api.h>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace cuda_test {

inline void check(cudaError_t e, const char *what) {
  if (e != cudaSuccess)
    throw std::runtime_error(std::string(what) + ": " + cudaGetErrorString(e));
}

// Whether there is no device; says so, for ctest to skip the test.
inline bool no_device() {
  int devices = 0;
  if (cudaGetDeviceCount(&devices) == cudaSuccess && devices > 0)
    return false;
  std::printf("skipped: no CUDA device\n");
  return true;
}
inline constexpr int skipped = 77;

// Device memory that frees itself.
template <class T> class buffer {
public:
  explicit buffer(std::size_t n) : size_(n) {
    check(cudaMalloc(reinterpret_cast<void **>(&data_), n * sizeof(T)), "cudaMalloc");
  }
  explicit buffer(const std::vector<T> &from) : buffer(from.size()) {
    check(cudaMemcpy(data_, from.data(), size_ * sizeof(T), cudaMemcpyHostToDevice), "copy to the device");
  }
  ~buffer() { cudaFree(data_); }
  buffer(const buffer &) = delete;
  buffer &operator=(const buffer &) = delete;
  T *data() const { return data_; }
  std::vector<T> read() const { return read(size_); }
  // The first n.
  std::vector<T> read(std::size_t n) const {
    std::vector<T> out(n);
    check(cudaMemcpy(out.data(), data_, n * sizeof(T), cudaMemcpyDeviceToHost), "copy from the device");
    return out;
  }

private:
  T *data_ = nullptr;
  std::size_t size_;
};

// Stored numbers that meet in degenerate ways: small lattices, far offsets, tiny and huge scales, one-ulp shifts.
inline float number(std::mt19937_64 &random, int family) {
  const auto lattice = static_cast<float>(random() % 5);
  switch (family % 6) {
  case 0:
    return lattice;
  case 1:
    return lattice + 1e6f;
  case 2:
    return std::ldexp(lattice, static_cast<int>(random() % 3) - 140);
  case 3:
    return std::ldexp(lattice, 100 + static_cast<int>(random() % 25));
  case 4:
    return std::ldexp(static_cast<float>(random() % 16777216), static_cast<int>(random() % 200) - 120);
  default:
    return std::nextafter(lattice, random() % 2 ? 10.0f : -10.0f);
  }
}

// Each returns the number of differences and prints what it compared.
long same_decisions();
long same_formulas();
long same_signs();
long sound_arithmetic(); // faults that the self-test finds

} // namespace cuda_test
