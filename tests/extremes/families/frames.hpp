// Orthogonal frames of integers, so that perpendicular vectors are exactly perpendicular.
#ifndef MEETC_TESTS_EXTREMES_FRAMES_HPP
#define MEETC_TESTS_EXTREMES_FRAMES_HPP

#include "subjects.hpp"

#include <array>

namespace meetc::extremes_test {

using integer_point = std::array<long, 3>;

// Three orthogonal integer vectors of one integer length: the rotation of a quaternion of integers.
struct frame {
  integer_point x, y, z;
  long length;
};
inline frame any_frame(int most, random_numbers &random) {
  long w = 1, x = 0, y = 0, z = 0; // the axes themselves
  if (!random.one_in(4))
    do
      for (long *c : {&w, &x, &y, &z})
        *c = random.integer(-most, most);
    while (w * w + x * x + y * y + z * z == 0);
  return {{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
          {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
          {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z},
          w * w + x * x + y * y + z * z};
}
inline integer_point in(const frame &f, long i, long j, long k) {
  integer_point out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = i * f.x[c] + j * f.y[c] + k * f.z[c];
  return out;
}

} // namespace meetc::extremes_test

#endif
