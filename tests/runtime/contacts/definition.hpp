// The labels of a pair by their definition, in rational numbers, and the points that they name. No sign of a determinant is
// taken: a system of linear equations says where two carriers meet.
#pragma once
#include <array>
#include <gmpxx.h>
#include <vector>

namespace meetc::contacts_test {

using exact_point = std::array<mpq_class, 3>;

struct exact_label {
  int a, b; // carriers
  exact_point at;
};

// Rows of 2 or 3 corners. Sorted by b, then a. `closed` is a planted mistake: it takes carriers with their borders.
std::vector<exact_label> labels_by_definition(const float *a, int corners_a, const float *b, int corners_b,
                                              bool closed = false);

exact_point operator-(const exact_point &x, const exact_point &y);
exact_point cross(const exact_point &x, const exact_point &y);
mpq_class dot(const exact_point &x, const exact_point &y);
exact_point point_at(const float *x);
// The row has three corners.
exact_point normal_of(const float *row);
bool is_zero(const exact_point &x);

} // namespace meetc::contacts_test
