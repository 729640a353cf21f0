// picture/text.hpp: words on a picture, in the fonts of the machine.
//
// Problem: names of files are in any script, and no single font has all letters.
// Method: fontconfig lists the fonts for sans-serif text in the order in which it prefers them, and FreeType draws each
// letter in the first font that has it, smoothed. The list does not depend on the language of the environment, so that the
// same words are the same bytes on one machine.
// Limits: a letter that no font has, and a byte that is no UTF-8, is drawn as a replacement character. Letters stand one by
// one from the left to the right: scripts that join or turn them are readable in parts only. Fonts in colours are left out.
#ifndef MEETC_PICTURE_TEXT_HPP
#define MEETC_PICTURE_TEXT_HPP

#include "meet/picture/image.hpp"

#include <string>
#include <string_view>

namespace meetc::picture {

// Whether the machine has a font. Without one, words have the width 0 and are left out.
bool has_font();

// The width in pixels of words whose letters are `size` pixels high, line to line.
int width_of(std::string_view words, int size);

// The words, or as much of their beginning and their end as fits into `width` pixels, with an ellipsis between them.
std::string shortened(std::string_view words, int size, int width);

// Draws words with the upper left corner of their line at (x, y), clipped, on a rim of a sixth of their size, so that they
// can be read on any background.
void draw_words(image &into, int x, int y, std::string_view words, int size, colour ink, colour rim);

} // namespace meetc::picture

#endif
