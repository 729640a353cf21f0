// The emitted lists of kinds and predicates are those of the table that a runtime reads.
#include <cga/cga_runtime.hpp>
#include <cga/for_each.hpp>

#include "tests/catch.hpp"

#include <string>
#include <vector>

TEST_CASE("for_each: the kinds and the predicates of the catalogue, in its order") {
  const meetc::catalogue &all = cga::catalogue();
  const auto kind_count = static_cast<std::size_t>(all.kind_count);
  const auto predicate_count = static_cast<std::size_t>(all.predicate_count);
  std::vector<std::string> kinds, predicates, signs;
  cga::for_each_kind([&kinds](auto k) {
    kinds.emplace_back(k.name);
    float row[decltype(k)::shape::fields], back[decltype(k)::shape::fields];
    for (int i = 0; i < decltype(k)::shape::fields; ++i)
      row[i] = static_cast<float>(i + 1);
    to_row(k.in(row), back);
    CHECK(std::vector<float>(std::begin(row), std::end(row)) == std::vector<float>(std::begin(back), std::end(back)));
  });
  cga::for_each_predicate([&]<class P, class A, class B>(const cga::detail::on_kinds<P, A, B> &p) {
    const std::size_t i = predicates.size();
    predicates.emplace_back(p.name);
    REQUIRE(i < predicate_count);
    CHECK(std::string(all.predicates[i].a->name) == A::name);
    CHECK(std::string(all.predicates[i].b->name) == B::name);
  });
  cga::for_each_sign([&signs](auto s) { signs.emplace_back(s.name); });
  REQUIRE(kinds.size() == kind_count);
  for (std::size_t i = 0; i < kinds.size(); ++i)
    CHECK(kinds[i] == all.kinds[i].name);
  REQUIRE(predicates.size() == predicate_count);
  for (std::size_t i = 0; i < predicates.size(); ++i)
    CHECK(predicates[i] == all.predicates[i].name);
  CHECK(signs == std::vector<std::string>{"side_triangle_point", "side_sphere_point", "twist_segment_segment"});
}
