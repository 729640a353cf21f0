// core/control_word.hpp: the floating-point control word while this library works.
//
// Any library linked with -ffast-math sets flush-to-zero for the whole process; poses and rungs then lose
// subnormals. A guard sets round-to-nearest with gradual underflow and restores what it found. One a thread.
#ifndef MEET_CORE_CONTROL_WORD_HPP
#define MEET_CORE_CONTROL_WORD_HPP

#include <cstdint>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace meet {

class control_word_guard {
public:
  control_word_guard() : found_(get()) { set(plain); }
  ~control_word_guard() { set(found_); }
  control_word_guard(const control_word_guard &) = delete;
  control_word_guard &operator=(const control_word_guard &) = delete;

private:
#if defined(__SSE2__)
  static constexpr std::uint64_t plain = 0x1f80; // all exceptions masked
  static std::uint64_t get() {
    return _mm_getcsr();
  }
  static void set(std::uint64_t word) {
    _mm_setcsr(static_cast<unsigned>(word));
  }
#elif defined(__aarch64__)
  static constexpr std::uint64_t plain = 0;
  static std::uint64_t get() {
    std::uint64_t word;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word));
    return word;
  }
  static void set(std::uint64_t word) {
    __asm__ volatile("msr fpcr, %0" : : "r"(word));
  }
#else
  static constexpr std::uint64_t plain = 0;
  static std::uint64_t get() {
    return 0;
  }
  static void set(std::uint64_t) {}
#endif
  std::uint64_t found_;
};

} // namespace meet

#endif
