// Turns a sphere by a quarter about the z axis, moves it by 3 along x, and reads back where it is.
#include <cstdio>
#include <moving/moving.hpp>

int main() {
  const moving::motor<double> turn{1, 0, 0, -1, 0, 0, 0, 0}, shift{1, 0, 0, 0, 3, 0, 0, 0};
  const auto both = moving::product(shift, turn); // the turn comes first
  const moving::sphere<double> ball{{1, 0, 0}, 0.5};
  const auto found = moving::gives(moving::move(both, ball)); // at twice its weight, which the quotients take out
  std::printf("centre %g %g %g, radius %g\n", found.centre.x, found.centre.y, found.centre.z, found.radius);

  double at[12]; // the same motion as a matrix, row by row
  moving::pose(both, at);
  for (int row = 0; row < 3; ++row)
    std::printf("%2g %2g %2g %2g\n", at[4 * row] + 0, at[4 * row + 1] + 0, at[4 * row + 2] + 0, at[4 * row + 3] + 0);
}
