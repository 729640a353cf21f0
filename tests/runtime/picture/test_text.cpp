// Words on pictures: any script, any bytes, and a machine without a font.
#include "meet/picture/render.hpp"
#include "meet/picture/text.hpp"

#include "tests/catch.hpp"

#include <string>

using namespace meetc::picture;

namespace {

constexpr colour black{0, 0, 0}, white{255, 255, 255};

image empty(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 128)};
}

image drawn(std::string_view words, int x = 20, int y = 10, int size = 20) {
  image i = empty(400, 60);
  draw_words(i, x, y, words, size, black, white);
  return i;
}

// The columns with ink: those of a rim alone are lighter than the ground.
int columns(const image &i) {
  int n = 0;
  for (int x = 0; x < i.width; ++x) {
    bool ink = false;
    for (int y = 0; y < i.height; ++y)
      ink = ink || i.at(x, y).r < 100;
    n += ink;
  }
  return n;
}

} // namespace

TEST_CASE("words are letters with smooth edges on a light rim, and the same each time") {
  REQUIRE(has_font());
  const image i = drawn("Wide words");
  CHECK(i.rgb == drawn("Wide words").rgb);
  bool grey = false, light = false;
  for (const std::uint8_t v : i.rgb)
    grey = grey || (v > 20 && v < 110), light = light || v == 255;
  CHECK(grey);
  CHECK(light);
  CHECK(columns(i) > 60);
  CHECK(columns(i) <= width_of("Wide words", 20) + 2);
  CHECK(width_of("Wide words", 40) > 1.9 * width_of("Wide words", 20));
  CHECK(width_of("iiii", 20) < width_of("WWWW", 20));
}

TEST_CASE("letters beyond ASCII are letters, and what is none is a replacement") {
  const auto rgb = [](std::string_view words) { return drawn(words).rgb; };
  for (const char *const letter : {"\u00e4", "\u00e9", "\u03a9", "\u0416", "\u2026"}) {
    INFO(letter);
    CHECK(rgb(letter) != rgb("\uFFFD"));
    CHECK(rgb(letter) != rgb("?"));
  }
  CHECK(rgb("\u00e4") != rgb("a"));
  // Bytes that are no UTF-8: a lone continuation, a cut sequence, a long form, a surrogate, a number too large; and controls.
  CHECK(rgb("\xff") == rgb("\uFFFD"));
  CHECK(rgb("\x80") == rgb("\uFFFD"));
  CHECK(rgb("\xc3") == rgb("\uFFFD"));
  CHECK(rgb("\xc0\xaf") == rgb("\uFFFD\uFFFD"));
  CHECK(rgb("\xed\xa0\x80") == rgb("\uFFFD\uFFFD\uFFFD"));
  CHECK(rgb("\xf4\x90\x80\x80") == rgb("\uFFFD\uFFFD\uFFFD\uFFFD"));
  CHECK(rgb("\n") == rgb("\uFFFD"));
  CHECK(rgb(std::string_view("\0", 1)) == rgb("\uFFFD"));
}

TEST_CASE("words outside of a picture leave it as it is") {
  const image before = empty(400, 60);
  for (const auto &[x, y] : {std::pair(-9000, 10), std::pair(20, -300), std::pair(5000, 10), std::pair(20, 300)})
    CHECK(drawn("somewhere else", x, y).rgb == before.rgb);
  CHECK(drawn("").rgb == before.rgb);
  CHECK(drawn("cut on the left", -60).rgb != before.rgb);
}

TEST_CASE("long names lose their middle") {
  const std::string name = "a-very-long-name-of-a-file-\u03a9\u03a9\u03a9\u03a9-of-the-left-hand.ply";
  const std::string all = shortened(name, 20, 2000), half = shortened(name, 20, width_of(name, 20) / 2);
  CHECK(all == name);
  CHECK(width_of(half, 20) <= width_of(name, 20) / 2);
  CHECK(width_of(half, 20) > width_of(name, 20) / 3);
  CHECK(half.starts_with("a-very"));
  CHECK(half.ends_with("hand.ply"));
  CHECK(half.find("\u2026") != std::string::npos);
  CHECK(shortened(name, 20, 0) == "\u2026");
}
