#include "tests/catch.hpp"

#include "meet/io/text/number.hpp"
#include <meetc/environment/control_word.hpp>

#include <cfenv>
#include <clocale>
#include <cmath>
#include <limits>
#include <string>

using namespace meetc::io;

namespace {

float direct(std::string_view text) {
  double v = 0;
  REQUIRE(parse_decimal(text, precision::float32, v));
  return to_float32(v);
}
double as_double(std::string_view text) {
  double v = 0;
  REQUIRE(parse_decimal(text, precision::float64, v));
  return v;
}

} // namespace

TEST_CASE("decimals round once to float32", "[number]") {
  CHECK(direct("0.1") == 0.1F);
  CHECK(direct("+2.5e-3") == 2.5e-3F);
  CHECK(direct("-.5") == -0.5F);
  CHECK(direct("5.") == 5.0F);
  CHECK(std::signbit(direct("-0")));
  // Just above the midpoint of 1 and the next float32. Through double it would become the tie and round to 1.
  const char *const above_tie = "1.000000059604644775390625000001";
  CHECK(direct(above_tie) == 0x1.000002p0F);
  CHECK(to_float32(as_double(above_tie)) == 1.0F);
}

TEST_CASE("the ends of the range round as IEEE 754 says", "[number]") {
  const float smallest = std::numeric_limits<float>::denorm_min();
  CHECK(direct("1.401298464324817e-45") == smallest);
  CHECK(direct("0.7006492321624086e-45") == smallest);
  CHECK(direct("0.7006492321624085e-45") == 0.0F);
  CHECK(direct("1e-400") == 0.0F);
  CHECK(std::signbit(direct("-1e-400")));
  CHECK(direct("1.1754942e-38") == 0x1.fffffcp-127F);
  CHECK(as_double("4.9e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(as_double("1e-400") == 0.0);
  CHECK(std::isinf(as_double("1e400")));
  CHECK(as_double("-1e400") == -std::numeric_limits<double>::infinity());
  CHECK(direct("3.4028235e38") == std::numeric_limits<float>::max());
  CHECK(direct("340282356779733661637539395458142568448") == std::numeric_limits<float>::infinity()); // the tie
  CHECK(direct("340282356779733661637539395458142568447") == std::numeric_limits<float>::max());
  CHECK(direct("-1e39") == -std::numeric_limits<float>::infinity());
  CHECK(std::isinf(direct("1e4000")));
}

TEST_CASE("to_float32 rounds to nearest, ties to even, and overflows to infinity", "[number]") {
  CHECK(to_float32(0x1.000001p0) == 1.0F);
  CHECK(to_float32(0x1.000003p0) == 0x1.000004p0F);
  CHECK(to_float32(0x1.fffffefffffffp127) == std::numeric_limits<float>::max());
  CHECK(to_float32(0x1.ffffffp127) == std::numeric_limits<float>::infinity());
  CHECK(to_float32(-1e300) == -std::numeric_limits<float>::infinity());
  CHECK(std::isnan(to_float32(std::numeric_limits<double>::quiet_NaN())));
}

TEST_CASE("a word that is not a decimal number is refused whole", "[number]") {
  double v = 0;
  for (const char *const text :
       {"", "+", "-", "+-1", "++1", "0x10", "1x", "1 ", " 1", "1,5", "e5", ".", "1e", "--1", "1e+", "1.2.3", "one"})
    for (const precision p : {precision::float32, precision::float64}) {
      INFO(text);
      CHECK_FALSE(parse_decimal(text, p, v));
    }
  CHECK_FALSE(parse_decimal(std::string_view("1\0", 2), precision::float32, v));
}

TEST_CASE("integers are whole and fit", "[number]") {
  std::int64_t n = 0;
  CHECK(parse_integer("+12", n));
  CHECK(n == 12);
  CHECK(parse_integer("-3", n));
  CHECK(n == -3);
  for (const char *const text : {"", "1.0", "0x1", "+-1", "9223372036854775808", "1e3"})
    CHECK_FALSE(parse_integer(text, n));
}

TEST_CASE("the locale does not matter", "[number]") {
  // Where no such locale is installed, this repeats the plain test.
  const char *const set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(direct("1.5") == 1.5F);
  CHECK(direct("1e-46") == 0.0F);
  CHECK(as_double("4.9e-324") > 0.0);
  if (set)
    std::setlocale(LC_ALL, "C");
}

TEST_CASE("a direction of rounding that only the x87 unit has does not matter", "[number]") {
  std::fenv_t before;
  std::fegetenv(&before);
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    meetc::set_control_word(meetc::plain_control_word); // as the guard of an entry does
    const float numbers[] = {direct("0.7006492321624085e-45"), direct("-0.7006492321624085e-45"),
                             direct("3.4028235677973367e38"),  direct("-3.4028235677973367e38"),
                             direct("1.1754942e-38"),          direct("1.000000059604644775390625000001")};
    const double doubles[] = {as_double("2.4703282292062327e-324"), as_double("1.7976931348623159e308"),
                              as_double("1e-400"), as_double("-1e400")};
    std::fesetenv(&before);
    INFO(mode);
    CHECK((numbers[0] == 0 && !std::signbit(numbers[0])));
    CHECK((numbers[1] == 0 && std::signbit(numbers[1])));
    CHECK(numbers[2] == std::numeric_limits<float>::infinity());
    CHECK(numbers[3] == -std::numeric_limits<float>::infinity());
    CHECK(numbers[4] == 0x1.fffffcp-127F);
    CHECK(numbers[5] == 0x1.000002p0F);
    CHECK(doubles[0] == 0);
    CHECK(doubles[1] == std::numeric_limits<double>::infinity());
    CHECK(doubles[2] == 0);
    CHECK(doubles[3] == -std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("whether a number is too large or too small follows from all of its text", "[number]") {
  const std::string zeros(500, '0');
  CHECK(direct("0." + zeros + "1e490") == 1e-11F);
  CHECK(direct("0." + zeros + "1e600") == std::numeric_limits<float>::infinity());
  CHECK(direct("-0." + zeros + "1e420") == 0);
  CHECK(direct("1" + zeros + "e-400") == std::numeric_limits<float>::infinity());
  CHECK(direct("1" + zeros + "e-490") == 1e10F);
  CHECK(direct("1" + zeros + ".5e-600") == 0);
  CHECK(direct("-" + zeros + "123." + zeros + "e+40") == -std::numeric_limits<float>::infinity());
  for (const char *const much : {"1e99999999999999999999", "+.1E+99999999999999999999", "1e2147483648"})
    CHECK(direct(much) == std::numeric_limits<float>::infinity());
  for (const char *const little : {"1e-99999999999999999999", "+.1E-99999999999999999999", "1e-2147483648"}) {
    CHECK(direct(little) == 0);
    CHECK(as_double(little) == 0);
  }
  CHECK(direct("0e99999999999999999999") == 0);
}
