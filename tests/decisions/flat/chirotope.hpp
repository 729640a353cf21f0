// The orientation of every d + 1 of n labelled points in d-space: the signs of all their determinants, as a key.
//
// Two lists of points are in one class if they span spaces of the same dimension d and have equal keys
// there. docs/decisions.md shows that what is proved here of one member of a class holds for all.
#ifndef MEETC_TESTS_DECISIONS_CHIROTOPE_HPP
#define MEETC_TESTS_DECISIONS_CHIROTOPE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meetc::decisions_test {

using place = std::array<std::int64_t, 3>; // in d-space the coordinates from d on are zero
using points = std::vector<place>;
using labels = std::vector<int>;

constexpr int sign_of(std::int64_t v) {
  return (v > 0) - (v < 0);
}

// All increasing lists of k labels below n, in lexicographic order; computed once.
const std::vector<labels> &subsets(int n, int k);
// The index of an increasing list among them.
std::size_t index_of(int n, const labels &increasing);
// Sorts the labels. Returns the parity of the permutation as 1 or -1, or 0 if two labels are equal.
int sort_labels(labels &l);

// det (p1 - p0, ..., pd - p0) of the points with these d + 1 labels, d <= 3.
std::int64_t determinant(const points &x, const labels &of);

// One sign for each subset of d + 1 labels, in two bits each; there are at most 20.
using key = std::uint64_t;
constexpr int sign_at(key k, std::size_t i) {
  return static_cast<int>(k >> 2 * i & 3) - 1;
}
constexpr key with_sign(key k, std::size_t i, int sign) {
  return k | static_cast<key>(sign + 1) << 2 * i;
}
key chirotope_of(const points &x, int d);
key negative(key k, int n, int d);
bool spans(key k, int n, int d); // not all signs are zero
// The sign for d + 1 labels in any order.
int orientation(key k, int n, labels of);

// Whether the hulls of the first m points and of the others share a point, computed only from the key of
// points that span d-space: there is an affine dependence with coefficients >= 0 on the first and <= 0 on the
// others, and then one that is unique, up to a factor, for some d + 2 points that span.
bool hulls_meet(key k, int n, int d, int m);

} // namespace meetc::decisions_test

#endif
