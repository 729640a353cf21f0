// The tables of launchers: an initialiser that leaves a member out does not compile.
#include "tests/catch.hpp"

#include <meetc/every_pair/table.hpp>

#include <type_traits>

using namespace meetc;

namespace {

template <class T> constexpr bool is_stated = false;
template <class T> constexpr bool is_stated<cuda::stated<T>> = true;
template <class... Members> constexpr bool all_stated = (is_stated<std::remove_cv_t<Members>> && ...);

// Members in the order in which a table names them; a binding with another number of names does not compile.
constexpr cuda::set_launchers set{.name = "",
                                  .fields = 0,
                                  .pose = nullptr,
                                  .instances = nullptr,
                                  .sift = nullptr,
                                  .arrange = nullptr,
                                  .places = nullptr,
                                  .gather = nullptr,
                                  .boxes = nullptr};
constexpr cuda::predicate_launchers predicate{
    .name = "",
    .kind_a = 0,
    .kind_b = 0,
    .pairs = {.run = nullptr, .first_met = nullptr, .walk_first = nullptr, .contacts = nullptr},
    .rejects = false,
    .by_boxes = false,
    .by_balls = false};
constexpr cuda::formula_launchers formula{
    .name = "", .number_count = 0, .result_count = 0, .float32 = nullptr, .float64 = nullptr};

// A concept of T, so that what does not compile is false.
template <class T>
concept needs_no_contacts = requires {
  T{.run = nullptr, .first_met = nullptr, .walk_first = nullptr};
};
template <class T>
concept takes_all = requires {
  T{.run = nullptr, .first_met = nullptr, .walk_first = nullptr, .contacts = nullptr};
};
template <class T>
concept needs_no_boxes = requires {
  T{.name = "",
    .fields = 0,
    .pose = nullptr,
    .instances = nullptr,
    .sift = nullptr,
    .arrange = nullptr,
    .places = nullptr,
    .gather = nullptr};
};
template <class T>
concept needs_no_pairs = requires {
  T{.name = "", .kind_a = 0, .kind_b = 0, .rejects = false, .by_boxes = false, .by_balls = false};
};

} // namespace

TEST_CASE("tables: a member that is left out does not compile") {
  STATIC_REQUIRE(takes_all<cuda::pair_launchers>);
  STATIC_REQUIRE_FALSE(needs_no_contacts<cuda::pair_launchers>);
  STATIC_REQUIRE_FALSE(needs_no_boxes<cuda::set_launchers>);
  STATIC_REQUIRE_FALSE(needs_no_pairs<cuda::predicate_launchers>);
  STATIC_REQUIRE_FALSE(std::is_default_constructible_v<cuda::catalogue>);
  STATIC_REQUIRE_FALSE(std::is_default_constructible_v<every_pair::catalogue>);
}

TEST_CASE("tables: every member must be stated") {
  const auto &[name, fields, pose, instances, sift, arrange, places, gather, boxes] = set;
  STATIC_REQUIRE(all_stated<decltype(name), decltype(fields), decltype(pose), decltype(instances), decltype(sift),
                            decltype(arrange), decltype(places), decltype(gather), decltype(boxes)>);
  const auto &[of, kind_a, kind_b, pairs, rejects, by_boxes, by_balls] = predicate;
  STATIC_REQUIRE(all_stated<decltype(of), decltype(kind_a), decltype(kind_b), decltype(rejects), decltype(by_boxes),
                            decltype(by_balls)>);
  const auto &[run, first_met, walk_first, contacts] = pairs;
  STATIC_REQUIRE(all_stated<decltype(run), decltype(first_met), decltype(walk_first), decltype(contacts)>);
  const cuda::catalogue all{.kinds = &set,
                            .kind_count = 1,
                            .predicates = &predicate,
                            .predicate_count = 1,
                            .formulas = &formula,
                            .formula_count = 1,
                            .self_test = nullptr};
  const auto &[kinds, kind_count, predicates, predicate_count, formulas, formula_count, self_test] = all;
  STATIC_REQUIRE(all_stated<decltype(kinds), decltype(kind_count), decltype(predicates), decltype(predicate_count),
                            decltype(formulas), decltype(formula_count), decltype(self_test)>);
  const auto &[called, numbers, results, float32, float64] = formula;
  STATIC_REQUIRE(
      all_stated<decltype(called), decltype(numbers), decltype(results), decltype(float32), decltype(float64)>);
  const every_pair::set_launchers brute{.name = "", .enclose = nullptr, .columns = nullptr};
  const auto &[kind, enclose, columns] = brute;
  STATIC_REQUIRE(all_stated<decltype(kind), decltype(enclose), decltype(columns)>);
  const every_pair::catalogue brute_all{
      .kinds = &brute, .kind_count = 1, .candidates = nullptr, .touching = nullptr, .probe = nullptr};
  const auto &[brute_kinds, brute_count, candidates, touching, probe] = brute_all;
  STATIC_REQUIRE(all_stated<decltype(brute_kinds), decltype(brute_count), decltype(candidates), decltype(touching),
                            decltype(probe)>);
}
