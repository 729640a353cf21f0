// The width of the exact rung's integers: what a stage claims (degree, growth) holds for every value that it computes,
// and the rung never runs a stage in integers that are too narrow for that.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/numbers.hpp"
#include "tests/generated/judge/predicates.hpp"

#include <cmath>

using namespace meetc::generated_test;

namespace {

template <class P, class Stage> std::size_t widest_of(const std::vector<mpz_class> &inputs) {
  counted_integer a[P::inputs_a], b[P::inputs_b];
  for (std::size_t i = 0; i < inputs.size(); ++i)
    (i < P::inputs_a ? a[i] : b[i - P::inputs_a]) = counted_integer(inputs[i]);
  counted_integer::widest = 0;
  counted_integer v[Stage::atoms];
  meetc::stage_values<Stage>(a, b, v);
  return counted_integer::widest;
}

// The largest numbers of `bits` bits with random signs and zeros, followed by climbing: a change of one number is kept
// if values do not get narrower. Random numbers as well.
template <class P, class Stage> void check_growth(const char *predicate, const char *stage) {
  if constexpr (Stage::atoms > 0) {
    constexpr std::size_t inputs = P::inputs_a + P::inputs_b;
    random_numbers random(inputs);
    for (const unsigned bits : {1U, 2U, 3U, 24U, 25U, 40U, 62U, 128U, 277U}) {
      INFO(predicate << ", " << stage << " stage, inputs of " << bits << " bits");
      const std::size_t most = static_cast<std::size_t>(Stage::degree) * bits + Stage::growth;
      const mpz_class top = (mpz_class(1) << bits) - 1;
      std::size_t seen = 0;
      for (int i = 0; i < effort(120); ++i) {
        std::vector<mpz_class> v(inputs);
        for (mpz_class &c : v)
          c = random.integer(-1, 1) * top;
        std::size_t best = widest_of<P, Stage>(v);
        for (int climb = 0; climb < 20; ++climb) {
          mpz_class &c = v[static_cast<std::size_t>(random.bits() % inputs)];
          const mpz_class before = c;
          c = random.one_in(5) ? mpz_class(top - random.integer(0, 1)) : mpz_class(random.integer(-1, 1) * top);
          if (const std::size_t now = widest_of<P, Stage>(v); now >= best)
            best = now;
          else
            c = before;
        }
        seen = std::max(seen, best);
      }
      CHECK(seen <= most);
      // The claim is not so generous that it would hide a mistake. (The smallest inputs never come close to it.)
      if (bits > 3)
        CHECK(seen + 6 >= most);
    }
  }
}

// A stage whose only value is a^Degree; its sign is wrong in integers that are too narrow. It records the widths of the
// built-in integers in which it runs: that of values up to degree 2, and that of the others.
int width_used = 0, width_of_squares = 0;
template <int Degree, int Growth, bool Mixed> struct probe_stage {
  static constexpr int first = 0, atoms = 1, fields_a = 0, fields_b = 0, degree = Degree, growth = Growth;
  static constexpr bool mixed = Mixed;
  template <class T, class W> static void pair(const T *a, const T *, const T *, const T *, W *v) {
    width_of_squares = static_cast<int>(sizeof(T)) * 8;
    width_used = static_cast<int>(sizeof(W)) * 8;
    const T low = Degree > 1 ? a[0] * a[0] : a[0];
    v[0] = W(low);
    for (int i = 2; i < Degree; ++i)
      v[0] = v[0] * W(a[0]);
  }
  // Registers 2 and 3 alternate; the last instruction takes the sign.
  using bytecode = probe_stage;
  static constexpr int registers = 4, instruction_count = Degree;
  static meetc::instruction instruction_at(int i) {
    const auto place = [](int k) { return static_cast<std::uint16_t>(k == 0 ? 0 : 2 + k % 2); };
    if (i + 1 < Degree)
      return {meetc::opcode::multiply, place(i + 1), place(i), 0};
    return {meetc::opcode::take_sign, 0, place(i), 0};
  }
};
template <class Stage> struct probe {
  static constexpr int inputs_a = 1, inputs_b = 1, atoms = 1;
  static constexpr int axis(int) { return -1; }
  using reject_stage = meetc::no_stage;
  using common_stage = Stage;
  using rare_stage = meetc::no_stage;
  static bool rejected(const meetc::sign *) { return false; }
  static bool needs_rare(const meetc::sign *) { return false; }
  static bool usual(const meetc::sign *s) { return meetc::in<4>(s[0]); }
  static bool whole(const meetc::sign *s) { return usual(s); }
};

template <int Degree, int Growth, bool Mixed = false> void check_steps() {
  using stage = probe_stage<Degree, Growth, Mixed>;
  bool fits = true, lean = true, right = true, narrow = false;
  for (int bits = 1; bits <= 277; ++bits) {
    const int low = bits <= 200 ? -100 : -149;
    const float b = std::ldexp(1.0F, low);
    for (const float sign : {1.0F, -1.0F}) {
      // The largest magnitude of this many bits in float32.
      const float a =
          sign * (bits <= 24 ? std::ldexp(1.0F, low + bits) - b : std::ldexp(0x1.fffffep0F, low + bits - 1));
      width_used = width_of_squares = 0;
      right = right &&
              meetc::decide<probe<stage>>(meetc::integer_signs<probe<stage>>(&a, &b)) == (sign > 0 || Degree % 2 == 0);
      const int need = Degree * bits + Growth;
      fits = fits && (width_used == 0 || // and a sign bit
                      (need <= width_used - 1 && std::min(Degree, 2) * bits + Growth <= width_of_squares - 1));
      narrow = narrow || width_of_squares < width_used;
      lean = lean && (need > 62 || width_used == 64) && (need > 126 || (width_used > 0 && width_used <= 128));
    }
  }
  INFO("degree " << Degree << ", growth " << Growth);
  CHECK(right);
  CHECK(fits);
  CHECK(lean);
  CHECK(narrow == Mixed);
}

// Whether integers on differences, where they are shorter than the numbers, have the signs of integers on the numbers.
template <class P, class Stage>
bool same_on_differences(const row &a, const row &b, const meetc::integer_signs<P> &numbers, int &shorter) {
  if constexpr (Stage::atoms > 0) {
    const int low = numbers.common.low;
    const meetc::integer_signs<P> differences(a.data(), b.data(), numbers.common,
                                              meetc::spread<P>(a.data(), b.data()) - low);
    shorter += differences.template need<Stage>() <= 126 && numbers.template need<Stage>() > 126;
    meetc::sign x[P::atoms], y[P::atoms];
    differences.template get<Stage>(x);
    numbers.template get<Stage>(y);
    return std::equal(x + Stage::first, x + Stage::first + Stage::atoms, y + Stage::first);
  }
  return true;
}

} // namespace

TEST_CASE("integer widths: differences that are shorter than the numbers give the same signs") {
  for_each_predicate([](auto p) {
    using P = typename decltype(p)::type;
    INFO(p.name);
    random_numbers random(5);
    int shorter = 0;
    bool same = true;
    for (int i = 0; i < effort(3000); ++i) {
      // Far along the first axis, in coarse steps or none, and fine along the others.
      const int fine = random.integer(-45, -8), steps = random.one_in(2) ? 40 : 0;
      row a(P::inputs_a), b(P::inputs_b);
      for (int k = 0; k < P::inputs_a + P::inputs_b; ++k) {
        float &v = k < P::inputs_a ? a[static_cast<std::size_t>(k)] : b[static_cast<std::size_t>(k - P::inputs_a)];
        v = P::axis(k) == 0 ? 0x1p20F + 0.125F * static_cast<float>(random.integer(0, steps))
                            : std::ldexp(static_cast<float>(random.integer(0, 40)), fine);
      }
      const meetc::integer_signs<P> numbers(a.data(), b.data());
      same = same && same_on_differences<P, typename P::reject_stage>(a, b, numbers, shorter) &&
             same_on_differences<P, typename P::common_stage>(a, b, numbers, shorter) &&
             same_on_differences<P, typename P::rare_stage>(a, b, numbers, shorter);
    }
    CHECK(same);
    CHECK(
        (p.a == shape::box || shorter > effort(3000) / 30)); // the test can fail; a comparison needs no shorter numbers
  });
}

TEST_CASE("integer widths: no value of a stage is wider than it claims") {
  for_each_predicate([](auto p) {
    using P = typename decltype(p)::type;
    check_growth<P, typename P::reject_stage>(p.name, "reject");
    check_growth<P, typename P::common_stage>(p.name, "common");
    check_growth<P, typename P::rare_stage>(p.name, "rare");
  });
}

TEST_CASE("integer widths: a stage always runs in integers that hold it") {
  check_steps<1, 0>();
  check_steps<2, 3>();
  check_steps<2, 6>();
  check_steps<3, 6>();
  check_steps<3, 6, true>();
  check_steps<4, 9>();
  check_steps<6, 13>();
  check_steps<4, 9, true>();
  check_steps<8, 20>();
}
