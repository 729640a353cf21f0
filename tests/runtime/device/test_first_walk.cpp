// How segments go down a hierarchy alone, each to what it meets first, against every pair looked at exactly: the device's own
// code, with a stand-in for the warp.
#include "tests/runtime/device/host/host_warp.hpp"

#include "tests/catch.hpp"
#include <meetc/cuda/first_walk.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

using namespace meetc;
using namespace meetc::cuda;

namespace {

// Each axis has its own unit, a power of two: no exact parameter depends on it, but all that is rounded, overflows or vanishes
// does.
struct units {
  int power[3];
  float of(int number, int axis) const { return std::ldexp(static_cast<float>(number), power[axis]); }
  int number(float x, int axis) const { return static_cast<int>(std::ldexp(static_cast<double>(x), -power[axis])); }
} unit;

// top / below, below > 0.
struct parameter {
  std::int64_t top, below;
  friend bool operator<(parameter x, parameter y) { return x.top * y.below < y.top * x.below; }
};

// Elements are boxes of whole numbers, each in a larger one: low ends, high ends, and how much larger.
struct boxes_met {
  static constexpr int inputs_a = 6, inputs_b = 9;
};
// Where a segment meets it first; below 0 where it does not.
parameter met_at(const float *segment, const float *element) {
  parameter in{0, 1}, out{1, 1};
  for (int k = 0; k < 3; ++k) {
    const std::int64_t from = unit.number(segment[k], k), way = unit.number(segment[3 + k], k) - from;
    std::int64_t low = unit.number(element[k], k) - from, high = unit.number(element[3 + k], k) - from;
    if (way == 0 && (low > 0 || high < 0))
      return {-1, 1};
    if (way == 0)
      continue;
    if (way < 0)
      std::swap(low, high), low = -low, high = -high;
    in = std::max(in, parameter{low, std::abs(way)});
    out = std::min(out, parameter{high, std::abs(way)});
  }
  return out < in ? parameter{-1, 1} : in;
}
bool is_met(parameter at) {
  return at.top >= 0;
}
// Some that are met are unsure, and some that are not.
struct decide_boxes {
  static bool unsure(const float *segment, const float *element) {
    return (unit.number(segment[0], 0) + 3 * unit.number(element[1], 1) + unit.number(element[8], 2)) % 5 == 0;
  }
  static inline const float *begin, *end; // of the elements
  static inline bool is_outside = false;
  static answer of(const float *segment, const float *element) {
    if (element < begin || element >= end) {
      is_outside = true;
      return answer::no;
    }
    return unsure(segment, element) ? answer::unsure : to_answer(is_met(met_at(segment, element)));
  }
};

struct scene {
  std::vector<float> a, b;
  std::vector<tree_node> elements;
  std::vector<four_boxes> nodes;

  std::uint32_t count_a() const { return static_cast<std::uint32_t>(a.size() / 6); }
  std::uint32_t count_b() const { return static_cast<std::uint32_t>(b.size() / 9); }
  fours_view view() {
    const fours_shape shape(count_b());
    elements.assign(count_b() / tree_width + 1, {});
    for (std::uint32_t i = 0; i < elements.size() * tree_width; ++i) {
      tree_box box;
      for (int k = 0; k < 3 && i < count_b(); ++k)
        box.low[k] = std::max(b[9 * i + k] - b[9 * i + 6 + k], -FLT_MAX),
        box.high[k] = std::min(b[9 * i + 3 + k] + b[9 * i + 6 + k], FLT_MAX);
      put_box(elements[i / tree_width], i % tree_width, box);
    }
    four_boxes nowhere; // what a place without a node can hold
    std::memset(&nowhere, 0, sizeof nowhere);
    nodes.assign(shape.nodes(), nowhere);
    for (int level = shape.depth - 1; level >= 0; --level)
      for (std::uint32_t q = 0; q < shape.count(level); ++q)
        nodes[fours_shape::first(level) + q] = made_node(shape, level, q, elements.data(), nodes.data());
    return {nodes.data(), shape};
  }
};

// Numbers from -reach to reach; a segment is parallel to some axes now and then, and an element often flat along some, or a
// point.
scene some(std::mt19937_64 &random, std::uint32_t segments, std::uint32_t elements, int reach, int size, int pad) {
  scene s;
  const auto number = [&](int most) {
    return static_cast<int>(random() % (2 * static_cast<unsigned>(most) + 1)) - most;
  };
  for (std::uint32_t i = 0; i < segments; ++i) {
    int from[3], to[3];
    for (int k = 0; k < 3; ++k)
      from[k] = number(reach), to[k] = random() % 6 == 0 ? from[k] : number(reach);
    for (int k = 0; k < 3; ++k)
      s.a.push_back(unit.of(from[k], k));
    for (int k = 0; k < 3; ++k)
      s.a.push_back(unit.of(random() % 64 == 0 ? from[k] : to[k], k));
  }
  int at[3] = {0, 0, 0};
  for (std::uint32_t i = 0; i < elements; ++i) {
    int low[3], high[3];
    for (int k = 0; k < 3; ++k) {
      at[k] = random() % 4 == 0 ? number(reach) : std::clamp(at[k] + number(size), -reach, reach); // neighbours, mostly
      low[k] = at[k], high[k] = at[k] + static_cast<int>(random() % 3 == 0 ? 0 : random() % (size + 1U));
    }
    for (int k = 0; k < 3; ++k)
      s.b.push_back(unit.of(low[k], k));
    for (int k = 0; k < 3; ++k)
      s.b.push_back(unit.of(high[k], k));
    for (int k = 0; k < 3; ++k)
      s.b.push_back(unit.of(static_cast<int>(random() % (pad + 1U)), k));
  }
  return s;
}

struct found {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> hits, unsure;
  unsigned long long hit_count = 0, unsure_count = 0, decided = 0;
};
found walked(scene &s, const part &of, std::uint32_t warps, std::size_t capacity) {
  constexpr index_pair untouched{0xffffffff, 0xffffffff};
  std::vector<index_pair> hits(capacity + 64, untouched), unsure(capacity + 64, untouched);
  found f;
  unsigned long long taken = 0;
  first_walk_job job{};
  job.a = s.a.data(), job.b = s.b.data(), job.tree = s.view(), job.of = of;
  job.hits = {hits.data(), &f.hit_count, capacity}, job.unsure = {unsure.data(), &f.unsure_count, capacity};
  job.taken = &taken, job.decided = &f.decided, job.elements_a = s.count_a();
  decide_boxes::begin = s.b.data(), decide_boxes::end = s.b.data() + s.b.size();
  static index_pair room[first_walk_hits];
  for (std::uint32_t warp = 0; warp < warps; ++warp)
    host_warp::the_blocks.run([&] {
      first_walk<boxes_met, decide_boxes> mine(job, room);
      mine.run(warp, warps);
      mine.hits().flush();
    });
  REQUIRE(!decide_boxes::is_outside);
  const auto take = [&](std::vector<index_pair> &from, unsigned long long n, auto &to) {
    const auto is_untouched = [&](index_pair p) { return p.a == untouched.a && p.b == untouched.b; };
    CHECK(std::all_of(from.end() - 64, from.end(), is_untouched));
    for (std::size_t i = 0; i < std::min<std::size_t>(n, capacity); ++i)
      to.emplace_back(from[i].a, from[i].b);
    std::sort(to.begin(), to.end());
  };
  take(hits, f.hit_count, f.hits), take(unsure, f.unsure_count, f.unsure);
  return f;
}

struct tally {
  std::size_t met = 0, first = 0, ties = 0, decided = 0, near = 0;
};
// No pair twice, no wrong hit, and of each segment all that it meets first.
void check_scene(scene &s, const part &of, const found &f, tally &t) {
  REQUIRE(f.hit_count == f.hits.size());
  REQUIRE(f.unsure_count == f.unsure.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all = f.hits;
  all.insert(all.end(), f.unsure.begin(), f.unsure.end());
  std::sort(all.begin(), all.end());
  REQUIRE(std::adjacent_find(all.begin(), all.end()) == all.end());
  REQUIRE(f.decided >= all.size());
  const auto inside = [&](const auto &p) {
    return p.first >= of.first_a && p.first < of.end_a && p.second >= of.first_b && p.second < of.end_b;
  };
  REQUIRE(std::all_of(all.begin(), all.end(), inside));
  for (const auto &[i, j] : f.hits)
    REQUIRE(is_met(met_at(&s.a[6 * i], &s.b[9 * j])));
  for (std::uint32_t i = of.first_a; i < of.end_a; ++i) {
    const two_points line = two_points_of({{0, 1, 2, 3, 4, 5}, -1}, &s.a[6 * i]);
    for (std::uint32_t j = of.first_b; j < of.end_b; ++j) {
      const tree_box box = box_of(s.elements[j / tree_width], j % tree_width);
      t.near += !apart_from_box(line, box.low, box.high);
    }
  }
  std::size_t lost = 0;
  std::vector<parameter> at(s.count_b());
  for (std::uint32_t i = of.first_a; i < of.end_a; ++i) {
    parameter first{2, 1};
    for (std::uint32_t j = of.first_b; j < of.end_b; ++j)
      if (at[j] = met_at(&s.a[6 * i], &s.b[9 * j]); is_met(at[j]))
        first = std::min(first, at[j]), ++t.met;
    std::size_t here = 0;
    for (std::uint32_t j = of.first_b; j < of.end_b; ++j)
      if (is_met(at[j]) && !(first < at[j]))
        ++here, lost += !std::binary_search(all.begin(), all.end(), std::pair{i, j});
    t.first += here > 0, t.ties += here > 1 ? here : 0;
  }
  REQUIRE(lost == 0);
  t.decided += f.decided;
}

// Powers for which all numbers are finite, and exact; of `kind` 2 all ways are below 2^-126, and of kind 3 some beyond 2^126.
void choose_units(std::mt19937_64 &random, int kind) {
  for (int &p : unit.power)
    p = kind == 0   ? 0
        : kind == 1 ? static_cast<int>(random() % 40) - 20
        : kind == 2 ? -149 + static_cast<int>(random() % 8)
        : kind == 3 ? 122 - static_cast<int>(random() % 2)
                    : static_cast<int>(random() % 268) - 149;
}

} // namespace

TEST_CASE("first walk: of each segment all that it meets first, at any scale of each axis") {
  std::mt19937_64 random(7);
  const std::uint32_t sizes[] = {1, 3, 4, 5, 17, 64, 300, 300, 1100};
  tally t;
  for (int round = 0; round < 200; ++round) {
    choose_units(random, round % 5);
    const int reach = random() % 2 ? 8 : 24, size = random() % 2 ? 1 : 6;
    scene s = some(random, sizes[random() % 8], sizes[random() % 9], reach, size, size);
    part of{0, s.count_a(), 0, s.count_b()};
    if (round % 4 == 3) { // a part
      of.first_a = static_cast<std::uint32_t>(random() % of.end_a),
      of.first_b = static_cast<std::uint32_t>(random() % of.end_b);
      of.end_a = of.first_a + 1 + static_cast<std::uint32_t>(random() % (of.end_a - of.first_a));
      of.end_b = of.first_b + 1 + static_cast<std::uint32_t>(random() % (of.end_b - of.first_b));
    }
    const auto warps = static_cast<std::uint32_t>(1 + random() % 3);
    INFO("round " << round << ": " << s.count_a() << " x " << s.count_b() << ", powers " << unit.power[0] << ' '
                  << unit.power[1] << ' ' << unit.power[2]);
    check_scene(s, of, walked(s, of, warps, std::size_t{s.count_a()} * s.count_b() + 1), t);
  }
  CHECK(t.first > 1000);
  CHECK(t.ties > 300);
}

// The parameters of one point along the three axes are rounded to 0 or to the least number.
TEST_CASE("first walk: elements that are met at one point stay where its parameter vanishes") {
  for (int x = 1; x < 12; ++x)
    for (int y = 1; y < 12; ++y)
      for (int z = 1; z < 12; ++z) {
        const int way[3] = {2 * x, 2 * y, 2 * z};
        float row[6];
        tree_box point;
        for (int k = 0; k < 3; ++k) {
          row[k] = 0, row[3 + k] = static_cast<float>(way[k]);
          point.low[k] = point.high[k] = static_cast<float>(way[k] / 2) * 0x1p-149F; // the parameter is 2^-150
        }
        four_boxes node;
        for (unsigned c = 0; c < 4; ++c)
          put_box(node, c, c < 2 ? point : tree_box());
        first_line line(row);
        std::uint32_t keys[4];
        line.meets(node, 0);
        line.enter(node, keys);
        REQUIRE((keys[0] != left_out && keys[1] != left_out));
        REQUIRE((keys[2] == left_out && keys[3] == left_out));
      }
}

TEST_CASE("first walk: elements that are met later are not looked at") {
  std::mt19937_64 random(3);
  tally t;
  for (int round = 0; round < 4; ++round) {
    choose_units(random, round % 2);
    scene s = some(random, 200, 6000, 24, 6, 0);
    const part of{0, s.count_a(), 0, s.count_b()};
    check_scene(s, of, walked(s, of, 2, 100'000), t);
  }
  CHECK(t.near > 4000);
  CHECK(2 * t.decided < t.near);
}

TEST_CASE("first walk: a list that is too short is never overrun, and its count says so") {
  std::mt19937_64 random(2);
  choose_units(random, 0);
  for (const std::size_t capacity : {0U, 1U, 20U}) {
    scene s = some(random, 300, 300, 10, 3, 1);
    const found f = walked(s, {0, s.count_a(), 0, s.count_b()}, 2, capacity);
    CHECK((f.hit_count > capacity || f.unsure_count > capacity));
  }
}

TEST_CASE("first walk: numbers of nodes and elements are those of a full tree") {
  for (const std::uint32_t n : {1U, 4U, 5U, 16U, 17U, 1024U, 1025U, most_in_fours - 3, most_in_fours}) {
    const fours_shape s(n);
    REQUIRE(s.depth >= 1);
    REQUIRE(s.depth <= fours_levels);
    REQUIRE(std::uint64_t{1} << 2 * s.depth >= n);
    REQUIRE((s.depth == 1 || std::uint64_t{1} << 2 * (s.depth - 1) < n));
    REQUIRE(s.count(0) == 1);
    REQUIRE(std::uint64_t{s.count(s.depth - 1)} * 4 >= n);
    REQUIRE(std::uint64_t{s.first_element()} + n - 1 < no_slot);
    for (int level = 0; level < s.depth; ++level)
      REQUIRE(fours_shape::first(level + 1) == 4 * std::uint64_t{fours_shape::first(level)} + 1);
  }
}
