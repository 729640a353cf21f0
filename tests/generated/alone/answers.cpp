// Answers of one predicate, by its own header or by that of all: a bit for each pair, then the pairs that fp32 leaves unsure.
#if defined(ALONE)
#include <cga/alone/triangle_triangle.hpp>
#else
#include <cga/header_only.hpp>
#endif
#include <cstdio>
#include <random>

int main() {
  std::mt19937 engine(7);
  // Small lattices, where half of the pairs are degenerate, at scales and distances at which fp32 knows few signs.
  const float steps[] = {1, 0x1p-40F, 0x1.8p60F, 1 + 0x1p-23F}, origins[] = {0, 1, 0x1p20F, 3};
  unsigned unsure = 0, pairs = 0;
  for (int scale = 0; scale < 4; ++scale)
    for (int i = 0; i < 2000; ++i, ++pairs) {
      cga::triangle<float> of[2];
      for (cga::triangle<float> &t : of)
        for (cga::point<float> *const p : {&t.a, &t.b, &t.c})
          for (float *const x : {&p->x, &p->y, &p->z})
            *x = origins[scale] * steps[scale] + static_cast<float>(engine() % 4) * steps[scale];
      unsure += cga::triangle_triangle::filter(of[0], of[1]) == meetc::answer::unsure ? 1 : 0;
      std::putchar(cga::triangle_triangle::hit(of[0], of[1]) ? '1' : '0');
    }
  std::printf("\n%u of %u pairs are unsure in fp32\n", unsure, pairs);
}
