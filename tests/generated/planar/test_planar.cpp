// The scene in the plane answers as the shipped one in space does with z = 0: single pairs on each rung that is never
// wrong, and whole sets through the runtime, which then has kinds without a third coordinate.
#include "tests/catch.hpp"

#include "meet/core/cascade/cascade.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/core/query/find.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <planar/planar_runtime.hpp>
#include <random>
#include <string>
#include <vector>

using meetc::answer;
using meetc::kind_info;
using meetc::predicate_info;

namespace {

struct counterpart {
  const char *planar, *spatial;
};
const counterpart counterparts[] = {
    {"segment_segment", "segment_segment"}, {"disk_disk", "ball_ball"}, {"disk_segment", "ball_segment"}};

// Coordinates of few bits, so that many pairs touch in one point or lie on one line.
std::vector<float> rows_of(const kind_info &kind, std::size_t n, unsigned seed, float unit) {
  std::mt19937 numbers(seed);
  std::vector<float> rows;
  for (std::size_t i = 0; i < n; ++i)
    for (int f = 0; f < kind.fields; ++f) {
      const int whole = static_cast<int>(numbers() % 13) - 6;
      rows.push_back(static_cast<float>(f == kind.pad ? std::abs(whole) / 2 : whole) * unit);
    }
  return rows;
}

// The same rows with z = 0.
std::vector<float> in_space(const kind_info &kind, const std::vector<float> &rows) {
  std::vector<float> out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int field = static_cast<int>(i) % kind.fields;
    out.push_back(rows[i]);
    if (kind.roles[field] == meetc::role::y)
      out.push_back(0);
  }
  return out;
}

std::vector<answer> all(const predicate_info &p, meetc::rung by, const std::vector<float> &a,
                        const std::vector<float> &b, std::size_t n) {
  std::vector<meetc::index_pair> pairs;
  for (std::uint32_t i = 0; i < n; ++i)
    pairs.push_back({i, i});
  std::vector<answer> out(n);
  meetc::cascade(p, by).decide(a.data(), b.data(), pairs.data(), n, out.data());
  return out;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> collided(const predicate_info &p, const std::vector<float> &a,
                                                              const std::vector<float> &b) {
  const auto prepared = [](const kind_info &kind, const std::vector<float> &rows) {
    meetc::view v;
    v.data = rows.data();
    v.stride_bytes = static_cast<std::size_t>(kind.fields) * sizeof(float);
    v.elements = rows.size() / static_cast<std::size_t>(kind.fields);
    return meetc::prepare(v, kind);
  };
  meetc::collide_options options;
  options.threads = 1;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  for (const meetc::index_pair &x :
       meetc::collide(prepared(*p.a, a), prepared(*p.b, b), p, meetc::rung::certified, options).pairs)
    out.emplace_back(x.a, x.b);
  return out;
}

} // namespace

TEST_CASE("pairs in the plane are answered as those in space with z = 0") {
  for (const counterpart &c : counterparts) {
    const predicate_info &flat = meetc::find_predicate(planar::catalogue(), c.planar),
                         &space = meetc::find_predicate(cga::catalogue(), c.spatial);
    CHECK(flat.a->fields < space.a->fields);
    for (const float unit : {1.0F, 0x1p-60F, 0x1.234p-140F, 0x1p100F}) {
      constexpr std::size_t n = 20'000;
      const std::vector<float> a = rows_of(*flat.a, n, 1, unit), b = rows_of(*flat.b, n, 2, unit);
      const std::vector<float> a_there = in_space(*flat.a, a), b_there = in_space(*flat.b, b);
      const std::vector<answer> truth = all(space, meetc::rung::exact, a_there, b_there, n);
      INFO(c.planar << ", unit " << unit);
      CHECK(std::count(truth.begin(), truth.end(), answer::yes) > 1000);
      CHECK(std::count(truth.begin(), truth.end(), answer::no) > 1000);
      for (const meetc::rung r : {meetc::rung::exact, meetc::rung::certified})
        CHECK(all(flat, r, a, b, n) == truth);
    }
  }
}

TEST_CASE("sets in the plane collide as those in space with z = 0") {
  for (const counterpart &c : counterparts) {
    const predicate_info &flat = meetc::find_predicate(planar::catalogue(), c.planar),
                         &space = meetc::find_predicate(cga::catalogue(), c.spatial);
    const std::vector<float> a = rows_of(*flat.a, 700, 3, 0.125F), b = rows_of(*flat.b, 900, 4, 0.125F);
    const auto truth = collided(space, in_space(*flat.a, a), in_space(*flat.b, b));
    INFO(c.planar);
    CHECK(truth.size() > 1000);
    CHECK(collided(flat, a, b) == truth);
  }
}
