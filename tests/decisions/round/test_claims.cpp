// Step 3 of the proof: every claim has a certificate that multiplies out to zero. A wrong decision has a claim without
// one.
#include "tests/catch.hpp"
#include "tests/decisions/round/claim.hpp"

#include <map>

using namespace meetc::decisions_round;

namespace {

decision decision_of(const emitted &e) {
  return e.value ? decision{} : stated(e);
}

} // namespace

TEST_CASE("every claim of the proof has a certificate") {
  std::map<std::string, std::size_t> count;
  for (const emitted &e : emitted_predicates())
    for (const claim &c : claims_of(e, decision_of(e))) {
      INFO(e.name << ": " << c.name);
      CHECK(refusal(c) == "");
      ++count[e.name];
    }
  CHECK(count == std::map<std::string, std::size_t>{{"ball_ball", 2},
                                                    {"sphere_sphere", 4},
                                                    {"ball_segment", 9},
                                                    {"sphere_segment", 13},
                                                    {"ball_triangle", 36},
                                                    {"sphere_triangle", 42},
                                                    {"side_sphere_point", 4}});
}

TEST_CASE("a wrong decision leaves a claim without a certificate") {
  const std::vector<mutant> all = mutants();
  CHECK(all.size() == 30);
  for (const mutant &m : all) {
    INFO(m.of << ": " << m.what);
    std::size_t refused = 0;
    for (const claim &c : claims_of(emitted_predicate(m.of), m.wrong))
      refused += refusal(c).empty() ? 0 : 1;
    CHECK(refused > 0);
  }
}

TEST_CASE("a certificate with one thing changed proves nothing") {
  std::size_t changed = 0;
  for (const char *name : {"sphere_sphere", "sphere_segment", "sphere_triangle"}) {
    const emitted &e = emitted_predicate(name);
    for (const claim &right : claims_of(e, stated(e))) {
      INFO(name << ": " << right.name);
      const auto refused = [&](const auto &change) {
        claim wrong = right;
        change(wrong);
        ++changed;
        CHECK(refusal(wrong) != "");
      };
      for (std::size_t i = 0; i < right.products.size(); ++i) {
        refused([&](claim &c) { ++c.products[i].factor; });
        refused([&](claim &c) { c.products[i].factor *= -1; });
        refused([&](claim &c) { c.products.erase(c.products.begin() + static_cast<std::ptrdiff_t>(i)); });
        refused([&](claim &c) { c.products[i].of.emplace_back("no such fact"); });
      }
      for (std::size_t i = 0; i < right.equations.size(); ++i)
        refused([&](claim &c) { c.equations.erase(c.equations.begin() + static_cast<std::ptrdiff_t>(i)); });
      refused([&](claim &c) { // without a strict inequality there is no contradiction
        for (fact &f : c.facts)
          f.is = f.is == relation::above ? relation::at_least : f.is;
      });
      for (const fact &f : right.facts)
        if (f.is == relation::equal)
          refused([&](claim &c) { c.products.push_back({1, {f.name}}); });
    }
  }
  CHECK(changed > 500);
}
