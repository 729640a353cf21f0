// Control words that another library may have left behind, each with one thing changed that the bounds
// assume.
#pragma once
#include <meetc/environment/control_word.hpp>

inline constexpr auto plain_word = meetc::plain_control_word;
using meetc::set_control_word;

#if defined(__SSE2__)
// Denormals are zero, flush to zero, both; the three other rounding modes; each exception unmasked; all of
// them.
inline constexpr std::uint32_t strange_words[] = {0x1fc0, 0x9f80, 0x9fc0, 0x3f80, 0x5f80, 0x7f80, 0x1f00,
                                                  0x1e80, 0x1d80, 0x1b80, 0x1780, 0x0f80, 0x0000};
inline std::uint32_t settings(std::uint32_t word) {
  return word & ~0x3fU;
} // without what has happened
#elif defined(__aarch64__)
// FIZ, AH; the six traps; the three other rounding modes; FZ.
inline constexpr std::uint64_t strange_words[] = {1,       2,       1 << 8,  1 << 9,  1 << 10, 1 << 11,
                                                  1 << 12, 1 << 15, 1 << 22, 2 << 22, 3 << 22, 1 << 24};
inline std::uint64_t settings(std::uint64_t word) {
  return word;
}
#endif

// Sets a word, and puts the plain one back. `kept`: the processor has all its bits.
class other_word {
public:
  template <class Word> explicit other_word(Word word) {
    set_control_word(word);
    kept = settings(meetc::control_word()) == settings(word);
  }
  ~other_word() { set_control_word(plain_word); }
  other_word(const other_word &) = delete;
  other_word &operator=(const other_word &) = delete;
  bool kept;
};
