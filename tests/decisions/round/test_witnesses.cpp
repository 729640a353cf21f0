// Step 5: the emitted decision on exact signs against exact distances, on witnesses of every case of the proof; each
// wrong decision is wrong on some witness.
#include "tests/catch.hpp"
#include "tests/decisions/round/witnesses.hpp"

#include <map>

using namespace meetc;
using namespace meetc::decisions_round;

namespace {
constexpr int count = 8000;
constexpr unsigned seed = 12;
} // namespace

TEST_CASE("the emitted decision is right on witnesses of every case") {
  for (const emitted &e : emitted_predicates()) {
    INFO(e.name);
    std::map<std::string, long> seen;
    long wrong = 0, wrong_signs = 0;
    const decision d = e.value ? decision{{stated_side()}, {}, {}, false} : stated(e);
    for (const witness &w : witnesses(e, count, seed)) {
      ++seen[w.where];
      const std::vector<meetc::sign> signs = e.signs(w.a, w.b);
      wrong += e.decide(signs.data()) != touching(e, w);
      const std::vector<int> stated_signs = signs_of(d, w);
      for (std::size_t i = 0; i < signs.size(); ++i)
        wrong_signs += static_cast<int>(signs[i]) != stated_signs[i];
      if (e.value) // inside, on, outside
        wrong += static_cast<int>(e.value(signs.data())) != (w.where == "least <") - (w.where == "least >");
    }
    CHECK(wrong == 0);
    CHECK(wrong_signs == 0);
    const std::vector<std::string> cases = cases_of(e);
    for (const std::string &c : cases) {
      INFO(c);
      CHECK(seen[c] > 0);
    }
    CHECK(seen.size() == cases.size()); // and there is no other case
  }
}

TEST_CASE("every wrong decision is wrong on some witness") {
  for (const emitted &e : emitted_predicates()) {
    const std::vector<witness> all = witnesses(e, count / 2, seed);
    std::vector<bool> truth;
    for (const witness &w : all)
      truth.push_back(touching(e, w));
    for (const mutant &m : mutants()) {
      if (m.of != e.name)
        continue;
      INFO(m.of << ": " << m.what);
      long caught = 0;
      for (std::size_t i = 0; i < all.size(); ++i)
        caught += m.wrong.hit(signs_of(m.wrong, all[i])) != truth[i];
      CHECK(caught > 0);
    }
  }
}
