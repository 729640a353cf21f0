// Pictures: the file decodes, hits are visible wherever they lie, and no input does harm.
#include "meet/bodies/meshes.hpp"
#include "meet/picture/render.hpp"

#include "decode.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace meetc::bodies;
using namespace meetc::picture;

namespace {

// Pixels with about the hue of a saturated colour, whatever the light.
std::size_t count(const image &i, colour c) {
  std::size_t n = 0;
  for (std::size_t p = 0; p + 2 < i.rgb.size(); p += 3) {
    const double s = i.rgb[p] / std::max(1.0, double(c.r));
    const auto close = [s](double v, double w) { return std::abs(v - s * w) < 40; };
    n += s > 0.55 && close(i.rgb[p + 1], c.g) && close(i.rgb[p + 2], c.b);
  }
  return n;
}

std::size_t not_background(const image &i) {
  std::size_t n = 0;
  for (std::size_t p = 0; p + 2 < i.rgb.size(); p += 3)
    n += i.rgb[p] < 215;
  return n;
}

struct scene {
  mesh a = icosphere(4), b = torus(96, 48);
  std::vector<std::uint8_t> hit_a = std::vector<std::uint8_t>(a.triangles()),
                            hit_b = std::vector<std::uint8_t>(b.triangles());
  std::vector<shape> shapes() const {
    return {{form::triangles, a.xyz, a.index, hit_a, palette::calm[0], palette::yellow, "A"},
            {form::triangles, b.xyz, b.index, hit_b, palette::calm[1], palette::vermilion, "B"}};
  }
};

camera plain() {
  camera v;
  v.supersample = 2;
  return v;
}

} // namespace

TEST_CASE("a picture decodes to what was encoded") {
  const scene s;
  const image i = render(s.shapes(), plain(), 203, 151);
  const image j = decode(encode_png(i));
  CHECK(j.width == 203);
  CHECK(j.height == 151);
  CHECK(j.rgb == i.rgb);
  CHECK(render(s.shapes(), plain(), 203, 151).rgb == i.rgb);
  CHECK(not_background(i) > 2000);
  CHECK_THROWS_AS(encode_png(image{}), std::runtime_error);
  CHECK_THROWS_AS(encode_png(image{4, 4, std::vector<std::uint8_t>(7)}), std::runtime_error);
}

TEST_CASE("hits are seen, and only where there are some") {
  scene s;
  CHECK(count(render(s.shapes(), plain(), 320, 240), palette::yellow) == 0);
  CHECK(count(render(s.shapes(), plain(), 320, 240), palette::vermilion) == 0);
  for (std::size_t t = 0; t < s.hit_a.size(); t += 40)
    s.hit_a[t] = 1;
  s.hit_b.assign(s.hit_b.size(), 1);
  const image i = render(s.shapes(), plain(), 320, 240);
  CHECK(count(i, palette::yellow) > 100);
  CHECK(count(i, palette::vermilion) > 2000);
  const image p = render_panels(s.shapes(), plain(), 640, 480);
  CHECK(p.width == 640);
  CHECK(p.height == 480);
  CHECK(count(p, palette::yellow) > 200);
}

TEST_CASE("one hit triangle far smaller than a pixel is seen") {
  mesh m = icosphere(7);
  std::vector<std::uint8_t> hit(m.triangles());
  std::size_t front = 0; // the triangle nearest to the viewer of the default view
  double best = -9;
  for (std::size_t t = 0; t < m.triangles(); ++t) {
    const std::size_t v = 3 * std::size_t{m.index[3 * t]};
    const double d = 0.45 * m.xyz[v] + 0.28 * m.xyz[v + 1] + 0.85 * m.xyz[v + 2];
    if (d > best) {
      best = d;
      front = t;
    }
  }
  hit[front] = 1;
  const shape s{form::triangles, m.xyz, m.index, hit, palette::calm[0], palette::vermilion, ""};
  const image far = render({&s, 1}, plain(), 200, 200);
  CHECK(count(far, palette::vermilion) >= 4);
  camera close = plain();
  close.fit = framing::hits;
  CHECK(count(render({&s, 1}, close, 200, 200), palette::vermilion) > 2000);
}

TEST_CASE("a hidden hit shines through, the view that faces it shows it") {
  scene s;
  for (std::size_t t = 0; t < s.a.triangles(); ++t)
    if (s.a.xyz[3 * std::size_t{s.a.index[3 * t]} + 2] < -0.9f)
      s.hit_a[t] = 1;
  const std::vector<shape> a{s.shapes()[0]};
  camera front = plain();
  front.azimuth = front.elevation = 0;
  camera opaque = front;
  opaque.see_through = 0;
  const image none = render(a, opaque, 200, 200), some = render(a, front, 200, 200);
  CHECK(count(none, palette::yellow) == 0);
  CHECK(some.rgb != none.rgb);
  const camera turned = facing_hits(a, front);
  CHECK(count(render(a, turned, 200, 200), palette::yellow) > 500);
}

TEST_CASE("spheres and segments") {
  const std::vector<float> balls{0, 0, 0, 1, 2, 0, 0, 0.5f, 4, 0, 0, 0}, lines{-1, 2, 0, 5, 2, 0, 1, 1, 1, 1, 1, 1};
  const std::vector<std::uint8_t> first{1};
  const std::vector<shape> s{{form::spheres, balls, {}, first, palette::calm[1], palette::yellow, ""},
                             {form::segments, lines, {}, first, palette::calm[2], palette::vermilion, ""}};
  CHECK(elements(s[0]) == 3);
  CHECK(elements(s[1]) == 2);
  CHECK(hits(s[0]) == 1);
  for (const bool perspective : {false, true}) {
    camera v = plain();
    v.perspective = perspective;
    const image i = render(s, v, 400, 300);
    CHECK(count(i, palette::yellow) > 1000);
    CHECK(count(i, palette::vermilion) > 200);
  }
}

TEST_CASE("no scale does harm: the picture of 1e30 and of 1e-30 is that of 1") {
  scene s;
  for (std::size_t t = 0; t < s.hit_a.size(); t += 40)
    s.hit_a[t] = 1;
  const std::size_t seen = count(render(s.shapes(), plain(), 200, 150), palette::yellow);
  for (const float scale : {0x1p100f, 0x1p-100f, 0x1p126f}) {
    scene t = s;
    for (mesh *m : {&t.a, &t.b})
      for (float &v : m->xyz)
        v *= scale;
    CHECK(count(render(t.shapes(), plain(), 200, 150), palette::yellow) == seen);
    camera close = plain();
    close.fit = framing::hits;
    CHECK(not_background(render(t.shapes(), close, 100, 100)) > 1000);
    CHECK(not_background(render_panels(t.shapes(), plain(), 400, 300)) > 1000);
  }
}

TEST_CASE("empty and broken input does no harm") {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(render({}, plain(), 64, 64).rgb.size() == 64 * 64 * 3);
  CHECK(render_panels({}, plain(), 640, 480).rgb.size() == 640 * 480 * 3);
  CHECK(render({}, plain(), -5, 0).width == 16);
  const std::vector<float> soup{0,     0,     0,      0,      0,      0, 0, 0,      0, // a point
                                1,     1,     1,      2,      2,      2, 3, 3,      3, // a needle
                                0,     0,     0,      nan,    0,      0, 0, 1,      0, // left out
                                0,     0,     0,      inf,    0,      0, 0, 1,      0, // left out
                                3e38f, 3e38f, -3e38f, -3e38f, 1e-45f, 0, 1, -3e38f, 2};
  const std::vector<std::uint8_t> all(9, 1);
  const std::vector<std::uint32_t> wild{0, 1, 2, 7, 8, 4000000000u, 0, 0, 0, 3, 4, 5};
  for (const std::size_t floats :
       {std::size_t{0}, std::size_t{8}, std::size_t{9}, std::size_t{18}, std::size_t{36}, soup.size()})
    for (const form what : {form::triangles, form::spheres, form::segments})
      for (const framing fit : {framing::scene, framing::hits})
        for (const bool indexed : {false, true}) {
          shape s{what, std::span(soup).first(floats), {}, all, palette::calm[0], palette::vermilion, "x"};
          if (indexed)
            s.index = wild;
          camera v = plain();
          v.fit = fit;
          v.perspective = indexed;
          CHECK(render({&s, 1}, v, 48, 32).rgb.size() == 48 * 32 * 3);
          const std::vector<shape> two{s, s};
          CHECK(render_panels(two, v, 330, 250).rgb.size() == 330 * 250 * 3);
        }
}

TEST_CASE("a needle and a point that are hits are seen") {
  const std::vector<float> soup{-1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0, 0, 0.5f, 0, 0, 0.5f, 0};
  const std::vector<std::uint8_t> needle{1, 0}, point{0, 1};
  const shape a{form::triangles, soup, {}, needle, palette::calm[0], palette::vermilion, ""};
  const shape b{form::triangles, soup, {}, point, palette::calm[0], palette::vermilion, ""};
  CHECK(count(render({&a, 1}, plain(), 200, 200), palette::vermilion) > 150);
  CHECK(count(render({&b, 1}, plain(), 200, 200), palette::vermilion) >= 4);
}

TEST_CASE("a camera in the scene sees what lies before it, and nothing behind it") {
  // Two walls of one triangle each, before and behind the eye, and a floor through it.
  const std::vector<float> walls{-9, -9, -5, 9, -9,  -5, 0,   9,  -5, -9,  -9, 5,  9, -9,
                                 5,  0,  9,  5, -50, -1, -50, 50, -1, -50, 0,  -1, 90};
  const std::vector<std::uint8_t> before{1, 0, 0}, behind{0, 1, 0}, floor{0, 0, 1};
  camera v = plain();
  v.stands = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}};
  const auto seen = [&](const std::vector<std::uint8_t> &hit) {
    const shape s{form::triangles, walls, {}, hit, palette::calm[0], palette::vermilion, ""};
    return count(render({&s, 1}, v, 200, 200), palette::vermilion);
  };
  CHECK(seen(before) > 20000);
  CHECK(seen(behind) == 0);
  const std::size_t below = seen(floor);
  CHECK(below > 2000);
  CHECK(below < 20000);
  v.stands->target = {0, 0, 1};
  CHECK(seen(before) == 0);
  CHECK(seen(behind) > 20000);
  const std::vector<float> lines{0, -0.5f, 20, 0, -0.5f, -20}, balls{0, 0, -4, 1, 0, 0, 4, 1};
  const std::vector<std::uint8_t> first{1};
  const shape line{form::segments, lines, {}, first, palette::calm[0], palette::vermilion, ""};
  CHECK(count(render({&line, 1}, v, 200, 200), palette::vermilion) > 100);
  const shape ball{form::spheres, balls, {}, first, palette::calm[0], palette::vermilion, ""};
  CHECK(count(render({&ball, 1}, v, 200, 200), palette::vermilion) == 0);
  v.stands->target = {0, 0, -1};
  CHECK(count(render({&ball, 1}, v, 200, 200), palette::vermilion) > 1000);
}

TEST_CASE("a distance makes the scene smaller, and words leave it room") {
  const scene s;
  camera v = plain();
  const auto rows = [&](int from, int to) { // those that show something
    const image i = render(s.shapes(), v, 200, 200);
    std::size_t n = 0;
    for (int y = from; y < to; ++y)
      for (int x = 0; x < 200; ++x)
        n += i.at(x, y).r < 200;
    return n;
  };
  const std::size_t near = rows(0, 200);
  v.distance = 2;
  const std::size_t far = rows(0, 200);
  CHECK(5 * far > near);
  CHECK(3 * far < near);
  v.distance = 1, v.margin = 0;
  CHECK(rows(0, 40) > 0);
  v.top = 0.2;
  CHECK(rows(0, 40) == 0);
}
