// The exact rung of struct::hit against exact answers, on every family of operands.
#include "tests/catch.hpp"
#include "tests/generated/effort.hpp"
#include "tests/generated/judge.hpp"
#include "tests/generated/operands.hpp"

#include <map>
#include <sstream>
#include <string>

using namespace meetc::generated_test;

namespace {

// As C++ hexadecimal floats, for use in a test.
std::string text(const pair_of_rows &p) {
  std::ostringstream out;
  out << std::hexfloat << "a = {";
  for (const float f : p.a)
    out << ' ' << f;
  out << " } b = {";
  for (const float f : p.b)
    out << ' ' << f;
  out << " }";
  return out.str();
}

// The number of cases in a family, limited by the time of the judge.
int cases_of(shape a, shape b) {
  const int corners = points_of(a) * points_of(b);
  return effort(corners >= 6 ? 1200 : corners >= 3 ? 3000 : 5000);
}

// The bits that the pair's numbers span, from the lowest bit set to the highest.
int span_of(const pair_of_rows &p) {
  row all = p.a;
  all.insert(all.end(), p.b.begin(), p.b.end());
  return meetc::grid_of(all.data(), static_cast<int>(all.size())).bits();
}

struct tally {
  int cases = 0, hits = 0, wrong = 0, fp32_wrong = 0, fp64_wrong = 0;
  int widest = 0, by_width[4] = {0, 0, 0, 0}; // spans up to 20, 60, 250 bits and more
};

} // namespace

TEST_CASE("predicates: the exact rung against the oracle, on every family") {
  std::map<std::string, tally> by_predicate, by_family;
  for_each_predicate([&](auto p) {
    std::uint64_t seed = 1;
    for (const family &f : families()) {
      random_numbers random(seed++);
      tally t;
      for (int i = 0; i < cases_of(p.a, p.b); ++i) {
        const pair_of_rows rows = f.make(p.a, p.b, random);
        const bool want = touching(p.a, rows.a, p.b, rows.b, p.surface);
        const bool have = p.hit(rows.a, rows.b);
        const int span = span_of(rows);
        t.widest = std::max(t.widest, span);
        ++t.by_width[span <= 20 ? 0 : span <= 60 ? 1 : span <= 250 ? 2 : 3];
        ++t.cases;
        t.hits += want;
        t.fp32_wrong += p.template plain<float>(rows.a, rows.b) != want;
        t.fp64_wrong += p.template plain<double>(rows.a, rows.b) != want;
        if (have == want)
          continue;
        if (t.wrong++ == 0)
          FAIL_CHECK(p.name << " on " << f.name << ", case " << i << " should be " << want << ": " << text(rows));
      }
      CHECK(t.wrong == 0);
      for (tally *sum : {&by_predicate[p.name], &by_family[f.name]}) {
        sum->cases += t.cases, sum->hits += t.hits, sum->wrong += t.wrong;
        sum->fp32_wrong += t.fp32_wrong, sum->fp64_wrong += t.fp64_wrong;
        sum->widest = std::max(sum->widest, t.widest);
        for (int i = 0; i < 4; ++i)
          sum->by_width[i] += t.by_width[i];
      }
    }
  });
  // The cases are useful only where answers differ and rounding misleads. (-s shows the counts.)
  for (const auto &[name, t] : by_family) {
    INFO("family " << name << ": " << t.cases << " cases, " << t.hits << " hits, fp32 wrong " << t.fp32_wrong
                   << ", fp64 wrong " << t.fp64_wrong);
    CHECK(t.hits > t.cases / 50);
    CHECK(t.hits < t.cases - t.cases / 50);
  }
  for (const auto &[name, t] : by_predicate) {
    INFO("predicate " << name << ": " << t.cases << " cases, " << t.hits << " hits, fp32 wrong " << t.fp32_wrong
                      << ", fp64 wrong " << t.fp64_wrong);
    if (name == "box_box") { // the sign of a difference is that of the rounded one
      CHECK(t.fp32_wrong == 0);
      CHECK(t.fp64_wrong == 0);
    } else {
      CHECK(t.fp32_wrong > t.cases / 200);
      CHECK(t.fp64_wrong > 0);
    }
    // Every width of the exact rung was used, up to the widest.
    CHECK(t.widest >= 270);
    for (const int count : t.by_width)
      CHECK(count > t.cases / 100);
  }
}

TEST_CASE("predicates: segments, triangles and boxes against separating axes, in bulk") {
  for_each_predicate([&](auto p) {
    if constexpr (!padded(p.a) && !padded(p.b)) {
      std::uint64_t seed = 100;
      for (const family &f : families()) {
        random_numbers random(seed++);
        int wrong = 0;
        for (int i = 0; i < effort(4000); ++i) {
          const pair_of_rows rows = f.make(p.a, p.b, random);
          const bool want = touching_by_axes(p.a, rows.a, p.b, rows.b);
          if (p.hit(rows.a, rows.b) != want && wrong++ == 0)
            FAIL_CHECK(p.name << " on " << f.name << ", case " << i << " should be " << want << ": " << text(rows));
          // The two judges share nothing.
          if (i < effort(40))
            CHECK(touching(p.a, rows.a, p.b, rows.b, false) == want);
        }
        CHECK(wrong == 0);
      }
    }
  });
}
