// A kind's rule, and the factors of signs that it makes positive.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include "gen/lower/expand/rule.hpp"
#include "gen/verify/verify.hpp"

using namespace meetc;
using namespace meetc::compiler_test;
using polynomial = poly::poly;
using type = lower::element_rule::type;

namespace {

// Points p and q of object A with a number r, and a point c of object B with a number s.
struct setting {
  poly::ring ring{{"px", "py", "pz", "qx", "qy", "qz", "r", "cx", "cy", "cz", "s"}};
  poly::local_origin origin{ring, [] {
                              std::vector<poly::stored_number> all;
                              for (int i = 0; i < 6; ++i)
                                all.push_back({0, i / 3, i % 3, true});
                              all.push_back({0, -1, 0, false});
                              for (int i = 0; i < 3; ++i)
                                all.push_back({1, 0, i, true});
                              all.push_back({1, -1, 0, false});
                              return all;
                            }()};
  lower::known_signs known{&origin, {}, {}, {}};

  polynomial at(int v) const { return polynomial::variable(ring, v); }
  polynomial distance2(int x, int y, int axes = 3) const {
    polynomial sum(ring);
    for (int i = 0; i < axes; ++i)
      sum = sum + (at(x + i) - at(y + i)) * (at(x + i) - at(y + i));
    return sum;
  }
};
const int p = 0, q = 3, r = 6, c = 7, s = 10;

} // namespace

TEST_CASE("rules: a squared distance is positive only between points that differ") {
  setting t;
  CHECK_FALSE(t.known.is_positive(t.distance2(p, q)));
  t.known.add({type::differ, {0, 1, 2}, {3, 4, 5}, "p != q"}, 0);
  CHECK(t.known.is_positive(t.distance2(p, q)));
  CHECK(t.known.is_positive(t.distance2(p, q).scaled(3) + t.distance2(p, c)));
  CHECK_FALSE(t.known.is_positive(t.distance2(p, q, 2))); // the points may differ along the third axis alone
  CHECK_FALSE(t.known.is_positive(t.distance2(p, c)));
  CHECK_FALSE(t.known.is_positive(t.distance2(p, q) - t.distance2(p, c)));
  CHECK_FALSE(t.known.is_positive(t.distance2(p, q) * t.distance2(p, c)));
  CHECK_FALSE(t.known.is_positive(t.distance2(p, q) + t.at(r)));
}

TEST_CASE("rules: numbers that are positive, or at least not negative") {
  setting t;
  t.known.add({type::not_negative, {r}, {}, "r >= 0"}, 0);
  CHECK_FALSE(t.known.is_positive(t.at(r)));
  t.known.add({type::positive, {s - c}, {}, "s > 0"}, c);
  CHECK(t.known.is_positive(t.at(s)));
  CHECK(t.known.is_positive(t.at(r) + t.at(s)));
  CHECK(t.known.is_positive(t.at(s) * t.at(s) + t.distance2(p, c)));
  CHECK(t.known.is_positive(polynomial(t.ring, 1) + t.at(r)));
  CHECK_FALSE(t.known.is_positive(t.at(s) - t.at(r)));
  CHECK_FALSE(t.known.is_positive(t.at(r) * t.at(s)));
  CHECK_FALSE(t.known.is_positive(t.at(r) * t.at(r)));
}

TEST_CASE("rules: rows obey them or not") {
  const auto row = [](std::vector<int> of) { return std::vector<lower::rational>(of.begin(), of.end()); };
  const lower::element_rule differ{type::differ, {0, 1}, {2, 3}, ""};
  CHECK(lower::obeys(std::nullopt, row({})));
  CHECK(lower::obeys(differ, row({1, 2, 1, 3})));
  CHECK_FALSE(lower::obeys(differ, row({1, 2, 1, 2})));
  const lower::element_rule ordered{type::not_above, {0, 1}, {2, 3}, ""};
  CHECK(lower::obeys(ordered, row({1, 2, 1, 3})));
  CHECK(lower::obeys(ordered, row({1, 2, 1, 2})));
  CHECK_FALSE(lower::obeys(ordered, row({1, 3, 1, 2})));
  CHECK_FALSE(lower::obeys(ordered, row({2, 2, 1, 2})));
  CHECK(lower::obeys(lower::element_rule{type::not_negative, {0}, {}, ""}, row({0})));
  CHECK_FALSE(lower::obeys(lower::element_rule{type::positive, {0}, {}, ""}, row({0})));
  CHECK_FALSE(lower::obeys(lower::element_rule{type::not_negative, {0}, {}, ""}, row({-1})));
}

TEST_CASE("rules: without the rule a sign keeps the factor, and with it verify finds no wrong sign") {
  const std::string asked = "sign(norm2(meet(point_pair, sphere)))";
  const spec_copy with({asked}), without({asked});
  without.replace("cga3.toml", "where = 'p != q'\n", "");
  CHECK(with.compile().kernels[0].decision.common.atoms.size() == 2);
  CHECK(without.compile().kernels[0].decision.common.atoms.size() == 3);
  for (const spec_copy *spec : {&with, &without}) {
    const compilation compiled = spec->compile();
    CHECK(verify::verify_sign(*compiled.model, compiled.kernels[0], 2000, 5).wrong == 0);
  }
  // The factor is dropped because of the rule: judged on all operands, the sign without it is wrong where p = q.
  const compilation ruled = with.compile(), unruled = without.compile();
  lower::kernel k = ruled.kernels[0];
  k.asked.kinds = unruled.kernels[0].asked.kinds;
  CHECK(verify::verify_sign(*unruled.model, k, 2000, 5).wrong > 0);
}
