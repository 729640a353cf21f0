// The same headers in another order, in another unit.
#include <cell/cell.hpp>
#include <odd/odd.hpp>
#include <other/other.hpp>

int second() {
  return cell::ball_ball::hit({{0, 0, 0}, 1}, {{2, 0, 0}, 1}) +
         2 * other::ball_ball::hit({{0, 0, 0}, 1}, {{3, 0, 0}, 1});
}
