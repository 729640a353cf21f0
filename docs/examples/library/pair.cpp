#include <cga/triangle_triangle.hpp>
#include <cstdio>

int main() {
  const cga::triangle<float> t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const cga::triangle<float> u{{0.25F, 0.25F, 0}, {1, 1, 1}, {0, 1, 1}};
  std::printf("%s\n", cga::triangle_triangle::hit(t, u) ? "they touch" : "they are apart");
}
