// The floating-point control word: which words the error bounds hold under, and the word of the calling thread.
//
// Bounds assume rounding to nearest and gradual underflow. Exceptions must be masked, too: the arithmetic is allowed to
// overflow (it then proves nothing), and must not end a caller who has unmasked them. The two tests are plain functions of
// a word, so that every bit is tested on any machine. Sources: Intel 64 and IA-32 Architectures Software Developer's
// Manual, volume 1, 10.2.3; Arm Architecture Reference Manual for A-profile, FPCR.
#ifndef MEET_CONTROL_WORD_HPP
#define MEET_CONTROL_WORD_HPP

#include <cstdint>

namespace meet {

// MXCSR: all six exceptions masked (bits 7 to 12), round to nearest (13, 14), neither denormals-are-zero (6) nor
// flush-to-zero (15). Bits 0 to 5 record what has happened and change nothing.
constexpr bool standard_mxcsr(std::uint32_t word) { return (word & 0xffc0) == 0x1f80; }

// FPCR: no flush of inputs (FIZ, bit 0), no alternate handling (AH, 1), no trap (IOE, DZE, OFE, UFE, IXE, IDE: 8 to 12
// and 15), round to nearest (RMode, 22 and 23), no flush-to-zero (FZ, 24), no default NaN (DN, 25).
constexpr bool standard_fpcr(std::uint64_t word) { return (word & 0x3c09f03) == 0; }

// Whether this thread's word is one of those. On a processor that is not known here: no, so that integers answer.
inline bool standard_control_word() {
#if defined(__SSE2__)
  return standard_mxcsr(__builtin_ia32_stmxcsr());
#elif defined(__aarch64__)
  std::uint64_t word;
  __asm__ volatile("mrs %0, fpcr" : "=r"(word));
  return standard_fpcr(word);
#else
  return false;
#endif
}

} // namespace meet

#endif
