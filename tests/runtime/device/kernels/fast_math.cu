// A user's own kernel, compiled with --use_fast_math, which flushes subnormals and defines no macro: `hit` must notice
// it and be right, and `filter` must notice it and be unsure. The fp32 rung without the check must be wrong somewhere,
// or the cases would show nothing.
#include "cuda_test.hpp"

#include <cga/ball_ball.hpp>
#include <cga/header_only.hpp>
#include <cga/point_triangle.hpp>
#include <cga/segment_triangle.hpp>
#include <cga/side_triangle_point.hpp>

#include <exception>

namespace cuda_test {
namespace {

// Both operands of a pair.
template <class A, class B> struct pair_of {
  A a;
  B b;
};
struct outcome {
  int value, first, bare; // the answer or sign by all rungs, by fp32 alone, by fp32 without the check; -2: unsure
};
constexpr int unsure = -2;
MEETC_HD int number_of(meetc::answer x) {
  return x == meetc::answer::unsure ? unsure : x == meetc::answer::yes;
}
MEETC_HD int number_of(meetc::sign_set s) {
  return meetc::is_known(s) ? static_cast<int>(meetc::known_sign(s)) : unsure;
}

template <class P> struct decision {
  template <class Pair> MEETC_HD static outcome of(const Pair &p) {
    float row_a[P::inputs_a], row_b[P::inputs_b];
    to_row(p.a, row_a);
    to_row(p.b, row_b);
    return {P::hit(p.a, p.b), number_of(P::filter(p.a, p.b)),
            number_of(meetc::certify_here<P, meetc::in_fp32>(row_a, row_b))};
  }
};
struct side {
  template <class Pair> MEETC_HD static outcome of(const Pair &p) {
    using P = cga::side_triangle_point_sign;
    float row_a[P::inputs_a], row_b[P::inputs_b];
    to_row(p.a, row_a);
    to_row(p.b, row_b);
    const int bare = number_of(meetc::certify_sign_here<P, meetc::in_fp32>(row_a, row_b));
    return {static_cast<int>(cga::side(p.a, p.b)), meetc::standard_environment() ? bare : unsure, bare};
  }
};

template <class What, class Pair> __global__ void user_kernel(const Pair *pairs, outcome *out, int n) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n)
    out[i] = What::of(pairs[i]);
}

__global__ void environment_kernel(bool *standard) {
  *standard = meetc::standard_environment();
}

// Lattices of a few subnormal steps, some about a normal number: whatever is flushed makes points equal.
float tiny_number(std::mt19937_64 &random, bool far) {
  const float step = std::ldexp(static_cast<float>(random() % 5), -149 + static_cast<int>(random() % 2));
  return far ? 0x1p-126F + step : step;
}

template <class What, class A, class B> long wrong_answers(const char *name, bool lengths = false) {
  constexpr int n = 20'000;
  using pair = pair_of<A, B>;
  std::mt19937_64 random(11);
  std::vector<pair> pairs(n);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    auto *numbers = reinterpret_cast<float *>(&pairs[i]);
    for (std::size_t k = 0; k < sizeof(pair) / sizeof(float); ++k)
      numbers[k] = tiny_number(random, i % 4 == 3 && !(lengths && k % 4 == 3));
  }
  const buffer<pair> in(pairs);
  const buffer<outcome> out(n);
  user_kernel<What><<<(n + 127) / 128, 128>>>(in.data(), out.data(), n);
  check(cudaGetLastError(), "launch");
  check(cudaDeviceSynchronize(), name);
  const std::vector<outcome> have = out.read();
  long wrong = 0, bare_wrong = 0, not_zero = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const int want = What::of(pairs[i]).value; // by the host, which keeps subnormals
    wrong += have[i].value != want;
    wrong += have[i].first != unsure && have[i].first != want;
    bare_wrong += have[i].bare != unsure && have[i].bare != want;
    not_zero += want != 0;
  }
  std::printf("%-20s %ld wrong of %d (%ld are not 0); by fp32 without the check %ld wrong\n", name, wrong, n, not_zero,
              bare_wrong);
  return wrong + (bare_wrong == 0);
}

long fast_math() {
  const buffer<bool> standard(1);
  environment_kernel<<<1, 1>>>(standard.data());
  check(cudaGetLastError(), "launch");
  bool here = true;
  check(cudaMemcpy(&here, standard.data(), sizeof here, cudaMemcpyDeviceToHost), "copy from the device");
  std::printf("the kernel %s its environment for the standard one\n", here ? "takes" : "does not take");
  using namespace cga;
  return here + wrong_answers<decision<ball_ball>, sphere<float>, sphere<float>>("ball_ball", true) +
         wrong_answers<decision<point_triangle>, point<float>, triangle<float>>("point_triangle") +
         wrong_answers<decision<segment_triangle>, segment<float>, triangle<float>>("segment_triangle") +
         wrong_answers<side, triangle<float>, point<float>>("side_triangle_point");
}

} // namespace
} // namespace cuda_test

int main() {
  if (cuda_test::no_device())
    return cuda_test::skipped;
  try {
    const long wrong = cuda_test::fast_math();
    std::printf("%ld wrong\n", wrong);
    return wrong ? 1 : 0;
  } catch (const std::exception &e) {
    std::printf("error: %s\n", e.what());
    return 1;
  }
}
