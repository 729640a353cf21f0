#include "cases.h"

#include <array>
#include <bit>
#include <cell/cell.hpp>
#include <cmath>
#include <cstdio>

template <class T> T taken() {
  std::array<float, sizeof(T) / sizeof(float)> numbers;
  fill(numbers.data(), static_cast<int>(numbers.size()));
  return std::bit_cast<T>(numbers);
}

template <class P, class A, class B> void print_answers(const A &a, const B &b) {
  std::printf("%d%d%d%d%d ", P::template plain<float>(a, b), P::template plain<double>(a, b),
              P::template plain<meetc::double_double>(a, b), P::hit(a, b), static_cast<int>(P::filter(a, b)));
}

int main() {
  for (int i = 0; i < cases; ++i) {
    const auto A = taken<cell::triangle<float>>(), B = taken<cell::triangle<float>>();
    const auto s = taken<cell::segment<float>>();
    auto S = taken<cell::sphere<float>>();
    const auto L = taken<cell::line<float>>();
    S.r = std::fabs(S.r);
    const cell::sphere<double> Sd{{S.c.x, S.c.y, S.c.z}, S.r};
    const cell::line<double> Ld{{L.p.x, L.p.y, L.p.z}, {L.q.x, L.q.y, L.q.z}};
    const auto b = cell::meet(S, L);
    std::printf("%a %a %a %a ", static_cast<double>(b.e1_n), static_cast<double>(b.e2_e3),
                static_cast<double>(cell::norm2_meet(S, L)), cell::norm2_meet(Sd, Ld));
    std::printf("%d%d%d%d ", static_cast<int>(cell::side_plain<float>(A, B.a)),
                static_cast<int>(cell::side_plain<double>(A, B.a)),
                static_cast<int>(cell::side_plain<meetc::double_double>(A, B.a)), static_cast<int>(cell::side(A, B.a)));
    print_answers<cell::segment_triangle>(s, A);
    print_answers<cell::triangle_triangle>(A, B);
    print_answers<cell::ball_triangle>(S, A);
    std::printf("%d\n", cell::valid(S));
  }
}
