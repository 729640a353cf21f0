// Compares sign by sign, since answers alone could hide a mistake: integers of every width and the exact rung, all stages
// whether or not the decision needs them, and the box form where there is one.
#pragma once
#include "cuda_test.hpp"

#include <meetc/decide/boxes.hpp>
#include <meetc/decide/exact.hpp>

namespace cuda_test {

template <class P> struct all_signs {
  meetc::sign integers[P::atoms], exact[P::atoms];
  meetc::sign_set boxed[P::atoms];
};

template <class P> MEETC_HD void signs_of(const float *a, const float *b, all_signs<P> &out) {
  meetc::each_stage<P>([&](auto stage) {
    using Stage = decltype(stage);
    meetc::integer_signs<P>(a, b).template get<Stage>(out.integers);
    meetc::exact_signs<P>(a, b).template get<Stage>(out.exact);
    if constexpr (!meetc::grouped<P>) // otherwise there is no box form
      meetc::boxed_signs<P, meetc::box_form::per_object>(a, b, 16).template get<Stage>(out.boxed);
  });
}

template <class P> __global__ void signs_kernel(const float *a, const float *b, all_signs<P> *out, int n) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n)
    signs_of(a + P::inputs_a * i, b + P::inputs_b * i, out[i]);
}

template <class P> long same(const char *name) {
  constexpr int n = 20'000;
  std::mt19937_64 random(7);
  std::vector<float> a, b;
  for (int i = 0; i < n; ++i) {
    // One family of numbers, or two that are far apart, which need the widest integers.
    const int family_a = static_cast<int>(random() % 6),
              family_b = random() % 2 ? family_a : static_cast<int>(random() % 6);
    for (int f = 0; f < P::inputs_a; ++f)
      a.push_back(number(random, family_a));
    for (int f = 0; f < P::inputs_b; ++f)
      b.push_back(number(random, family_b));
  }
  const buffer<float> da(a), db(b);
  const buffer<all_signs<P>> out(n);
  signs_kernel<P><<<(n + 127) / 128, 128>>>(da.data(), db.data(), out.data(), n);
  check(cudaDeviceSynchronize(), name);
  const std::vector<all_signs<P>> have = out.read();
  long differences = 0, wrong = 0;
  for (int i = 0; i < n; ++i) {
    all_signs<P> want;
    signs_of(a.data() + P::inputs_a * i, b.data() + P::inputs_b * i, want);
    const all_signs<P> &got = have[static_cast<std::size_t>(i)];
    for (int s = 0; s < P::atoms; ++s) {
      differences += want.integers[s] != got.integers[s] || want.exact[s] != got.exact[s] ||
                     (!meetc::grouped<P> && want.boxed[s].bits != got.boxed[s].bits);
      wrong += got.exact[s] != want.integers[s];
    }
  }
  std::printf("%-18s signs            %ld differences, %ld wrong in %d pairs of %d signs\n", name, differences, wrong,
              n, P::atoms);
  return differences + wrong;
}

} // namespace cuda_test
