// Which processor answers, where the user leaves the choice to the program.
#include "meet/app/input/made_sets.hpp"
#include "meet/app/query/collide_sets.hpp"
#include "tests/catch.hpp"

#include <cga/cga_runtime.hpp>

using namespace meetc;
using namespace meetc::app;

TEST_CASE("a device is taken by itself where its start pays") {
  const expected_seconds few = expected_on(10'000, 2), many = expected_on(30'000'000, 2);
  CHECK(few.cpu < few.cuda);
  CHECK(many.cuda < many.cpu);
  CHECK(expected_on(30'000'000, 1).cpu > many.cpu);
  CHECK_FALSE(device_expected(10'000, 2));
  // From where on, as docs/gpu.md says.
  for (const auto &[threads, pays] : {std::pair(2, 2'700'000), std::pair(16, 16'000'000)})
    for (const int percent : {-3, 3}) {
      const auto n = static_cast<std::size_t>(pays / 100 * (100 + percent));
      const expected_seconds expected = expected_on(n, threads);
      CHECK((expected.cuda < expected.cpu) == (percent > 0));
    }

  // Without a device the CPU answers, and says why.
  const std::size_t n = 2'500'000;
  const io::element_set points = of_rows(cga::catalogue(), "point", std::vector<float>(3 * n)),
                        triangle = of_rows(cga::catalogue(), "triangle", {-1, -1, 0, 1, -1, 0, 0, 1, 0});
  query q;
  q.by = choose(cga::catalogue(), *points.kind, *triangle.kind, {}, {});
  q.threads = 1;
  q.on = processor::best;
#if MEETC_WITH_CUDA
  REQUIRE(device_expected(n + 1, 1));
#endif
  const answers found = collide_sets(points, triangle, q);
  CHECK(found.pairs == n);
  CHECK(found.notes.size() == (device_expected(n + 1, 1) ? 1 : 0));
}
