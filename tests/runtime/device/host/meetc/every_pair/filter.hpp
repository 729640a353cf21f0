// The matrix unit on the host. Two of its filters are the extremes that its model allows: one drops every pair that it may
// drop, the other keeps every pair that it may keep.
#pragma once
#include <meetc/every_pair/table.hpp>

#include <cmath>
#include <cstring>
#include <vector>

namespace meetc::every_pair {

inline bool negative(filter by, const double *x, const double *y) {
  double sum = 0, size = 0;
  for (int k = 0; k < matrix_columns; ++k)
    sum += x[k] * y[k], size += std::fabs(x[k] * y[k]);
  const double off = 17 * 0x1p-23 * size;
  return by == filter::mma ? sum + off < 0 : sum - off < 0;
}

// Whether all padding equals the first padded element.
template <class Form> bool padded_alike(filter by, const operand &o) {
  const std::size_t first = o.elements;
  bool alike = true;
  for (std::size_t i = first + 1; i < matrix_padded(first); ++i)
    if (by == filter::float32)
      alike = alike && std::memcmp(static_cast<const float *>(o.columns) + first * (Form::products + 1),
                                   static_cast<const float *>(o.columns) + i * (Form::products + 1), float_bytes) == 0;
    else
      for (int k = 0; k < matrix_columns; ++k)
        alike = alike && static_cast<const std::uint16_t *>(o.columns)[matrix_place(first, k)] ==
                             static_cast<const std::uint16_t *>(o.columns)[matrix_place(i, k)];
  return alike;
}

template <class Form>
cudaError_t candidates(filter by, const operand &a, const operand &b, cuda::part of, cuda::pair_list out,
                       cudaStream_t) {
  // Where the part ends with the set, its padding is tested as well.
  const auto end_of = [](std::uint32_t end, const operand &o) { return end == o.elements ? end + 1 : end; };
  if (!padded_alike<Form>(by, a) || !padded_alike<Form>(by, b))
    return cudaErrorIllegalAddress;
  if (of.first_a % part_step != 0 || of.first_b % part_step != 0 || of.end_a > a.elements || of.end_b > b.elements)
    return cudaErrorInvalidValue;
  const std::uint32_t end_a = end_of(of.end_a, a), end_b = end_of(of.end_b, b);
  const auto halves_of = [](const operand &o, std::uint32_t first, std::uint32_t end) {
    std::vector<double> v;
    for (std::uint32_t i = first; i < end; ++i)
      for (int k = 0; k < matrix_columns; ++k)
        v.push_back(from_half(static_cast<const std::uint16_t *>(o.columns)[matrix_place(i, k)]));
    return v;
  };
  std::vector<double> x, y;
  if (by != filter::float32)
    x = halves_of(a, of.first_a, end_a), y = halves_of(b, of.first_b, end_b);
  for (std::uint32_t i = of.first_a; i < end_a; ++i) {
    for (std::uint32_t j = of.first_b; j < end_b; ++j) {
      const bool keep = by == filter::float32
                            ? std::signbit(bilinear<Form>(
                                  static_cast<const float *>(a.columns) + i * std::size_t{Form::products + 1},
                                  static_cast<const float *>(b.columns) + j * std::size_t{Form::products + 1}))
                            : negative(by, &x[(i - of.first_a) * std::size_t{matrix_columns}],
                                       &y[(j - of.first_b) * std::size_t{matrix_columns}]);
      if (keep && (i >= a.elements || j >= b.elements))
        return cudaErrorIllegalAddress; // padding
      if (keep) {
        if (*out.count < out.capacity)
          out.pairs[*out.count] = {i, j};
        ++*out.count;
      }
    }
    if (*out.count > out.capacity)
      return cudaSuccess;
  }
  return cudaSuccess;
}

} // namespace meetc::every_pair
