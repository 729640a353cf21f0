// A caller tells bad elements, calls that do not fit and sets that are too large apart by the type of the exception.
#include "tests/catch.hpp"
#include "toy.hpp"

#include "meet/core/query/find.hpp"

#include <type_traits>

using namespace meetc;

namespace {

enum class thrown { nothing, bad_element, bad_call, too_many, other };

// As a program would, in the order of its handlers.
template <class F> thrown by(F &&f) {
  try {
    f();
    return thrown::nothing;
  } catch (const input_error &) {
    return thrown::bad_element;
  } catch (const usage_error &) {
    return thrown::bad_call;
  } catch (const std::length_error &) {
    return thrown::too_many;
  } catch (...) {
    return thrown::other;
  }
}

static_assert(!std::is_base_of_v<usage_error, input_error> && !std::is_base_of_v<input_error, usage_error>);

} // namespace

TEST_CASE("errors: a bad element and a call that does not fit have types of their own") {
  const float good[] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}, bad[] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 1};
  const view of_good{.data = good, .elements = 2}, of_bad{.data = bad, .elements = 2};
  const prepared x = prepare(of_good, toy::boxes), balls = prepare({.data = good, .elements = 3}, toy::balls);

  CHECK(by([&] { prepare(of_good, toy::boxes); }) == thrown::nothing);
  CHECK(by([&] { prepare(of_bad, toy::boxes); }) == thrown::bad_element);
  CHECK(by([&] { prepare({.data = nullptr, .elements = 2}, toy::boxes); }) == thrown::bad_element);
  CHECK(by([&] { prepare({.data = good, .elements = std::size_t{1} << 32}, toy::boxes); }) == thrown::too_many);

  CHECK(by([&] { collide(x, x, toy::box_box_hit, rung::fp32); }) == thrown::nothing);
  CHECK(by([&] { collide(x, balls, toy::box_box_hit, rung::fp32); }) == thrown::bad_call);
  CHECK(by([&] { collide(x, x, toy::box_box_hit, rung::fp64); }) == thrown::bad_call);
  catalogue none{};
  none.space = "none";
  CHECK(by([&] { find_predicate(none, "box_box"); }) == thrown::bad_call);
  pose half_a_step;
  half_a_step.grid = 0.75;
  CHECK(by([&] { prepare(of_good, toy::boxes, half_a_step); }) == thrown::bad_call);
}

TEST_CASE("errors: the element is named where it is an element's fault") {
  const float bad[] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 1};
  try {
    prepare({.data = bad, .elements = 2}, toy::boxes);
    FAIL("nothing is thrown");
  } catch (const input_error &e) {
    CHECK(e.where.element == 1);
    CHECK(e.where.kind == fault_kind::rule);
  }
}
