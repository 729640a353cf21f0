#include "entries.hpp"

#include "tests/downstream/flags/words.hpp"

#include <cfenv>
#include <cstdio>
#include <fmt/format.h>

namespace words_test {
namespace {

#if defined(__SSE2__)
// The x87's word as well, as the C library's functions set both.
unsigned short x87_word() {
  unsigned short word = 0;
  __asm__ volatile("fnstcw %0" : "=m"(word));
  return word;
}
#else
unsigned short x87_word() {
  return 0;
}
#endif

std::fenv_t before;
decltype(meetc::control_word()) word;
decltype(meetc::raised_flags()) flags;
unsigned short other;

std::vector<setting> all_settings() {
  std::vector<setting> all = {{"default", [](unsigned) { std::fesetenv(FE_DFL_ENV); }, 0}};
  // With a flag raised, which the call must leave as it is; an exception that is not masked has none.
  for (unsigned i = 0; i < std::size(strange_words); ++i)
    all.push_back(
        {fmt::format("word {:#x}", strange_words[i]), [](unsigned w) { set_control_word(strange_words[w]); }, i});
#if defined(__SSE2__)
  all.push_back({"a raised flag", [](unsigned) { set_control_word(0x1f81); }, 0});
  all.push_back({"no denormals, with a raised flag", [](unsigned) { set_control_word(0x9fe2); }, 0});
#endif
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    all.push_back({fmt::format("fesetround({:#x})", mode), [](unsigned m) { std::fesetround(static_cast<int>(m)); },
                   static_cast<unsigned>(mode)});
#if defined(__GLIBC__)
  for (const int which : {FE_ALL_EXCEPT, FE_INEXACT, FE_UNDERFLOW, FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW})
    all.push_back({fmt::format("feenableexcept({:#x})", which), [](unsigned w) { feenableexcept(static_cast<int>(w)); },
                   static_cast<unsigned>(which)});
#endif
  return all;
}

} // namespace

std::span<const setting> settings() {
  static const std::vector<setting> all = all_settings();
  return all;
}

void caller::enter() {
  std::fegetenv(&before);
  setting_.set(setting_.which);
  word = meetc::control_word(), flags = meetc::raised_flags(), other = x87_word();
}

void caller::leave() {
  kept = kept && word == meetc::control_word() && flags == meetc::raised_flags() && other == x87_word();
  std::fesetenv(&before);
}

} // namespace words_test
