// The test of two points against boxes: nothing that touches is called apart, from 2^-149 to 2^127, and much that does
// not touch is.
#include "sticks.hpp"
#include "tests/catch.hpp"

#include <fstream>
#include <sstream>

using namespace meetc;
using namespace toy;

namespace {

struct scene {
  float row[7]; // two points and a radius
  box b;
};

// The answer of a test with this margin about one box; the other lanes are empty.
bool kept(const scene &s, const kind_info &kind, parameter_margin margin) {
  box_block block;
  block.clear();
  block.set(5, s.b);
  return touching(block, two_points_of(kind, s.row), margin) >> 5 & 1;
}

float power(std::mt19937 &g, int least, int most) {
  return std::ldexp(1.0f, least + static_cast<int>(g() % static_cast<unsigned>(most - least + 1)));
}

// A box whose edge along axis k runs through about one point of the segment, and which lies on one side of the segment
// in the plane of the other two axes: the cross product with axis k almost separates them.
void put_edge_on(scene &s, std::mt19937 &g, int k, float size) {
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const double t = uniform(g, -0.1f, 1.1f);
  float at[3];
  for (int c = 0; c < 3; ++c)
    at[c] = static_cast<float>(s.row[c] + t * (static_cast<double>(s.row[3 + c]) - s.row[c]));
  const bool rising = (s.row[3 + i] < s.row[i]) == (s.row[3 + j] < s.row[j]), up = g() % 2;
  for (int c = 0; c < 3; ++c) {
    const bool high = c == k || (c == i ? up : rising != up); // the side on which the box lies
    s.b.lo[c] = high && c != k ? at[c] : at[c] - size;
    s.b.hi[c] = high ? at[c] + size : at[c];
  }
  s.b = sanitised(s.b);
}

// Coordinates of one magnitude, with the point near the first end, near zero, or anywhere.
scene near_edge(std::mt19937 &g) {
  scene s;
  const float unit = power(g, -149, 126);
  for (int c = 0; c < 6; ++c)
    s.row[c] = unit * uniform(g, -1, 1) * (g() % 4 ? 1.0f : power(g, -12, 0));
  s.row[6] = g() % 2 ? 0 : unit * uniform(g, 0, 1) * power(g, -24, 0);
  put_edge_on(s, g, static_cast<int>(g() % 3), unit * power(g, -12, 1));
  return s;
}

// An edge of a box exactly on a segment from the origin, at a parameter of a few and a half steps of the smallest number:
// how a parameter is rounded there depends on the error of its reciprocal.
scene near_underflow(std::mt19937 &g) {
  scene s{};
  const float step = std::numeric_limits<float>::denorm_min();
  const auto halves = static_cast<float>(1 + g() % 9);
  for (int k = 0; k < 3; ++k) {
    const auto half_length = static_cast<float>(1 + g() % 63);
    s.row[3 + k] = 2 * half_length;
    const bool entered = g() % 2;
    s.b.lo[k] = entered ? halves * half_length * step : -1;
    s.b.hi[k] = entered ? 1 : halves * half_length * step;
  }
  return s;
}

// Every magnitude at once.
scene any(std::mt19937 &g) {
  scene s;
  const float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  const auto number = [&] {
    const float palette[] = {0, least, 3 * least, 0x1p-126f, 1, 1.5f, 0x1p126f, 0x1p127f, most, power(g, -149, 127)};
    return palette[g() % std::size(palette)] * (g() % 2 ? 1.0f : -1.0f);
  };
  for (int c = 0; c < 6; ++c)
    s.row[c] = number();
  s.row[6] = g() % 2 ? 0 : std::abs(number());
  for (int k = 0; k < 3; ++k) {
    const float x = g() % 4 ? number() : s.row[k], y = g() % 4 ? number() : s.row[3 + k];
    s.b.lo[k] = std::min(x, y), s.b.hi[k] = std::max(x, y);
  }
  return s;
}

struct findings {
  int touching = 0, apart = 0, rejected = 0, wrong = 0;
};

template <class Make>
findings judge(const Make &make, unsigned seed, int rounds, const kind_info &kind, parameter_margin margin = {}) {
  std::mt19937 g(seed);
  findings f;
  for (int i = 0; i < rounds; ++i) {
    const scene s = make(g);
    const bool truth = meets(kind, s.row, s.b), keeps = kept(s, kind, margin);
    ++(truth ? f.touching : f.apart);
    f.rejected += !keeps;
    f.wrong += truth && !keeps;
  }
  return f;
}

} // namespace

TEST_CASE("two points and a box that touch are never called apart") {
  int seed = 70;
  for (const kind_info *const kind : {&sticks, &padded_sticks}) {
    CAPTURE(kind->name);
    const findings edge = judge(near_edge, seed++, 30'000, *kind), low = judge(near_underflow, seed++, 10'000, *kind),
                   all = judge(any, seed++, 15'000, *kind);
    for (const findings &f : {edge, low, all}) {
      CHECK(f.wrong == 0);
      CHECK(f.touching > 1000);
    }
    for (const findings &f : {edge, all})
      CHECK(f.rejected > f.apart / 4);
  }
}

TEST_CASE("a smaller margin rejects what touches") {
  const parameter_margin all, quarter{1 + (all.factor - 1) / 4, all.term}, no_factor{1, all.term},
      no_term{all.factor, 0};
  CHECK(judge(near_edge, 80, 30'000, sticks, quarter).wrong > 0);
  CHECK(judge(near_edge, 80, 30'000, sticks, no_factor).wrong > 0);
  CHECK(judge(near_underflow, 81, 10'000, sticks, no_term).wrong > 0);
}

TEST_CASE("the margin is the one that is proved") {
  std::ifstream file(MEETC_TWO_POINTS_PROOF);
  std::stringstream text;
  text << file.rdbuf();
  const parameter_margin m;
  CHECK(text.str().find("\nmargin = 5b-23;\nterm = 1b-126;\n") != std::string::npos);
  CHECK(m.factor == 1 + 5 * 0x1p-23f);
  CHECK(m.term == 0x1p-126f);
}

TEST_CASE("not a number keeps a pair, and an empty lane is not told from a full one") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float row[6] = {0, 0, 0, 1, 1, 1};
  box_block block;
  for (int i = 0; i < lanes; ++i)
    block.set(i, {{5, 6, 7}, {8, 9, 10}});
  two_points t = two_points_of(sticks, row);
  CHECK(touching(block, t) == 0);
  for (int i = 0; i < lanes; ++i)
    for (int k = 0; k < 3; ++k)
      block.lo[k][i] = i % 2 ? nan : block.lo[k][i], block.hi[k][i] = i % 2 ? nan : block.hi[k][i];
  CHECK(touching(block, t) == 0xaaaa);
  std::fill_n(t.per, 3, nan);
  CHECK(touching(block, t) == 0xffff);
}

namespace {
// The number of candidates: their boxes touch, and an element with two points touches the other's box.
std::uint64_t candidates_by_points(const rows &a, const kind_info &kind_a, const rows &b, const kind_info &kind_b) {
  const auto fields_a = static_cast<std::size_t>(kind_a.fields), fields_b = static_cast<std::size_t>(kind_b.fields);
  const auto one_box = [](const box &lone) {
    box_block block;
    block.clear();
    block.set(0, lone);
    return block;
  };
  std::uint64_t n = 0;
  for (std::size_t i = 0; i < a.size(); i += fields_a)
    for (std::size_t j = 0; j < b.size(); j += fields_b) {
      const box x = box_of(kind_a, &a[i]), y = box_of(kind_b, &b[j]);
      n += (touching(one_box(x), y) & 1) != 0 &&
           (!has_two_points(kind_a) || (touching(one_box(y), two_points_of(kind_a, &a[i])) & 1) != 0) &&
           (!has_two_points(kind_b) || (touching(one_box(x), two_points_of(kind_b, &b[j])) & 1) != 0);
    }
  return n;
}
} // namespace

TEST_CASE("long sticks: either role finds the same candidates, those of brute force, and few of them") {
  std::mt19937 g(90);
  const rows b = some_boxes(1000, 1, 0.02f, 91);
  for (const bool padded : {false, true}) {
    rows a;
    for (int i = 0; i < 60; ++i) {
      for (int c = 0; c < 6; ++c)
        a.push_back(uniform(g, -1, 1));
      if (padded)
        a.push_back(uniform(g, 0, 0.01f));
    }
    const predicate_info &first = padded ? padded_stick_box : stick_box,
                         &second = padded ? box_padded_stick : box_stick;
    const prepared x = prepare(view_of(a, *first.a), *first.a), y = prepare(view_of(b, boxes), boxes);
    const toy::truth want = brute(a, b, first);
    const result plain_rung = collide(x, y, first, rung::fp32);
    CHECK(plain_rung.candidates == want.candidates);
    CHECK(same(plain_rung.pairs, want.pairs));
    const std::uint64_t candidates = candidates_by_points(a, *first.a, b, *first.b);
    CHECK(candidates < want.candidates / 20);
    CHECK(candidates < want.pairs.size() + want.pairs.size() / 100 + 10);
    for (const int threads : {1, 3}) {
      collide_options o;
      o.threads = threads;
      const result r = collide(x, y, first, rung::exact, o);
      CHECK(same(r.pairs, want.pairs));
      CHECK(r.candidates == candidates);
      const result turned = collide(y, x, second, rung::exact, o);
      CHECK(turned.candidates == candidates);
      CHECK(turned.count == r.count);
    }
  }
}

TEST_CASE("sticks of all lengths against each other") {
  std::mt19937 g(92);
  for (const float size : {0.001f, 0.1f, 2.0f}) {
    const auto make = [&](std::size_t n) {
      rows r;
      for (std::size_t i = 0; i < n; ++i) {
        float at[6];
        for (int c = 0; c < 6; ++c)
          at[c] = c < 3 ? uniform(g, -1, 1) : at[c - 3] + uniform(g, -size, size);
        r.insert(r.end(), at, at + 6);
      }
      return r;
    };
    const rows a = make(200), b = make(300);
    const toy::truth want = brute(a, b, stick_stick);
    const prepared x = prepare(view_of(a, sticks), sticks), y = prepare(view_of(b, sticks), sticks);
    const result walked = collide(x, y, stick_stick, rung::exact);
    CHECK(same(walked.pairs, want.pairs));
    CHECK(walked.candidates == candidates_by_points(a, sticks, b, sticks));
    CHECK(walked.candidates <= want.candidates);
    // Half of the pairs of a set with itself.
    predicate_info half = stick_stick;
    half.symmetric = true;
    const result itself = collide(y, y, half, rung::exact);
    const toy::truth all = brute(b, b, stick_stick);
    CHECK(same(itself.pairs, all.pairs));
    CHECK(itself.count == all.pairs.size());
  }
}

TEST_CASE("pairs() finds what collide() finds for sticks") {
  std::mt19937 g(93);
  rows a;
  for (int i = 0; i < 60 * 6; ++i)
    a.push_back(uniform(g, -1, 1));
  const rows b = some_boxes(800, 1, 0.05f, 94);
  const toy::truth want = brute(a, b, stick_box);
  std::vector<std::byte> bytes(workspace(stick_box, 60, 800, 1));
  std::vector<index_pair> found(want.pairs.size() + 1);
  std::uint64_t count = 0;
  pairs_out out{found.data(), found.size(), &count};
  CHECK(pairs(stick_box, rung::exact, view_of(a, sticks), {}, view_of(b, boxes), {}, out, {bytes.data(), bytes.size()},
              {.threads = 1}) == status::ok);
  found.resize(count);
  CHECK(same(found, want.pairs));
}
