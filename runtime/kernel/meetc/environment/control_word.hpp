// The floating-point control word: the words under which the error bounds hold, the word of the calling thread, and the
// guard that each entry of the library holds.
//
// Bounds assume rounding to nearest and gradual underflow. Exceptions must be masked as well: the arithmetic may
// overflow (it then proves nothing) and must not end a program whose caller has unmasked them. The two tests are plain
// functions of a word, so every bit is tested on any machine. Sources: Intel 64 and IA-32 Architectures Software
// Developer's Manual, volume 1, 10.2.3; Arm Architecture Reference Manual for A-profile, FPCR.
#ifndef MEETC_ENVIRONMENT_CONTROL_WORD_HPP
#define MEETC_ENVIRONMENT_CONTROL_WORD_HPP

#include <meetc/environment/instruction_set.hpp>

#include <cstdint>

MEETC_NAMESPACE(meetc) {

// MXCSR: all six exceptions are masked (bits 7 to 12), rounding is to nearest (13, 14), and neither denormals-are-zero
// (6) nor flush-to-zero (15) is set. Bits 0 to 5 record past exceptions and change nothing.
constexpr bool standard_mxcsr(std::uint32_t word) {
  return (word & 0xffc0) == 0x1f80;
}

// FPCR: inputs are not flushed (FIZ, bit 0), there is no alternate handling (AH, 1) and no trap (IOE, DZE, OFE, UFE,
// IXE, IDE: 8 to 12 and 15), rounding is to nearest (RMode, 22 and 23), and results are not flushed (FZ, 24). A default
// NaN (DN, 25) does no harm.
constexpr bool standard_fpcr(std::uint64_t word) {
  return (word & 0x1c09f03) == 0;
}

// Whether all exceptions are masked, whatever the other bits say.
constexpr bool masks_mxcsr(std::uint32_t word) {
  return (word & 0x1f80) == 0x1f80;
}
constexpr bool masks_fpcr(std::uint64_t word) {
  return (word & 0x9f00) == 0;
}

// This thread's word, the standard word, and whether the two agree. On an unknown processor they never do, so that
// integers answer. raised_flags() are those of past exceptions, where they are not in the word itself.
#if defined(__SSE2__)
inline constexpr std::uint32_t plain_control_word = 0x1f80;
inline std::uint32_t control_word() {
  return __builtin_ia32_stmxcsr();
}
inline void set_control_word(std::uint32_t word) {
  __builtin_ia32_ldmxcsr(word);
}
inline std::uint32_t raised_flags() {
  return 0;
}
inline void set_raised_flags(std::uint32_t) {}
inline bool standard_control_word() {
  return standard_mxcsr(control_word());
}
inline bool exceptions_are_masked() {
  return masks_mxcsr(control_word());
}
#elif defined(__aarch64__)
inline constexpr std::uint64_t plain_control_word = 0;
inline std::uint64_t control_word() {
  std::uint64_t word;
  __asm__ volatile("mrs %0, fpcr" : "=r"(word));
  return word;
}
inline void set_control_word(std::uint64_t word) {
  __asm__ volatile("msr fpcr, %0" : : "r"(word));
}
inline std::uint64_t raised_flags() {
  std::uint64_t flags;
  __asm__ volatile("mrs %0, fpsr" : "=r"(flags));
  return flags;
}
inline void set_raised_flags(std::uint64_t flags) {
  __asm__ volatile("msr fpsr, %0" : : "r"(flags));
}
inline bool standard_control_word() {
  return standard_fpcr(control_word());
}
inline bool exceptions_are_masked() {
  return masks_fpcr(control_word());
}
#else
inline constexpr std::uint64_t plain_control_word = 0;
inline std::uint64_t control_word() {
  return 0;
}
inline void set_control_word(std::uint64_t) {}
inline std::uint64_t raised_flags() {
  return 0;
}
inline void set_raised_flags(std::uint64_t) {}
inline bool standard_control_word() {
  return false;
}
inline bool exceptions_are_masked() {
  return true;
}
#endif

// Sets the standard word, and at the end puts back the word that it found, with the flags of past exceptions as they were.
// The flags go back before the masks: an exception that was masked when it was raised must not trap after the caller's
// mask is back. A word that is standard already is not written, since writing takes longer than reading.
class control_word_guard {
public:
  control_word_guard() {
    if (!standard_control_word())
      set_control_word(plain_control_word);
  }
  ~control_word_guard() {
    if (raised_flags() != flags_)
      set_raised_flags(flags_);
    if (control_word() != word_)
      set_control_word(word_);
  }
  control_word_guard(const control_word_guard &) = delete;
  control_word_guard &operator=(const control_word_guard &) = delete;

private:
  decltype(control_word()) word_ = control_word();
  decltype(raised_flags()) flags_ = raised_flags();
};

// Runs call() out of line, behind an effect that compilers cannot see through, so that none moves its arithmetic out.
template <class Call> __attribute__((noinline)) decltype(auto) call_apart(const Call &call) {
  __asm__ volatile("" : : : "memory");
  return call();
}

// Runs call() under the standard word, whatever the caller's is: the one way into the library. call() takes its
// operands by reference, since compilers do not know that arithmetic depends on the word and may compute values early.
template <class Call> decltype(auto) under_standard_word(const Call &call) {
  const control_word_guard guard;
  return call_apart(call);
}

} // MEETC_NAMESPACE(meetc)

#endif
