// Decimals to float32 against the standard library, and what moved against integers of any length.
#include "tests/catch.hpp"

#include "meet/io/text/decimal.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace meetc::io;

namespace {

// A natural number in limbs of 32 bits, the least first.
class natural {
public:
  explicit natural(std::uint32_t n = 0) : limbs_{n} {}
  natural &times(std::uint32_t f, std::uint32_t plus = 0) {
    std::uint64_t carry = plus;
    for (std::uint32_t &limb : limbs_) {
      carry += std::uint64_t{limb} * f;
      limb = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    limbs_.push_back(static_cast<std::uint32_t>(carry));
    while (limbs_.size() > 1 && limbs_.back() == 0)
      limbs_.pop_back();
    return *this;
  }
  natural &times_power(std::uint32_t base, long n) {
    for (; n > 0; --n)
      times(base);
    return *this;
  }
  friend int compare(const natural &x, const natural &y) {
    if (x.limbs_.size() != y.limbs_.size())
      return x.limbs_.size() < y.limbs_.size() ? -1 : 1;
    for (std::size_t i = x.limbs_.size(); i-- > 0;)
      if (x.limbs_[i] != y.limbs_[i])
        return x.limbs_[i] < y.limbs_[i] ? -1 : 1;
    return 0;
  }
  // For x >= y.
  friend natural operator-(natural x, const natural &y) {
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < x.limbs_.size(); ++i) {
      std::int64_t d = std::int64_t{x.limbs_[i]} - (i < y.limbs_.size() ? y.limbs_[i] : 0) - borrow;
      borrow = d < 0;
      x.limbs_[i] = static_cast<std::uint32_t>(d);
    }
    return x.times(1);
  }
  double value() const {
    double sum = 0;
    for (std::size_t i = limbs_.size(); i-- > 0;)
      sum = sum * 0x1p32 + limbs_[i];
    return sum;
  }

private:
  std::vector<std::uint32_t> limbs_;
};

// Whether 2 |decimal - f| > 10^(the exponent of the last written digit), and |decimal - f|.
std::pair<bool, double> moved(const std::string &text, float f) {
  natural w;
  long e = 0;
  bool point = false;
  std::size_t i = text[0] == '-' || text[0] == '+' ? 1 : 0;
  for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
    if (text[i] == '.') {
      point = true;
      continue;
    }
    w.times(10, static_cast<std::uint32_t>(text[i] - '0'));
    e -= point;
  }
  if (i < text.size())
    e += std::atol(text.c_str() + i + 1);
  int q = 0;
  const auto m = static_cast<std::uint32_t>(std::ldexp(std::frexp(std::abs(f), &q), 24));
  q -= 24;
  const long down = std::max(-e, 0L), up = std::max(e, 0L), shift = m ? std::max(-q, 0) : 0;
  natural unit(1), a = w, b(m);
  unit.times_power(10, up).times_power(2, shift);
  a.times_power(10, up).times_power(2, shift);
  b.times_power(2, m ? std::max(q, 0) : 0).times_power(10, down);
  natural apart = compare(a, b) < 0 ? b - a : a - b;
  natural scale(1); // of what a, b and unit are integers of
  scale.times_power(10, down).times_power(2, shift);
  const double distance = apart.value() / scale.value();
  return {compare(apart.times(2), unit) > 0, distance};
}

float standard(const std::string &text) {
  const std::string_view t = std::string_view(text).substr(text[0] == '+');
  float f = 0;
  const auto [end, code] = std::from_chars(t.data(), t.data() + t.size(), f);
  return code == std::errc::result_out_of_range ? std::strtof(text.c_str(), nullptr) : f;
}

std::uint32_t bits(float f) {
  return std::bit_cast<std::uint32_t>(f);
}

struct counted {
  std::size_t quick = 0, all = 0, moves = 0;
};

void check(const std::string &text, bool judge_move, counted &n) {
  INFO(text);
  const float want = standard(text);
  std::string slack = text;
  slack.append(text_slack, '\n');
  float quick = 0, slow = 0;
  rounded_numbers of_quick, of_slow;
  const char *const end = read_decimal(slack.data(), quick, of_quick);
  if (!read_decimal_word(text, slow, of_slow) || bits(slow) != bits(want))
    FAIL("slow: " << slow << " not " << want);
  ++n.all;
  if (end) {
    ++n.quick;
    if (end != slack.data() + text.size() || bits(quick) != bits(want))
      FAIL("quick: " << quick << " not " << want);
    if (of_quick.numbers != of_slow.numbers || std::abs(of_quick.largest - of_slow.largest) > 1e-4 * of_slow.largest)
      FAIL("moved by " << of_quick.largest << " and " << of_slow.largest);
  }
  n.moves += of_slow.numbers;
  if (judge_move && std::isfinite(want)) {
    const auto [has, distance] = moved(text, want);
    if (has != (of_slow.numbers == 1))
      FAIL("moved: " << of_slow.numbers);
    if (has && std::isfinite(distance) && std::abs(of_slow.largest - distance) > 1e-6 * distance)
      FAIL("moved by " << of_slow.largest << " not " << distance);
  }
}

} // namespace

TEST_CASE("hostile decimals are those of the standard library, and exact integers say what moved", "[decimal]") {
  std::mt19937_64 roll(1);
  const auto below = [&](std::uint64_t n) { return static_cast<std::size_t>(roll() % n); };
  counted n;
  char text[512];
  const auto exactly = [&](double v, int digits) {
    const auto [end, code] = std::to_chars(text, text + sizeof text, v, std::chars_format::scientific, digits);
    return std::string(text, end);
  };
  constexpr int rounds = 60000;
  for (int i = 0; i < rounds; ++i) {
    const bool judge = i % 8 == 0;
    // Any digits, with a point and an exponent anywhere.
    std::string any;
    const std::size_t size = 1 + below(i % 16 == 0 ? 60 : 20), point = below(size + 1);
    for (std::size_t k = 0; k < size; ++k) {
      if (k == point)
        any += '.';
      any += static_cast<char>('0' + (i % 3 == 0 && k < size / 2 ? 0 : below(10)));
    }
    if (below(2))
      any += "e" + std::to_string(static_cast<int>(below(i % 5 == 0 ? 120 : 12)) - (i % 5 == 0 ? 70 : 6));
    check((below(4) == 0 ? "-" : "") + any, judge, n);
    // A float, the boundary above it, and a decimal just beside that boundary.
    const auto b = static_cast<std::uint32_t>(roll());
    const float f = std::bit_cast<float>(b & 0x7fffffffU);
    if (!std::isfinite(f))
      continue;
    const float next = std::nextafter(f, HUGE_VALF);
    const double boundary =
        std::isfinite(next) ? (static_cast<double>(f) + static_cast<double>(next)) / 2 : 0x1.ffffffp127;
    for (const int digits : {8, 16, 30, 120}) {
      check(exactly(static_cast<double>(f), digits), judge, n);
      std::string beside = exactly(boundary, digits);
      check(beside, judge, n);
      char &last = beside[beside.find('e') - 1];
      last = static_cast<char>(last == '9' ? '8' : last + 1);
      check(beside, judge, n);
    }
    // As coordinates are written: with few digits, large, and with the digits of a double.
    std::snprintf(text, sizeof text, "%.*f", static_cast<int>(below(8)), static_cast<double>(below(100000000)) / 64);
    check(text, judge, n);
    std::snprintf(text, sizeof text, "%.*f", static_cast<int>(below(3)), static_cast<double>(below(4000000000)) / 512);
    check(text, judge, n);
    std::snprintf(text, sizeof text, "%.17g", static_cast<double>(std::bit_cast<float>((b & 0x07ffffff) | 0x38000000)));
    check(text, judge, n);
    std::snprintf(text, sizeof text, "%.*g", static_cast<int>(6 + below(12)), static_cast<double>(b) * 0x1p-31);
    check(text, judge, n);
  }
  CHECK(n.all > 900000);
  CHECK(n.quick > n.all / 3);
  CHECK(n.moves > n.all / 10);
}

TEST_CASE("a number moves where float32 does not hold its written digits", "[decimal]") {
  const auto move = [](const char *text) {
    float f = 0;
    rounded_numbers n;
    REQUIRE(read_decimal_word(text, f, n));
    rounded_numbers quick;
    const std::string slack = std::string(text) + std::string(text_slack, '\n');
    if (read_decimal(slack.c_str(), f, quick))
      CHECK(quick.numbers == n.numbers);
    return n.numbers == 0 ? 0 : n.largest;
  };
  CHECK(move("433832.18") == Approx(0.0075));
  CHECK(move("-433832.18") == Approx(0.0075));
  CHECK(move("0.1") == 0);
  CHECK(move("0.10000000149011612") == 0); // the float32 in 17 digits
  CHECK(move("0.10000000000000000") > 0);  // the decimal in 17 digits
  CHECK(move("3000000.2") == 0);           // by half a unit exactly
  CHECK(move("3000000.20") == Approx(0.05));
  CHECK(move("16777216") == 0);
  CHECK(move("16777217") == 1);
  CHECK(move("1.6777217e7") == 1);
  CHECK(move("1e10") == 0);
  CHECK(move("12345678900") == Approx(52)); // to 12345678848
  CHECK(move("1e-60") == Approx(1e-60));
  CHECK(move("0e-60") == 0);
  CHECK(move("1e-45") == 0);
  CHECK(move("3.4028234663852886e38") == 0);
  CHECK(move("1e39") == 0); // infinite, which is an error elsewhere
  CHECK(move("0.1000000014901161193847656250000000000000000000000001") == Approx(1e-52));
}
