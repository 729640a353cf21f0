// The functions of a runtime's table in lanes, on pairs that are hard in different ways. It prints a digest of the answers,
// which are the same on every instruction set, and says whether certified answers are those of the exact rung.
#include <meetc/simd/table_functions.hpp>

#include <cga/ball_triangle.hpp>
#include <cga/triangle_triangle.hpp>

#include <cga/header_only.hpp>

#include <cstdio>
#include <vector>

namespace {

using meetc::answer;

std::uint64_t state = 1;
std::uint64_t random_bits() { // splitmix64
  std::uint64_t x = state += 0x9e3779b97f4a7c15U;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9U;
  x = (x ^ x >> 27) * 0x94d049bb133111ebU;
  return x ^ x >> 31;
}
float whole(int most) {
  return static_cast<float>(static_cast<int>(random_bits() % static_cast<unsigned>(2 * most + 1)) - most);
}

// Numbers of a pair: of 24 bits, or few, so that many signs are zero; near the origin, far from it, or tiny.
void fill(std::vector<float> &row, int kind) {
  const int most = kind % 3 == 0 ? 1 << 23 : kind % 3 == 1 ? 40 : 2;
  const float scale = kind % 5 == 4 ? 0x1p-140F : 1, far = kind % 5 == 3 ? 0x1p20F : 0;
  for (float &x : row)
    x = (whole(most) + far) * scale;
}

struct digest {
  std::uint64_t hash = 1469598103934665603U;
  void add(const std::vector<answer> &all) { // FNV-1a
    for (const answer x : all)
      hash = (hash ^ static_cast<std::uint64_t>(x)) * 1099511628211U;
  }
};

// Radius: the number of A that is not negative, or -1.
template <class P> void run(const char *name, int radius) {
  constexpr std::size_t n = 6000;
  std::vector<float> a, b;
  std::vector<meetc::index_pair> pairs;
  for (std::uint32_t i = 0; i < n; ++i) {
    std::vector<float> x(P::inputs_a), y(P::inputs_b);
    fill(x, static_cast<int>(i));
    fill(y, static_cast<int>(i));
    if (radius >= 0)
      x[static_cast<std::size_t>(radius)] = __builtin_fabsf(x[static_cast<std::size_t>(radius)]);
    else if (i % 7 == 0) // a shared point
      y[3] = x[0], y[4] = x[1], y[5] = x[2];
    a.insert(a.end(), x.begin(), x.end());
    b.insert(b.end(), y.begin(), y.end());
    pairs.push_back({i, i});
  }
  digest found;
  std::vector<answer> exact(n), out(n);
  meetc::decide_exact<P>(a.data(), b.data(), pairs.data(), n, exact.data());
  found.add(exact);
  meetc::decide_plain<P, float>(a.data(), b.data(), pairs.data(), n, out.data());
  found.add(out);
  std::size_t hits = 0, wrong = 0, unsure = 0;
  const auto compare = [&] {
    for (std::size_t i = 0; i < n; ++i)
      wrong += out[i] != answer::unsure && out[i] != exact[i];
  };
  meetc::certify_pairs<P, meetc::in_fp32>(a.data(), b.data(), pairs.data(), n, out.data());
  compare();
  meetc::certify_pairs<P, meetc::in_fp64>(a.data(), b.data(), pairs.data(), n, out.data());
  compare();
  for (const answer x : out)
    unsure += x == answer::unsure;
  for (std::size_t i = 0; i < n; ++i) // one by one
    out[i] = meetc::to_answer(meetc::decide_certified<P>(a.data() + i * P::inputs_a, b.data() + i * P::inputs_b));
  compare();
  for (const answer x : out)
    hits += x == answer::yes, wrong += x == answer::unsure;
  std::printf("%s: %zu hits, %zu wrong, few unsure in fp64: %d, digest %016llx\n", name, hits, wrong, unsure < n / 4,
              static_cast<unsigned long long>(found.hash));
}

} // namespace

int main() {
  run<cga::triangle_triangle>("triangle_triangle", -1);
  run<cga::ball_triangle>("ball_triangle", 3);
}
