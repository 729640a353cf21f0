// Every predicate and rung: the launcher's answers against the CPU table's. Bounded rungs may be unsure of other pairs.
#include "cuda_test.hpp"
#include "launchers.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <cmath>

namespace cuda_test {
namespace {

std::vector<float> rows(const meetc::kind_info &kind, std::size_t n, std::mt19937_64 &random) {
  std::vector<float> out;
  for (std::size_t i = 0; i < n; ++i)
    for (int f = 0; f < kind.fields; ++f) {
      const float v = number(random, static_cast<int>(i));
      out.push_back(kind.roles[f] == meetc::role::length ? std::fabs(v) : v);
    }
  return out;
}

} // namespace

long same_decisions() {
  constexpr std::size_t n = 600;
  constexpr std::size_t pairs_count = 200'000;
  std::mt19937_64 random(1);
  long differences = 0;
  const meetc::catalogue &all = cga::catalogue();
  for (int p = 0; p < all.predicate_count; ++p) {
    const meetc::predicate_info &predicate = all.predicates[p];
    const std::vector<float> a = rows(*predicate.a, n, random), b = rows(*predicate.b, n, random);
    std::vector<meetc::index_pair> pairs;
    for (std::size_t i = 0; i < pairs_count; ++i) {
      // Mostly of one family, so that the operands are near each other.
      const auto x = static_cast<std::uint32_t>(random() % n);
      auto y = static_cast<std::uint32_t>(random() % n);
      if (i % 8)
        y = (y / 6 * 6 + x % 6) % static_cast<std::uint32_t>(n);
      pairs.push_back({x, y});
    }
    const buffer<float> da(a), db(b);
    const buffer<meetc::index_pair> dp(pairs);
    const buffer<meetc::answer> out(pairs.size());
    const auto compare = [&](const char *name, meetc::decide_function on_cpu, launcher on_device, meetc::rung rung,
                             int bounded) {
      std::vector<meetc::answer> want(pairs.size());
      on_cpu(a.data(), b.data(), pairs.data(), pairs.size(), want.data());
      check(on_device(rung, da.data(), db.data(), dp.data(), pairs.size(), out.data(), nullptr), "launch");
      check(cudaDeviceSynchronize(), predicate.name);
      const std::vector<meetc::answer> have = out.read();
      long wrong = 0, hits = 0, unsure = 0;
      for (std::size_t i = 0; i < want.size(); ++i) {
        wrong += differ(want[i], have[i], bounded);
        hits += want[i] == meetc::answer::yes;
        unsure += want[i] == meetc::answer::unsure;
      }
      std::printf("%-18s %-16s %ld differences in %zu pairs (%ld hits, %ld unsure)\n", predicate.name, name, wrong,
                  want.size(), hits, unsure);
      differences += wrong;
    };
    const launchers &on_device = launchers_of(predicate.name);
    static const char *const rungs[] = {"fp32", "fp64", "fp64x2", "exact", "certified"};
    static const char *const bounded[] = {"bounded fp32", "bounded fp64", "bounded fp64x2"};
    for (int r = 0; r < static_cast<int>(meetc::rung::tolerant); ++r) // the shipped scene does not ask for it
      compare(rungs[r], predicate.decide[std::min(r, static_cast<int>(meetc::rung::exact))], on_device.decide,
              static_cast<meetc::rung>(r), -1); // the truth of certified is exact
    for (int r = 0; r < meetc::bounded_rungs; ++r)
      compare(bounded[r], predicate.certify[r], on_device.certify, static_cast<meetc::rung>(r), r);
  }
  // An unknown rung is an error, not a crash.
  if (cga::cuda::ball_ball::decide(static_cast<meetc::rung>(77), nullptr, nullptr, nullptr, 1, nullptr, nullptr) !=
      cudaErrorInvalidValue) {
    std::printf("an unknown rung was taken\n");
    ++differences;
  }
  return differences;
}

} // namespace cuda_test
