// The first element that each segment meets, as core finds it, against the list of all pairs.
#include "tests/catch.hpp"

#include "meet/core/query/collide.hpp"
#include "meet/io/read.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <filesystem>
#include <random>
#include <string_view>
#include <vector>

using namespace meetc;

namespace {

const predicate_info &named(std::string_view name) {
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i)
    if (all.predicates[i].name == name)
      return all.predicates[i];
  throw std::logic_error("no such predicate");
}

using rows = std::vector<float>;

// n rows of numbers on a coarse lattice, where much is met at one point, or anywhere.
rows some(const kind_info &kind, std::size_t n, bool lattice, std::mt19937 &g) {
  rows out(n * static_cast<std::size_t>(kind.fields));
  for (float &x : out)
    x = lattice ? static_cast<float>(static_cast<int>(g() % 7)) : static_cast<float>(g() >> 8) * 0x1p-24F;
  return out;
}

prepared ready(const rows &r, const kind_info &kind, const prepared *near = nullptr) {
  const auto fields = static_cast<std::size_t>(kind.fields);
  return prepare({r.data(), 0, fields * sizeof(float), nullptr, r.size() / fields}, kind, {}, 0, near);
}

std::vector<std::uint32_t> from_list(const std::vector<index_pair> &pairs, const rows &a, const rows &b,
                                     const predicate_info &p) {
  const auto row = [](const rows &of, std::uint32_t i, const kind_info &kind) {
    return of.data() + i * static_cast<std::size_t>(kind.fields);
  };
  std::vector<std::uint32_t> out(a.size() / static_cast<std::size_t>(p.a->fields), no_element);
  for (const index_pair hit : pairs) // those of an element in the order of their numbers
    if (std::uint32_t &first = out[hit.a];
        first == no_element || p.first_met(row(a, hit.a, *p.a), row(b, hit.b, *p.b), row(b, first, *p.b)) < 0)
      first = hit.b;
  return out;
}

void agree(const rows &a, const rows &b) {
  const predicate_info &p = named("segment_triangle");
  const prepared x = ready(a, *p.a), y = ready(b, *p.b), near = ready(b, *p.b, &x);
  for (const rung precision : {rung::certified, rung::exact, rung::fp32}) {
    collide_options o;
    const std::vector<std::uint32_t> want = from_list(collide(x, y, p, precision, o).pairs, a, b, p);
    o.first_met = true;
    for (const int threads : {1, 2, 7})
      for (const answer_kind kind :
           {answer_kind::pairs, answer_kind::count, answer_kind::counts, answer_kind::flags, answer_kind::none}) {
        o.threads = threads, o.want = kind;
        const result r = collide(x, y, p, precision, o);
        CHECK(r.first_met == want);
        CHECK((kind != answer_kind::none || r.count == 0));
        CHECK(r.pairs.empty() == (kind != answer_kind::pairs || r.count == 0));
      }
    CHECK(collide(x, near, p, precision, o).first_met == want);
  }
}

} // namespace

TEST_CASE("first met: every kind of answer names the first of the list") {
  const predicate_info &p = named("segment_triangle");
  std::mt19937 g(8);
  for (const bool lattice : {false, true})
    agree(some(*p.a, 300, lattice, g), some(*p.b, 400, lattice, g));
  agree(some(*p.a, 3, false, g), some(*p.b, 3000, false, g)); // many hits of one segment
  agree({}, some(*p.b, 10, true, g));
  agree(some(*p.a, 10, true, g), {});
  // Coordinates whose products leave float32.
  for (const float scale : {1e-20F, 1e-44F, 1e20F, 3e37F}) {
    rows a = some(*p.a, 60, true, g), b = some(*p.b, 80, true, g);
    for (rows *const r : {&a, &b})
      for (float &x : *r)
        x *= scale;
    agree(a, b);
  }
}

TEST_CASE("first met: elements of B are named by their items") {
  const predicate_info &p = named("segment_triangle");
  std::mt19937 g(9);
  const rows a = some(*p.a, 200, true, g), b = some(*p.b, 300, true, g);
  const prepared x = ready(a, *p.a), y = ready(b, *p.b);
  const std::vector<index_pair> pairs = collide(x, y, p, rung::certified, {}).pairs;
  std::vector<std::uint32_t> in_order, mixed;
  for (std::uint32_t i = 0; i < 300; ++i)
    in_order.push_back(i / 3), mixed.push_back(static_cast<std::uint32_t>(g() % 100));
  for (const std::vector<std::uint32_t> &owners : {in_order, mixed}) {
    // The least item of the elements that are met at the first point.
    std::vector<std::uint32_t> want(200, no_element), at(200, no_element);
    int ties = 0;
    for (const index_pair hit : pairs) {
      const auto row_b = [&](std::uint32_t i) { return b.data() + 9 * std::size_t{i}; };
      std::uint32_t &item = want[hit.a], &first = at[hit.a];
      const int order =
          first == no_element ? -1 : p.first_met(a.data() + 6 * std::size_t{hit.a}, row_b(hit.b), row_b(first));
      ties += order == 0 && owners[hit.b] < item;
      if (order < 0)
        first = hit.b, item = owners[hit.b];
      else if (order == 0)
        item = std::min(item, owners[hit.b]);
    }
    CHECK((ties > 10) == (owners == mixed));
    CHECK(std::count(want.begin(), want.end(), no_element) < 200);
    for (const answer_kind kind : {answer_kind::pairs, answer_kind::count, answer_kind::none}) {
      collide_options o;
      o.first_met = true, o.owner_b = owners, o.want = kind;
      CHECK(collide(x, y, p, rung::certified, o).first_met == want);
    }
  }
}

TEST_CASE("first met: a query without an answer is refused") {
  const predicate_info &p = named("segment_triangle"), &balls = named("ball_ball");
  const rows a{0, 0, 0, 1, 0, 0}, b{0, 0, 0, 1, 0, 0, 0, 1, 0}, c{0, 0, 0, 1};
  const prepared x = ready(a, *p.a), y = ready(b, *p.b), z = ready(c, *balls.a);
  collide_options o;
  o.first_met = true;
  CHECK_THROWS_AS(collide(z, z, balls, rung::certified, o), std::invalid_argument);
  o.want = answer_kind::any;
  CHECK_THROWS_AS(collide(x, y, p, rung::certified, o), std::invalid_argument);
  o.want = answer_kind::pairs;
  const std::vector<std::uint32_t> owner{0};
  o.owner_a = owner;
  CHECK_THROWS_AS(collide(x, y, p, rung::certified, o), std::invalid_argument);
  o.owner_a = {};
  o.first_met = false, o.want = answer_kind::none;
  CHECK_THROWS_AS(collide(x, y, p, rung::certified, o), std::invalid_argument);
  o.first_met = true, o.want = answer_kind::pairs;
  CHECK(collide(x, y, p, rung::certified, o).first_met == std::vector<std::uint32_t>{0});
}

TEST_CASE("first met: long segments through a real mesh") {
  const std::filesystem::path file = std::filesystem::path(MEETC_DATA) / "bunny_5k.ply";
  if (!std::filesystem::exists(file)) {
    WARN("the real meshes are not there");
    return;
  }
  const predicate_info &p = named("segment_triangle");
  const kind_info *const kinds[] = {p.b};
  const io::element_set mesh = io::read(file, kinds);
  rows b(9 * mesh.elements);
  for (std::size_t i = 0; i < mesh.elements; ++i)
    mesh.row(i, b.data() + 9 * i);
  const prepared y = ready(b, *p.b);
  float lo[3], hi[3];
  y.bounds(lo, hi);
  std::mt19937 g(10);
  rows a;
  for (int i = 0; i < 6 * 500; ++i)
    a.push_back(lo[i % 3] + (hi[i % 3] - lo[i % 3]) * static_cast<float>(g() >> 8) * 0x1p-24F);
  agree(a, b);
}
