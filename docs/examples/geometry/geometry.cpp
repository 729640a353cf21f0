#include <cell/cell.hpp>
#include <cstdio>

int main() {
  const cell::sphere<float> S{{0, 0, 0}, 1};
  const cell::line<float> L{{-2, 0, 0}, {2, 0, 0}};
  const auto B = cell::meet(S, L);             // the point pair in which they cross, by its coefficients
  const float square = cell::norm2_meet(S, L); // B squared, without forming B: positive where they cross
  std::printf("square %g, coefficient of e1^n %g\n", static_cast<double>(square), static_cast<double>(B.e1_n));

  const cell::triangle<float> t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const cell::segment<float> s{{1, 0, -1}, {1, 0, 1}};
  std::printf("hit %d\n", cell::segment_triangle::hit(s, t)); // through a corner: never wrong
}
