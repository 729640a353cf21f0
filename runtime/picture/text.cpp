#include "meet/picture/text.hpp"

#include <fontconfig/fontconfig.h>
#include <freetype/freetype.h>
#include <ft2build.h>

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace meetc::picture {

namespace {

constexpr char32_t replacement = 0xFFFD;

// Takes one character off the front of UTF-8; the replacement for a byte that begins none, and for a control character.
char32_t take(std::string_view &text) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t size = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
  char32_t c = size == 1 ? first : first & (0x7Fu >> size);
  bool whole = size > 0 && size <= text.size();
  for (std::size_t i = 1; whole && i < size; ++i) {
    whole = byte(i) >> 6 == 2;
    c = c << 6 | (byte(i) & 0x3Fu);
  }
  constexpr char32_t least[] = {0, 0x20, 0x80, 0x800, 0x10000};
  whole = whole && c >= least[size] && c <= 0x10FFFF && c != 0x7F && (c < 0x80 || c >= 0xA0) && c >> 11 != 0x1B;
  text.remove_prefix(whole ? size : 1);
  return whole ? c : replacement;
}

// The fonts of the machine, each opened when a letter of it is drawn first.
class fonts {
public:
  fonts() : config_(FcInitLoadConfigAndFonts()) {
    FcPattern *const asked = FcPatternCreate();
    FcPatternAddString(asked, FC_FAMILY, reinterpret_cast<const FcChar8 *>("sans-serif"));
    FcPatternAddString(asked, FC_LANG, reinterpret_cast<const FcChar8 *>("en"));
    FcConfigSubstitute(config_, asked, FcMatchPattern);
    FcDefaultSubstitute(asked);
    FcResult result = FcResultNoMatch;
    FcFontSet *const found = FcFontSort(config_, asked, FcTrue, nullptr, &result);
    FcPatternDestroy(asked);
    if (FT_Init_FreeType(&library_) != 0)
      library_ = nullptr;
    for (int i = 0; found && library_ && i < found->nfont; ++i)
      add(found->fonts[i]);
    if (found)
      FcFontSetDestroy(found);
    while (!all_.empty() && !open(0)) {
      FcCharSetDestroy(all_.front().letters);
      all_.erase(all_.begin());
    }
  }
  fonts(const fonts &) = delete;
  fonts &operator=(const fonts &) = delete;
  ~fonts() {
    for (const font &f : all_) {
      if (f.face)
        FT_Done_Face(f.face);
      FcCharSetDestroy(f.letters);
    }
    if (library_)
      FT_Done_FreeType(library_);
    FcConfigDestroy(config_);
    FcFini();
  }

  bool empty() const { return all_.empty(); }
  FT_Face first() { return open(0); }

  // The first font that has the letter, or the first one of all.
  FT_Face with(char32_t letter) {
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (FcCharSetHasChar(all_[i].letters, static_cast<FcChar32>(letter)))
        if (const FT_Face face = open(i); face && FT_Get_Char_Index(face, letter) != 0)
          return face;
    return letter == replacement ? open(0) : with(replacement);
  }

private:
  struct font {
    std::string file;
    int index;
    FcCharSet *letters;
    FT_Face face = nullptr;
    bool bad = false;
  };

  void add(const FcPattern *of) {
    FcChar8 *file = nullptr;
    FcCharSet *letters = nullptr;
    FcBool scalable = FcFalse, coloured = FcFalse;
    int index = 0;
    FcPatternGetBool(of, FC_SCALABLE, 0, &scalable);
    FcPatternGetBool(of, FC_COLOR, 0, &coloured);
    FcPatternGetInteger(of, FC_INDEX, 0, &index);
    if (scalable && !coloured && FcPatternGetString(of, FC_FILE, 0, &file) == FcResultMatch &&
        FcPatternGetCharSet(of, FC_CHARSET, 0, &letters) == FcResultMatch)
      all_.push_back({reinterpret_cast<const char *>(file), index, FcCharSetCopy(letters)});
  }

  FT_Face open(std::size_t i) {
    font &f = all_[i];
    if (!f.face && !f.bad)
      f.bad = FT_New_Face(library_, f.file.c_str(), f.index, &f.face) != 0;
    return f.bad ? nullptr : f.face;
  }

  FcConfig *config_;
  FT_Library library_ = nullptr;
  std::vector<font> all_;
};

// How much of each pixel the words cover, from 0 to 255. The pen's way is their width.
struct stencil {
  int width = 0, height = 0, margin = 0;
  std::vector<std::uint8_t> cover;

  std::uint8_t at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height)
      return 0;
    return cover[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  void add(const FT_Bitmap &letter, int left, int top) {
    for (int y = std::max(0, -top); y < static_cast<int>(letter.rows) && top + y < height; ++y)
      for (int x = std::max(0, -left); x < static_cast<int>(letter.width) && left + x < width; ++x) {
        std::uint8_t &to = cover[static_cast<std::size_t>(top + y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(left + x)];
        to = std::max(to, letter.buffer[y * letter.pitch + x]);
      }
  }
};

// One at a time, since a font has one size at a time.
std::mutex one_at_a_time;

fonts &all_fonts() {
  static fonts all;
  return all;
}

// Calls f(face, pen) with each letter in its face, and returns the pen's way; pens are in 64ths of a pixel.
template <class F> long write(std::string_view words, int size, F f) {
  fonts &all = all_fonts();
  long pen = 0;
  while (!all.empty() && !words.empty()) {
    const char32_t letter = take(words);
    const FT_Face face = all.with(letter);
    FT_UInt index = FT_Get_Char_Index(face, letter);
    if (index == 0)
      index = FT_Get_Char_Index(face, replacement);
    if (FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size)) != 0 ||
        FT_Load_Glyph(face, index, FT_LOAD_TARGET_LIGHT) != 0)
      continue;
    f(face, pen);
    pen += face->glyph->advance.x;
  }
  return pen;
}

int pixels(long pen) {
  return static_cast<int>((pen + 63) / 64);
}

stencil stencil_of(std::string_view words, int size, int margin) {
  const std::scoped_lock lock(one_at_a_time);
  stencil out;
  out.margin = margin + size / 2; // letters may reach over their pens
  const long way = write(words, size, [](FT_Face, long) {});
  if (way == 0)
    return out;
  const FT_Face first = all_fonts().first();
  FT_Set_Pixel_Sizes(first, 0, static_cast<FT_UInt>(size));
  const int base = out.margin + pixels(first->size->metrics.ascender);
  out.width = pixels(way) + 2 * out.margin;
  out.height = pixels(first->size->metrics.height) + 2 * out.margin;
  out.cover.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  write(words, size, [&](FT_Face face, long pen) {
    if (FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) == 0 &&
        face->glyph->bitmap.pixel_mode == FT_PIXEL_MODE_GRAY)
      out.add(face->glyph->bitmap, out.margin + static_cast<int>((pen + 32) / 64) + face->glyph->bitmap_left,
              base - face->glyph->bitmap_top);
  });
  return out;
}

void blend(image &into, int x, int y, colour c, unsigned cover) {
  if (cover == 0 || x < 0 || y < 0 || x >= into.width || y >= into.height)
    return;
  std::uint8_t *const to =
      &into.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(into.width) + static_cast<std::size_t>(x))];
  const std::uint8_t ink[] = {c.r, c.g, c.b};
  for (int k = 0; k < 3; ++k)
    to[k] = static_cast<std::uint8_t>((ink[k] * cover + to[k] * (255 - cover) + 127) / 255);
}

} // namespace

bool has_font() {
  const std::scoped_lock lock(one_at_a_time);
  return !all_fonts().empty();
}

int width_of(std::string_view words, int size) {
  const std::scoped_lock lock(one_at_a_time);
  return pixels(write(words, size, [](FT_Face, long) {}));
}

std::string shortened(std::string_view words, int size, int width) {
  if (width_of(words, size) <= width)
    return std::string(words);
  std::vector<std::string_view> letters;
  for (std::string_view rest = words; !rest.empty();) {
    const std::string_view before = rest;
    take(rest);
    letters.push_back(before.substr(0, before.size() - rest.size()));
  }
  const auto with = [&letters](std::size_t kept) {
    std::string out;
    for (std::size_t i = 0; i < (kept + 1) / 2; ++i)
      out += letters[i];
    out += "\u2026";
    for (std::size_t i = letters.size() - kept / 2; i < letters.size(); ++i)
      out += letters[i];
    return out;
  };
  std::size_t fits = 0, too_many = letters.size();
  while (fits + 1 < too_many) {
    const std::size_t kept = (fits + too_many) / 2;
    (width_of(with(kept), size) <= width ? fits : too_many) = kept;
  }
  return with(fits);
}

void draw_words(image &into, int x, int y, std::string_view words, int size, colour ink, colour rim) {
  const int reach = std::max(1, size / 6);
  const stencil s = stencil_of(words, size, reach);
  for (int v = 0; v < s.height; ++v)
    for (int u = 0; u < s.width; ++u) {
      unsigned around = 0;
      for (int dv = -reach; dv <= reach; ++dv)
        for (int du = -reach; du <= reach; ++du)
          if (du * du + dv * dv <= reach * reach)
            around = std::max<unsigned>(around, s.at(u + du, v + dv));
      blend(into, x + u - s.margin, y + v - s.margin, rim, around);
      blend(into, x + u - s.margin, y + v - s.margin, ink, s.at(u, v));
    }
}

} // namespace meetc::picture
