// Stored values: answers that read them equal those that compute them, and the rungs in fp32 do read them.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/many_rows.hpp"

#include <cfenv>
#include <cga/cga_runtime.hpp>
#include <cstring>
#include <limits>
#include <meetc/decide/stored_values.hpp>

using namespace meetc::generated_test;
using meetc::answer;
using meetc::row_array;

namespace {

const meetc::predicate_info &named(const char *name) {
  return meetc::generated_test::named(cga::catalogue(), name);
}

template <class Decide> std::vector<answer> answers(const many_rows &r, const Decide &decide) {
  std::vector<answer> out(r.pairs.size(), answer::unsure);
  decide(r.pairs.data(), r.pairs.size(), out.data());
  return out;
}

} // namespace

TEST_CASE("stored: the rungs in fp32 give the same answers with and without stored values") {
  for_each_predicate([](auto p) {
    INFO(p.name);
    const meetc::predicate_info &info = named(p.name);
    const many_rows r(p, static_cast<std::uint32_t>(effort(200)));
    const std::vector<float> of_a = stored(info.stored_a, r.a, info.a->fields),
                             of_b = stored(info.stored_b, r.b, info.b->fields),
                             plain_of_a = stored(info.plain_stored_a, r.a, info.a->fields),
                             plain_of_b = stored(info.plain_stored_b, r.b, info.b->fields);
    const row_array a = r.a.data(), b = r.b.data(), a_stored{r.a.data(), or_null(of_a)},
                    b_stored{r.b.data(), or_null(of_b)}, a_plain{r.a.data(), or_null(plain_of_a)},
                    b_plain{r.b.data(), or_null(plain_of_b)};
    CHECK(answers(r, [&](auto... to) { info.decide[0](a_plain, b_plain, to...); }) ==
          answers(r, [&](auto... to) { info.decide[0](a, b, to...); }));
    CHECK(answers(r, [&](auto... to) { info.certify[0](a_stored, b_stored, to...); }) ==
          answers(r, [&](auto... to) { info.certify[0](a, b, to...); }));
    for (const float side : {info.box_least, 1.0F, info.box_most})
      CHECK(answers(r, [&](auto... to) { info.certify_in_box(side, a_stored, b_stored, to...); }) ==
            answers(r, [&](auto... to) { info.certify_in_box(side, a, b, to...); }));
  });
}

TEST_CASE("stored: the stored values are read") {
  int kinds = 0;
  for_each_predicate([&](auto p) {
    INFO(p.name);
    const meetc::predicate_info &info = named(p.name);
    const many_rows r(p, 50);
    std::vector<float> of_a = stored(info.stored_a, r.a, info.a->fields),
                       of_b = stored(info.stored_b, r.b, info.b->fields);
    const auto certify = [&] {
      return answers(r, [&](auto... to) {
        info.certify[0]({r.a.data(), or_null(of_a)}, {r.b.data(), or_null(of_b)}, to...);
      });
    };
    const std::vector<answer> right = certify();
    for (std::vector<float> *numbers : {&of_a, &of_b}) {
      if (numbers->empty())
        continue;
      ++kinds;
      const std::vector<float> before = *numbers;
      std::fill(numbers->begin(), numbers->end(), std::numeric_limits<float>::quiet_NaN());
      CHECK(certify() != right); // no sign that reads it is known
      *numbers = before;
    }
  });
  CHECK(kinds == 8); // 2 of triangle_triangle; one of 6 others
}

TEST_CASE("stored: predicates share equal values, and a triangle's normal is three numbers and their magnitudes") {
  using layout = meetc::stored_layout<cga::triangle_triangle>;
  CHECK(cga::triangle_triangle::reject_stage::fields_a == 3);
  CHECK(layout::floats_a == 6);
  CHECK(layout::floats_b == 6);
  CHECK(cga::triangle_triangle::common_stage::fields_a == 0); // only differences
  const meetc::stored_values normal = named("triangle_triangle").stored_a;
  CHECK(named("triangle_triangle").stored_b.number == normal.number);
  CHECK(named("segment_triangle").stored_b.number == normal.number);
  CHECK(named("segment_triangle").stored_a.number == -1);
  CHECK(named("ball_triangle").stored_b.number != normal.number);
  // Two predicates that share stored values compute equal numbers on rows of every family.
  for_each_predicate([](auto p) {
    for_each_predicate([&](auto q) {
      INFO(p.name << ' ' << q.name);
      const meetc::predicate_info &x = named(p.name), &y = named(q.name);
      CHECK((x.stored_a.number < 0) == (x.plain_stored_a.number < 0));
      const auto same = [](const meetc::kind_info *k, const meetc::stored_values &v, const meetc::kind_info *l,
                           const meetc::stored_values &w, const row &rows) {
        if (k != l || v.number < 0 || v.number != w.number)
          return;
        const std::vector<float> by_v = stored(v, rows, k->fields), by_w = stored(w, rows, k->fields);
        REQUIRE(by_v.size() == by_w.size());
        CHECK(std::memcmp(by_v.data(), by_w.data(), by_v.size() * sizeof(float)) == 0);
      };
      const many_rows r(p, 20);
      for (const meetc::stored_values &v : {y.stored_a, y.plain_stored_a})
        same(x.a, x.stored_a, y.a, v, r.a), same(x.a, x.plain_stored_a, y.a, v, r.a),
            same(x.b, x.stored_b, y.a, v, r.b), same(x.b, x.plain_stored_b, y.a, v, r.b);
      for (const meetc::stored_values &v : {y.stored_b, y.plain_stored_b})
        same(x.a, x.stored_a, y.b, v, r.a), same(x.a, x.plain_stored_a, y.b, v, r.a),
            same(x.b, x.stored_b, y.b, v, r.b), same(x.b, x.plain_stored_b, y.b, v, r.b);
    });
  });
}

TEST_CASE("stored: stored values do not depend on the caller's rounding") {
  const meetc::stored_values v = named("triangle_triangle").stored_a;
  const row one{0.1F, 0.2F, 0.3F, 1.7F, 0.4F, 0.9F, 0.6F, 1.3F, 0.8F};
  std::vector<float> upward(static_cast<std::size_t>(v.floats), 7.0F), nearest(upward.size(), 9.0F);
  REQUIRE(std::fesetround(FE_UPWARD) == 0);
  const bool stored_upward = v.compute(one.data(), 1, upward.data());
  std::fesetround(FE_TONEAREST);
  CHECK(stored_upward);
  CHECK(v.compute(one.data(), 1, nearest.data()));
  CHECK(std::memcmp(upward.data(), nearest.data(), nearest.size() * sizeof(float)) == 0);
}
