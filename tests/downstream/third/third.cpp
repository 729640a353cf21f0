#include <cell/cell.hpp>
#include <cell/cell_runtime.hpp>
#include <cstdio>

bool arm_hits(float x);

int main() {
  std::printf("arm %d %d, here %d, %d predicates\n", arm_hits(2), arm_hits(2.0000002f),
              cell::ball_ball::hit({{0, 0, 0}, 1}, {{2, 0, 0}, 1}), cell::catalogue().predicate_count);
}
