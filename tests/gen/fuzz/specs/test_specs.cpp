// Some hundred mutants of the shipped specs.
#include "tests/catch.hpp"
#include "tests/gen/fuzz/specs/campaign.hpp"

using namespace meetc::fuzz;

TEST_CASE("mutants of specs are compiled or refused at a place") {
  spec_plan p;
  p.algebra_spec = MEETC_FUZZ_ALGEBRAS;
  p.count = 300;
  p.seconds = 60; // the sanitizers take ten times as long
  const spec_tally t = run_specs(p);
  for (const std::string &f : t.findings)
    FAIL_CHECK(f);
  CHECK(t.compiled > 10);
  CHECK(t.refused > 100);
}

TEST_CASE("a mutant depends on its seed and index alone") {
  const auto seeds = read_spec_seeds(MEETC_FUZZ_ALGEBRAS);
  const drawn_spec a = draw_spec(seeds, 7, 11), b = draw_spec(seeds, 7, 11), c = draw_spec(seeds, 7, 12);
  CHECK(a.algebra == b.algebra);
  CHECK(a.scene == b.scene);
  CHECK((a.algebra != c.algebra || a.scene != c.scene));
}
