// Headers only. Segments through a far, thin triangle, whose common grid makes the right answer known: the piercing
// point is (i + d)/n along an edge, d = -1, 0 or 1 units in the last place, on the edge or next to it.
#include <cell/cell.hpp>
#include <cell/header_only.hpp>
#include <cmath>
#include <cstdio>

int main() {
  const cell::sphere<float> S{{0, 0, 0}, 1};
  const cell::line<float> L{{-2, 0, 0}, {2, 0, 0}};
  int wrong = 0, cases = 0;
  const cell::triangle<float> t{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}}; // below the diagonal y = x
  for (int i = 1; i <= 10000; ++i)
    for (int above = 0; above < 2; ++above) {
      const float x = static_cast<float>(i) / 16384;
      const float y = above ? std::nextafter(x, 2.0f) : x; // on the diagonal, or the next number above it
      const cell::segment<float> s{{x, y, -1e-30f}, {x, y, 1e10f}};
      wrong += cell::segment_triangle::hit(s, t) != !above;
      ++cases;
    }
  std::printf("norm2 %g, %d wrong of %d\n", static_cast<double>(cell::norm2_meet(S, L)), wrong, cases);
}
