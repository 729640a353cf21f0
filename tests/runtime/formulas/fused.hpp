// A number on which emitted formulas fuse as they do in the lanes of AVX2 and AVX-512 and on a device, whatever this program
// is compiled for. Include this before any emitted header.
#ifndef MEETC_TESTS_RUNTIME_FORMULAS_FUSED_HPP
#define MEETC_TESTS_RUNTIME_FORMULAS_FUSED_HPP

#include <meetc/support.hpp>

#include <cmath>
#include <type_traits>

namespace meetc {

template <class Number> struct fused {
  Number v;
  fused() = default;
  template <class From> explicit fused(From x) : v(static_cast<Number>(x)) {}
};
template <class N> fused<N> operator-(fused<N> a) {
  return fused<N>(-a.v);
}
template <class N> fused<N> operator+(fused<N> a, fused<N> b) {
  return fused<N>(a.v + b.v);
}
template <class N> fused<N> operator-(fused<N> a, fused<N> b) {
  return fused<N>(a.v - b.v);
}
template <class N> fused<N> operator*(fused<N> a, fused<N> b) {
  return fused<N>(a.v * b.v);
}
template <class N> fused<N> operator/(fused<N> a, fused<N> b) {
  return fused<N>(a.v / b.v);
}
template <class N> fused<N> multiply_add(fused<N> a, fused<N> b, fused<N> c) {
  return fused<N>(std::fma(a.v, b.v, c.v));
}

} // namespace meetc

#endif
