// A user's own kernel that calls the headers.
#include <cell/cell.hpp>

__global__ void touching(const cell::sphere<float> *a, const cell::sphere<float> *b, float *norm, bool *hit, int n) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i >= n)
    return;
  hit[i] = cell::ball_ball::hit(a[i], b[i]);
  norm[i] = cell::norm2_meet(a[i], cell::line<float>{b[i].c, a[i].c});
}
