// The guard of the library's entries: under it the word is the standard one, and behind it the caller's, with the flags of past
// exceptions as they were, whatever the arithmetic between them raised. Prints how many words this processor keeps.
#include "words.hpp"

#include <meetc/environment/environment.hpp>

#include <cstdio>

namespace {

volatile float tiny = 0x1p-149F, big = 0x1.fffffep127F, one = 1, zero = 0;

// Raises every flag, and sees what flushing and rounding would change.
bool computes() {
  const float under = tiny * one + tiny, up = one + 0x1p-24F, over = big * big, quotient = one / zero,
              none = zero / zero;
  return under == 0x1p-148F && up == 1 && over == quotient && none != none;
}

} // namespace

int main() {
  int kept = 0, wrong = 0;
  for (const auto word : strange_words) {
    bool standard = false, right = false;
    const other_word changed(word);
    if (!changed.kept)
      continue;
    ++kept;
    const auto before = meetc::control_word();
    const auto flags = meetc::raised_flags();
    meetc::under_standard_word([&] {
      standard = meetc::standard_environment();
      right = computes();
    });
    const bool same = meetc::control_word() == before && meetc::raised_flags() == flags;
    set_control_word(plain_word);
    wrong += !standard || !right || !same;
  }
#if defined(__SSE2__)
  set_control_word(plain_word | 0x21); // a caller's own flags stay, and no other comes
  const bool right = meetc::under_standard_word(computes);
  wrong += !right || meetc::control_word() != (plain_word | 0x21);
  set_control_word(plain_word);
#endif
  std::printf("guard: %d words kept, %d wrong\n", kept, wrong);
  return wrong != 0;
}
