// A user's program with any flags: batches of inputs near zero through the headers' certified rungs, in loops
// that a compiler may vectorise, against integers. Nothing that is certified may be wrong.
//
//   hostile            as the process is
//   hostile modes      and once more in every rounding mode
#include <cga/cga.hpp>

#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

namespace {

std::mt19937_64 engine(7);
int any(int low, int high) {
  return low + static_cast<int>(engine() % static_cast<std::uint64_t>(high - low + 1));
}
float nudged(float x) {
  const int steps = any(-1, 1);
  return steps > 0 ? meet::step_up(x) : steps < 0 ? meet::step_down(x) : x;
}

// n pairs of rows: all points of both operands in one plane or line of a grid, or equal, or a tangent pair of
// spheres; some numbers then moved to a neighbour; at many scales, subnormal numbers among them. No
// arithmetic of this function decides what is right.
void make_rows(int inputs_a, int inputs_b, std::size_t n, std::vector<float> &a, std::vector<float> &b) {
  const int inputs = inputs_a + inputs_b;
  for (std::size_t k = 0; k < n; ++k) {
    float row[32];
    const int family = any(0, 5);
    float origin[3], u[3], v[3];
    for (int i = 0; i < 3; ++i) {
      origin[i] = static_cast<float>(any(-0xfffff, 0xfffff)) * (family == 1 ? 0x1p-20F : 1);
      u[i] = static_cast<float>(any(-4096, 4096)) + (family == 2 ? 0.1F : 0);
      v[i] = static_cast<float>(any(-4096, 4096)) * (family == 2 ? 0.3F : 1);
    }
    float s = 0, t = 0;
    for (int i = 0; i < inputs; ++i) {
      // Points begin at multiples of 3; spheres (4 numbers) put a radius there, which does no harm.
      if (i % 3 == 0) {
        s = static_cast<float>(any(-16, 16)) / 16;
        t = family == 3 ? 0 : static_cast<float>(any(-16, 16)) / 16;
      }
      row[i] = origin[i % 3] + s * u[i % 3] + t * v[i % 3];
      if (family == 4 && i >= 3 && any(0, 1))
        row[i] = row[i - 3];
      if (any(0, 7) == 0)
        row[i] = nudged(row[i]);
    }
    if (inputs_a == 4) { // a sphere that touches, or nearly: a multiple of a Pythagorean triple away
      const float step = static_cast<float>(any(1, 1 << 18));
      row[0] = row[4] + 3 * step, row[1] = row[5] + 4 * step, row[2] = row[6] + (any(0, 1) ? 12 * step : 0);
      row[3] = static_cast<float>(any(0, 13)) * step;
      if (inputs_b == 4)
        row[7] = static_cast<float>(any(0, 13)) * step;
      row[3] = std::fabs(nudged(row[3]));
    }
    const int scales[] = {0, 0, 0, -40, 20, -140, -110};
    const int scale = scales[any(0, 6)];
    for (int i = 0; i < inputs; ++i)
      row[i] = std::ldexp(row[i], scale);
    a.insert(a.end(), row, row + inputs_a);
    b.insert(b.end(), row + inputs_a, row + inputs);
  }
}

struct tally {
  long cases = 0, certified = 0, wrong = 0, hit_wrong = 0;
} total;
bool bounded_rungs_too = true; // they are for standard_environment() alone

template <class P> void check_decisions() {
  constexpr std::size_t n = 20000;
  std::vector<float> a, b;
  make_rows(P::inputs_a, P::inputs_b, n, a, b);
  const auto row_a = [&](std::size_t i) { return a.data() + i * P::inputs_a; };
  const auto row_b = [&](std::size_t i) { return b.data() + i * P::inputs_b; };
  std::vector<unsigned char> truth(n), hit(n);
  for (std::size_t i = 0; i < n; ++i)
    truth[i] = meet::decide<P>(meet::integer_signs<P>(row_a(i), row_b(i)));
  for (std::size_t i = 0; i < n; ++i)
    hit[i] = meet::decide_certified<P>(row_a(i), row_b(i));
  std::vector<meet::answer> answers[5];
  for (auto &one : answers)
    one.assign(n, meet::answer::unsure);
  if (bounded_rungs_too) {
    // Each pair in its own box, the least power of two that holds its differences and lengths.
    std::vector<float> side(n);
    for (std::size_t i = 0; i < n; ++i) {
      float most = 0;
      for (int k = 0; k < P::inputs_a; ++k)
        most = std::fmax(most, std::fabs(row_a(i)[k]));
      for (int k = 0; k < P::inputs_b; ++k)
        most = std::fmax(most, std::fabs(row_b(i)[k]));
      side[i] = meet::power_above(2 * most);
    }
    for (std::size_t i = 0; i < n; ++i)
      answers[0][i] = meet::certify<P, meet::in_fp32>(row_a(i), row_b(i));
    for (std::size_t i = 0; i < n; ++i)
      answers[1][i] = meet::certify<P, meet::in_fp64>(row_a(i), row_b(i));
    for (std::size_t i = 0; i < n; ++i)
      answers[2][i] = meet::certify<P, meet::in_fp64x2>(row_a(i), row_b(i));
    for (std::size_t i = 0; i < n; ++i)
      if (meet::box_holds<P>(side[i])) {
        using meet::box_form;
        using meet::boxed_signs;
        answers[3][i] =
            meet::decide_sets<P>(boxed_signs<P, box_form::per_object>(row_a(i), row_b(i), side[i]));
        answers[4][i] =
            meet::decide_sets<P>(boxed_signs<P, box_form::whole_box>(row_a(i), row_b(i), side[i]));
      }
  }
  for (std::size_t i = 0; i < n; ++i) {
    ++total.cases;
    total.hit_wrong += hit[i] != truth[i];
    for (const auto &one : answers) {
      total.certified += one[i] != meet::answer::unsure;
      total.wrong += one[i] == (truth[i] ? meet::answer::no : meet::answer::yes);
    }
  }
}

template <class P> void check_signs() {
  constexpr std::size_t n = 40000;
  std::vector<float> a, b;
  make_rows(P::inputs_a, P::inputs_b, n, a, b);
  std::vector<meet::sign_set> fp32(n, meet::sign_set::all()), fp64 = fp32;
  std::vector<meet::sign> sign(n);
  if (bounded_rungs_too) {
    for (std::size_t i = 0; i < n; ++i)
      fp32[i] = meet::certify_sign<P, meet::in_fp32>(&a[i * P::inputs_a], &b[i * P::inputs_b]);
    for (std::size_t i = 0; i < n; ++i)
      fp64[i] = meet::certify_sign<P, meet::in_fp64>(&a[i * P::inputs_a], &b[i * P::inputs_b]);
  }
  for (std::size_t i = 0; i < n; ++i)
    sign[i] = meet::decide_certified_sign<P>(&a[i * P::inputs_a], &b[i * P::inputs_b]);
  for (std::size_t i = 0; i < n; ++i) {
    const meet::sign truth =
        meet::decide_sign<P>(meet::integer_signs<P>(&a[i * P::inputs_a], &b[i * P::inputs_b]));
    ++total.cases;
    total.hit_wrong += sign[i] != truth;
    for (const meet::sign_set s : {fp32[i], fp64[i]}) {
      total.certified += s.bits != 7;
      total.wrong += !(s.bits & meet::sign_set::of(truth).bits);
    }
  }
}

// Error-free transforms on arrays, fed with products and sums that a compiler would like to fuse.
long inexact_transforms() {
  constexpr std::size_t n = 100000;
  std::vector<double> x(n), y(n), z(n), sum(n), rest(n), product(n), low(n);
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = static_cast<double>(any(-0x3fffffff, 0x3fffffff)) * 0x1p22 + any(0, 0x3fffff);
    y[i] = static_cast<double>(any(-0x3fffffff, 0x3fffffff)) * 0x1p22 + any(0, 0x3fffff);
    z[i] = any(0, 1) ? -(x[i] * y[i])
                     : static_cast<double>(any(-0x3fffffff, 0x3fffffff)) * std::ldexp(1.0, any(0, 60));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const meet::double_double s = meet::two_sum(x[i] * y[i], z[i]);
    sum[i] = s.hi, rest[i] = s.lo;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const meet::double_double p = meet::two_product(x[i], y[i]);
    product[i] = p.hi, low[i] = p.lo;
  }
  long wrong = 0;
  for (std::size_t i = 0; i < n; ++i) {
    using meet::int128;
    const volatile double rounded = x[i] * y[i];
    wrong += static_cast<int128>(sum[i]) + static_cast<int128>(rest[i]) !=
             static_cast<int128>(rounded) + static_cast<int128>(z[i]);
    wrong += static_cast<int128>(product[i]) + static_cast<int128>(low[i]) !=
             static_cast<int128>(x[i]) * static_cast<int128>(y[i]);
  }
  return wrong;
}

void check_all() {
  check_decisions<cga::ball_ball>();
  check_decisions<cga::sphere_sphere>();
  check_decisions<cga::ball_segment>();
  check_decisions<cga::segment_segment>();
  check_decisions<cga::segment_triangle>();
  check_signs<cga::side_sphere_point_sign>();
  check_signs<cga::side_triangle_point_sign>();
  check_signs<cga::twist_segment_segment_sign>();
}

} // namespace

int main(int argc, char **argv) {
  const bool standard = meet::standard_environment();
  const unsigned faults = meet::self_test();
  std::printf("standard %d, faults %u: %s\n", standard, faults, meet::text_of_faults(faults));
  bounded_rungs_too = standard;
  check_all();
  std::printf("%ld cases, %ld certified, %ld certified wrong, %ld hits wrong\n", total.cases, total.certified,
              total.wrong, total.hit_wrong);
  if (standard)
    std::printf("%ld transforms inexact\n", inexact_transforms());
  if (argc > 1 && std::strcmp(argv[1], "modes") == 0) {
    total = {};
    bounded_rungs_too = false;
    int seen = 0;
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      seen +=
          !meet::standard_environment() && (meet::self_test() & static_cast<unsigned>(meet::arithmetic_fault::rounding));
      check_all();
      std::fesetround(FE_TONEAREST);
    }
    std::printf("%d modes noticed, %ld hits wrong\n", seen, total.hit_wrong);
  }
}
