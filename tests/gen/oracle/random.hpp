// Random small numbers, the same on every machine (the standard distributions are not).
#ifndef MEETC_TESTS_ORACLE_RANDOM_HPP
#define MEETC_TESTS_ORACLE_RANDOM_HPP

#include <cstdint>
#include <gmpxx.h>
#include <random>

namespace meetc::oracle_test {

class random_numbers {
public:
  explicit random_numbers(std::uint64_t seed) : engine_(seed) {}

  // An integer in [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  // A fraction of magnitude at most `limit`, with a denominator of 1 to 4.
  mpq_class fraction(int limit = 9) {
    const int d = integer(1, 4);
    mpq_class q(integer(-limit * d, limit * d), d);
    q.canonicalize();
    return q;
  }

private:
  std::mt19937_64 engine_;
};

} // namespace meetc::oracle_test

#endif
