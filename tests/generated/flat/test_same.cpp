// The flat scene asks for the predicates of points, segments and triangles in another algebra, pga3. The polynomials
// are the same in both algebras, so each rung answers every pair as that of the shipped scene does: plain rungs with
// the same wrong answers, bounded ones with the same unsure ones.
#include "meet/core/cascade/cascade.hpp"
#include "tests/catch.hpp"
#include "tests/extremes/families/families.hpp"
#include "tests/generated/judge/effort.hpp"

#include <array>
#include <cga/cga_runtime.hpp>
#include <flat/flat_runtime.hpp>
#include <map>
#include <string>
#include <vector>

using namespace meetc::extremes_test;
using meetc::answer;
using meetc::predicate_info;
using meetc::generated_test::effort;

namespace {

// Pairs of rows in sequence, as a runtime stores them.
struct rows {
  std::vector<float> a, b;
  std::vector<meetc::index_pair> pairs;

  void add(const pair_of_rows &p) {
    a.insert(a.end(), p.a.begin(), p.a.end());
    b.insert(b.end(), p.b.begin(), p.b.end());
    const auto i = static_cast<std::uint32_t>(pairs.size());
    pairs.push_back({i, i});
  }
};

using answers = std::vector<answer>;

template <class Decide> answers all(const Decide &decide, const rows &r) {
  answers out(r.pairs.size());
  decide(meetc::row_array(r.a.data()), meetc::row_array(r.b.data()), r.pairs.data(), out.size(), out.data());
  return out;
}

// The answers of each rung, by its name.
std::map<std::string, answers> all(const predicate_info &p, const rows &r) {
  static constexpr std::array names = {"fp32", "fp64", "fp64x2", "exact", "certified"};
  std::map<std::string, answers> out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out[names[i]] = all([by = meetc::cascade(p, static_cast<meetc::rung>(i))](auto... to) { by.decide(to...); }, r);
  for (std::size_t i = 0; i < meetc::bounded_rungs; ++i)
    out[std::string("bounded ") + names[i]] = all(p.certify[i], r);
  for (float side = 0x1p-20F; side <= 0x1p20F; side *= 0x1p8F) {
    answers &found = out["box " + std::to_string(side)];
    found.resize(r.pairs.size());
    // Only pairs that lie in the box, since for others nothing is promised.
    for (std::size_t i = 0; i < r.pairs.size(); ++i) {
      const row a(r.a.begin() + static_cast<long>(i) * p.a->fields,
                  r.a.begin() + static_cast<long>(i + 1) * p.a->fields);
      const row b(r.b.begin() + static_cast<long>(i) * p.b->fields,
                  r.b.begin() + static_cast<long>(i + 1) * p.b->fields);
      const auto shape_of = [](int fields) {
        return fields == 3 ? shape::point : fields == 6 ? shape::segment : shape::triangle;
      };
      const float least = box_side(shape_of(p.a->fields), a, shape_of(p.b->fields), b);
      found[i] = answer::unsure;
      if (least > 0 && least <= side)
        p.certify_in_box(side, r.a.data(), r.b.data(), &r.pairs[i], 1, &found[i]);
    }
  }
  return out;
}

const predicate_info &named(const meetc::catalogue &c, const std::string &name) {
  for (int i = 0; i < c.predicate_count; ++i)
    if (c.predicates[i].name == name)
      return c.predicates[i];
  throw std::invalid_argument(name);
}

rows cases_of(const family &f, const subject &s, int count) {
  random_numbers random(70);
  rows r;
  for (int i = 0; i < count; ++i)
    r.add(f.make(s.a, s.b, random));
  return r;
}

} // namespace

TEST_CASE("the flat scene has the four predicates of flat kinds, with the same fields") {
  const meetc::catalogue &flat = flat::catalogue();
  CHECK(flat.predicate_count == 4);
  for (int i = 0; i < flat.predicate_count; ++i) {
    const predicate_info &p = flat.predicates[i], &q = named(*cga::catalogue_for(flat.compiled_for), p.name);
    INFO(p.name);
    CHECK(std::string(p.a->csv) == q.a->csv);
    CHECK(std::string(p.b->csv) == q.b->csv);
    CHECK(p.box_least == q.box_least);
    CHECK(p.box_most == q.box_most);
  }
}

TEST_CASE("both scenes give the same answers on every rung") {
  const meetc::catalogue &flat = flat::catalogue();
  for (int i = 0; i < flat.predicate_count; ++i) {
    const predicate_info &p = flat.predicates[i], &q = named(*cga::catalogue_for(flat.compiled_for), p.name);
    const subject &s = subject_named(p.name);
    std::map<std::string, std::array<bool, 3>> given; // no, yes, unsure: whether a rung gives it at all
    for (const family &f : families()) {
      if (!f.applies(s.a, s.b))
        continue;
      const rows r = cases_of(f, s, effort(2000));
      const auto mine = all(p, r), theirs = all(q, r);
      for (const auto &[rung, found] : mine) {
        const answers &want = theirs.at(rung);
        int different = 0;
        for (std::size_t k = 0; k < found.size(); ++k) {
          different += found[k] != want[k];
          given[rung][static_cast<std::size_t>(found[k])] = true;
        }
        INFO(p.name << ", " << f.name << ", " << rung);
        CHECK(different == 0);
      }
    }
    // The cases bring every rung to give more than one answer.
    for (const auto &[rung, some] : given) {
      INFO(p.name << ", " << rung);
      CHECK(some[0] + some[1] + some[2] >= 2);
    }
  }
}

TEST_CASE("rungs that differ are told apart: fp32 is not the exact rung") {
  const meetc::catalogue &flat = flat::catalogue();
  for (int i = 0; i < flat.predicate_count; ++i) {
    const predicate_info &p = flat.predicates[i], &q = named(*cga::catalogue_for(flat.compiled_for), p.name);
    const rows r = cases_of(family_named("degenerate"), subject_named(p.name), effort(2000));
    INFO(p.name);
    CHECK(all(p.decide[0], r) != all(q.decide[3], r));
  }
}
