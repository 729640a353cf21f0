#!/usr/bin/env bash
# refused.sh COMPILER INCLUDE SOURCE: the compiler refuses memory of a wrong type, and its first error says what to write.
set -euo pipefail
compiler=$1 flags=(-std=c++20 -fsyntax-only -x c++ "-I$2" "-I$3/runtime/kernel" "-I$3/generated/default")
failed=0
text() {
  cat <<TEXT
#include <array>
#include <list>
#include <meet/meet.hpp>
struct half { float x, y; double z; };
struct person { std::string name; };
struct matrix { // of Eigen's interface, each column together
  using Scalar = float;
  enum { IsRowMajor = 0, RowsAtCompileTime = -1, ColsAtCompileTime = 3 };
  float *data() const; long rows() const, cols() const, innerStride() const, outerStride() const;
};
std::vector<std::array<float, 3>> points; std::vector<std::array<unsigned, 3>> faces;
std::vector<std::array<double, 3>> doubles; std::vector<std::array<std::uint64_t, 3>> wide; std::list<float> listed;
std::vector<half> halves; std::vector<person> people; matrix columns; std::vector<std::array<float, 4>> fours;
auto made() { return points; }
auto x = $1;
TEXT
}
# refused EXPRESSION TEXT: one error, which begins with "meet: " and holds the text.
refused() {
  local said
  if said=$(text "$1" | "$compiler" "${flags[@]}" - 2>&1); then
    echo "compiled: $1" && failed=1
  elif ! grep -m1 'error:' <<<"$said" | grep -qF "meet: $2"; then
    echo "$1: the first error is not 'meet: $2':" && grep 'error:' <<<"$said" && failed=1
  fi
}
text "meet::triangles(points, faces)" | "$compiler" "${flags[@]}" -
text "meet::spheres(fours)" | "$compiler" "${flags[@]}" -
refused "meet::triangles(doubles, faces)" "sets are of float, and it does not hold every double: pass meet::rounded"
refused "meet::triangles(points, wide)" "sets are of float, and indices are std::uint32_t or std::int32_t"
refused "meet::triangles(faces, faces)" "sets are of float, and indices are"
refused "meet::spheres(points)" "a row of this kind of element has another number of numbers"
refused "meet::triangles(points, fours)" "sets are of float, and indices are"
refused "meet::points(listed)" "this is neither a contiguous range with a size"
refused "meet::points(3)" "this is neither a contiguous range with a size"
refused "meet::points(halves)" "it is not known of which numbers this type is made"
refused "meet::points(people)" "it is not known of which numbers this type is made"
refused "meet::points(made())" "the container is a temporary"
refused "meet::points(columns)" "the numbers of a row must lie together"
refused "meet::unmoved(points)" "unmoved() and rounded() take doubles"
exit $failed
