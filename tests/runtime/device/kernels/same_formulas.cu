// Formulas are host and device functions: the same bits on both sides, where the host has fma too.
#include "cuda_test.hpp"

#include <cga/cga.hpp>
#include <cmath>
#include <cstring>

namespace cuda_test {
namespace {

template <class T> struct inputs {
  cga::sphere<T> s, t;
  cga::line<T> l, k;
  cga::plane<T> p, q;
  cga::circle<T> c, d;
  cga::point_pair<T> e;
};

constexpr int results = 15;

template <class T> MEETC_HD void formulas(const inputs<T> &in, T *out) {
  using namespace cga;
  out[0] = norm2_meet(in.s, in.t);
  out[1] = norm2_meet(in.s, in.l);
  out[2] = norm2_meet(in.s, in.p);
  out[3] = norm2_meet(in.p, in.q);
  out[4] = norm2_meet(in.p, in.l);
  out[5] = norm2_meet(in.c, in.d);
  out[6] = norm2_meet(in.c, in.l);
  out[7] = norm2_meet(in.c, in.p);
  out[8] = norm2_meet(in.c, in.s);
  out[9] = norm2_meet(in.e, in.s);
  out[10] = norm2_meet(in.e, in.p);
  out[11] = norm2_meet(blade(in.s), blade(in.l));
  out[12] = cga::meet(in.l, in.k).n;
  out[13] = cga::meet(in.s, in.t).e1_e2_e3;
  out[14] = norm2_meet(blade(in.c), blade(in.d));
}

template <class T> __global__ void formulas_kernel(const inputs<T> *in, T *out, std::size_t n) {
  const std::size_t i = std::size_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (i < n)
    formulas(in[i], out + i * results);
}

template <class T> long compare(const char *name) {
  constexpr std::size_t n = 20'000;
  std::mt19937_64 random(2);
  std::vector<inputs<T>> all(n);
  for (std::size_t i = 0; i < n; ++i) {
    auto *numbers = reinterpret_cast<T *>(&all[i]);
    for (std::size_t k = 0; k < sizeof(inputs<T>) / sizeof(T); ++k)
      numbers[k] = static_cast<T>(number(random, i % 2 ? 0 : 5)) + static_cast<T>(random() % 1000) / 7;
  }
  std::vector<T> want(n * results);
  for (std::size_t i = 0; i < n; ++i)
    formulas(all[i], &want[i * results]);
  const buffer<inputs<T>> in(all);
  const buffer<T> out(want.size());
  formulas_kernel<<<(n + 127) / 128, 128>>>(in.data(), out.data(), n);
  check(cudaGetLastError(), "launch");
  check(cudaDeviceSynchronize(), "formulas");
  const std::vector<T> have = out.read();
  long differences = 0;
  for (std::size_t i = 0; i < want.size(); ++i)
    differences += std::memcmp(&want[i], &have[i], sizeof(T)) != 0;
  std::printf("formulas in %-6s %ld differences in %zu values\n", name, differences, want.size());
  return differences;
}

} // namespace

long same_formulas() {
  return compare<float>("float") + compare<double>("double");
}

} // namespace cuda_test
