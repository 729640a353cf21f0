#include <cell/norm2_meet_sphere_line.hpp>
#include <cstdio>

int main() {
  std::printf("norm2 %g\n",
              double(cell::norm2_meet(cell::sphere<>{{0, 0, 0}, 1}, cell::line<>{{-2, 0, 0}, {2, 0, 0}})));
}
