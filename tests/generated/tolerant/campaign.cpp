#include "tests/generated/tolerant/campaign.hpp"

#include "meet/bench/truth/distance.hpp"
#include "meet/bench/truth/near_pairs.hpp"
#include "meet/bench/truth/numbers.hpp"
#include "meet/core/cascade/cascade.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/views/pose.hpp"

#include <algorithm>
#include <both/both_runtime.hpp>
#include <cga/cga_runtime.hpp>
#include <cmath>
#include <numeric>
#include <probe/probe_runtime.hpp>
#include <spheres/spheres_runtime.hpp>
#include <tolerant/tolerant_runtime.hpp>

namespace meetc::tolerant_test {

namespace {

using point = std::array<double, 3>;

point point_of(const kind_info &kind, const float *row, int p) {
  point out;
  for (int k = 0; k < 3; ++k)
    out[static_cast<std::size_t>(k)] = static_cast<double>(row[kind.hull_fields[3 * p + k]]);
  return out;
}
void set_point(const kind_info &kind, float *row, int p, const point &to) {
  for (int k = 0; k < 3; ++k)
    row[kind.hull_fields[3 * p + k]] = static_cast<float>(to[static_cast<std::size_t>(k)]);
}

// from + share (to - from) + a random vector of length about `aside`.
point between(const point &from, const point &to, double share, double aside, bench::numbers &random) {
  point out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = from[k] + share * (to[k] - from[k]) + aside * static_cast<double>(random.place());
  return out;
}

double small(bench::numbers &random) {
  return std::ldexp(1.0, -static_cast<int>(random.below(26)));
}

// The third corner nearly on the line of the first two.
void flatten(const kind_info &kind, float *row, bench::numbers &random) {
  if (kind.hull < 3)
    return;
  const point p = point_of(kind, row, 0), q = point_of(kind, row, 1);
  const double share = 2 * static_cast<double>(random.place());
  set_point(kind, row, 2, between(p, q, std::clamp(share, -1.5, 1.5), small(random), random));
}

// Moves b so that its first point lies near the line of a's first two points, perhaps beyond them.
void approach(const predicate_info &p, const float *a, float *b, bench::numbers &random) {
  const point from = point_of(*p.a, a, 0), to = point_of(*p.a, a, p.a->hull > 1 ? 1 : 0),
              target = between(from, to, 1.2 * static_cast<double>(random.place()), small(random), random),
              first = point_of(*p.b, b, 0);
  for (int i = 0; i < p.b->hull; ++i) {
    point x = point_of(*p.b, b, i);
    for (std::size_t k = 0; k < 3; ++k)
      x[k] += target[k] - first[k];
    set_point(*p.b, b, i, x);
  }
}

// The first edge of b nearly along that of a.
void align(const predicate_info &p, const float *a, float *b, bench::numbers &random) {
  if (p.a->hull < 2 || p.b->hull < 2)
    return;
  const point from = point_of(*p.a, a, 0), to = point_of(*p.a, a, 1), first = point_of(*p.b, b, 0);
  point along;
  for (std::size_t k = 0; k < 3; ++k)
    along[k] = first[k] + to[k] - from[k];
  set_point(*p.b, b, 1, between(first, along, static_cast<double>(random.place()), small(random), random));
}

bool is_in_box(const kind_info &kind, const float *row) {
  for (int f = 0; f < kind.fields; ++f)
    if (!(std::fabs(static_cast<double>(row[f])) <= (kind.roles[f] == role::length ? 2 * widest : widest)))
      return false;
  return true;
}

} // namespace

const char *name_of(family f) {
  switch (f) {
  case family::random:
    return "random";
  case family::near:
    return "near";
  case family::needle:
    return "needle";
  case family::parallel:
    return "parallel";
  case family::far:
    return "far";
  case family::large:
    break;
  }
  return "large";
}

rows make(const predicate_info &p, family f, std::size_t n, std::uint64_t seed, double reach) {
  bench::pair_difficulty d;
  d.near = f == family::near || f == family::far || f == family::large;
  d.scale = f == family::large ? 2 : 0;
  d.bits_to = 26;
  d.offset = f == family::far ? 5 : 0;
  const bench::element_pairs made = bench::make_pairs(p, n, d, seed);
  rows out{made.a, made.b, made.count};
  bench::numbers random(seed + 1);
  std::size_t kept = 0;
  const auto fields_a = static_cast<std::size_t>(p.a->fields), fields_b = static_cast<std::size_t>(p.b->fields);
  for (std::size_t i = 0; i < out.count; ++i) {
    float *const a = out.a.data() + i * fields_a, *const b = out.b.data() + i * fields_b;
    if (f == family::needle)
      flatten(*p.a, a, random), flatten(*p.b, b, random), approach(p, a, b, random);
    if (f == family::parallel)
      align(p, a, b, random), approach(p, a, b, random);
    if (!is_in_box(*p.a, a) || !is_in_box(*p.b, b))
      continue;
    std::copy_n(a, fields_a, out.a.data() + kept * fields_a);
    std::copy_n(b, fields_b, out.b.data() + kept * fields_b);
    ++kept;
  }
  out.count = kept;
  out.a.resize(kept * fields_a), out.b.resize(kept * fields_b);
  const float scale = std::ldexp(1.0F, std::min(0, std::ilogb(reach / widest)));
  for (std::vector<float> *const all : {&out.a, &out.b})
    for (float &x : *all)
      x *= scale;
  return out;
}

static std::vector<answer> decide(const predicate_info &p, rung by, const rows &r) {
  std::vector<index_pair> pairs(r.count);
  for (std::size_t i = 0; i < r.count; ++i)
    pairs[i] = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)};
  std::vector<answer> out(r.count);
  cascade(p, by).decide(r.a.data(), r.b.data(), pairs.data(), r.count, out.data());
  return out;
}

std::vector<answer> tolerant_answers(const predicate_info &p, rows r) {
  pose at;
  at.grid = p.tolerance.step;
  for (std::size_t i = 0; i < r.count && at.grid > 0; ++i) {
    move_rows(*p.a, at, r.a.data() + i * static_cast<std::size_t>(p.a->fields), 1);
    move_rows(*p.b, at, r.b.data() + i * static_cast<std::size_t>(p.b->fields), 1);
  }
  return decide(p, rung::tolerant, r);
}

tally compare(const predicate_info &p, const predicate_info &exact, const rows &r) {
  tally out;
  out.pairs = r.count;
  const std::vector<answer> truth = decide(exact, rung::certified, r), found = tolerant_answers(p, r);
  for (std::size_t i = 0; i < r.count; ++i) {
    out.hits += truth[i] == answer::yes;
    if (found[i] == truth[i])
      continue;
    ++out.differing;
    const double length =
        bench::distance_from_change(exact, r.a.data() + i * static_cast<std::size_t>(p.a->fields),
                                    r.b.data() + i * static_cast<std::size_t>(p.b->fields), truth[i] == answer::yes);
    out.farthest = std::max(out.farthest, found[i] == answer::unsure ? HUGE_VAL : length);
  }
  return out;
}

std::vector<subject> subjects() {
  std::vector<subject> out;
  for (const catalogue *const c :
       {&tolerant::catalogue(), &probe::catalogue(), &spheres::catalogue(), &both::catalogue()})
    for (int i = 0; i < c->predicate_count; ++i)
      if (c->predicates[i].decide[static_cast<int>(rung::tolerant)])
        out.push_back({c->space, &c->predicates[i], &find_predicate(cga::catalogue(), c->predicates[i].name)});
  return out;
}

} // namespace meetc::tolerant_test
