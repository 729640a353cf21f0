// bench/truth/numbers.hpp: random numbers that are the same on every machine, which the standard library's distributions are
// not. Method: splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014).
#ifndef MEETC_BENCH_TRUTH_NUMBERS_HPP
#define MEETC_BENCH_TRUTH_NUMBERS_HPP

#include <cstdint>

namespace meetc::bench {

class numbers {
public:
  explicit numbers(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t x = state_ += 0x9e3779b97f4a7c15U;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9U;
    x = (x ^ x >> 27) * 0x94d049bb133111ebU;
    return x ^ x >> 31;
  }
  // A multiple of 2^-23 in [-1, 1).
  float place() { return static_cast<float>(static_cast<std::int64_t>(next() >> 40) - (1 << 23)) * 0x1p-23F; }
  // From -most to most.
  int whole(int most) { return static_cast<int>(next() % static_cast<std::uint64_t>(2 * most + 1)) - most; }
  // From 0 to n - 1.
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }

private:
  std::uint64_t state_;
};

} // namespace meetc::bench

#endif
