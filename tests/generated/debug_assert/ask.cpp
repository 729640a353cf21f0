// Asks about a ball whose radius is the argument.
#include <cga/alone/ball_ball.hpp>
#include <cstdio>
#include <cstdlib>

int main(int, char **argv) {
  const cga::sphere<float> a{{0, 0, 0}, 1}, b{{1, 0, 0}, std::strtof(argv[1], nullptr)};
  std::printf("hit %d, filter %d, fp32 %d\n", cga::ball_ball::hit(a, b), static_cast<int>(cga::ball_ball::filter(a, b)),
              cga::ball_ball::plain<float>(a, b));
}
