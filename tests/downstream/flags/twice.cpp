// A C library whose fma() rounds twice, as some do: linked before the real one.
#include <cmath>

extern "C" float fmaf(float a, float b, float c) noexcept {
  volatile double product = static_cast<double>(a) * static_cast<double>(b);
  return static_cast<float>(product + static_cast<double>(c));
}
extern "C" double fma(double a, double b, double c) noexcept {
  volatile double product = a * b;
  return product + c;
}
