#include <cell/cell.hpp>

bool arm_hits(float x) {
  return cell::ball_ball::hit({{0, 0, 0}, 1}, {{x, 0, 0}, 1});
}
