// A meet, its square, and a decision that is never wrong.
#include <cell/cell.hpp>
#include <cell/cell_runtime.hpp>
#include <cstdio>

int main() {
  const cell::sphere<float> S{{0, 0, 0}, 1};
  const cell::line<float> L{{-2, 0, 0}, {2, 0, 0}};
  const cell::point_pair_blade<float> B = cell::meet(S, L);
  const float zero = B.e1_e2 * B.e1_e2 + B.e2_e3 * B.e2_e3; // the pair lies on the axis e1
  std::printf("norm2 %g %g, off the axis %g\n", double(cell::norm2_meet(S, L)),
              double(cell::norm2_meet(cell::blade(S), cell::blade(L))), double(zero));

  const cell::triangle<float> t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const cell::segment<float> touches{{1, 0, -1}, {1, 0, 1}}, misses{{1, 1, -1}, {1, 1, 1}};
  std::printf("hit %d %d\n", cell::segment_triangle::hit(touches, t), cell::segment_triangle::hit(misses, t));
  std::printf("%d predicates of %s\n", cell::catalogue().predicate_count, cell::catalogue().space);
}
