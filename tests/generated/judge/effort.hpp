// How many cases a test runs: all in an optimised build, a share of them in others.
#ifndef MEETC_TESTS_GENERATED_EFFORT_HPP
#define MEETC_TESTS_GENERATED_EFFORT_HPP

namespace meetc::generated_test {

constexpr int effort(int cases) {
#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
  return cases / 10 + 1;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
  return cases / 10 + 1;
#else
  return cases;
#endif
#else
  return cases;
#endif
}

} // namespace meetc::generated_test

#endif
