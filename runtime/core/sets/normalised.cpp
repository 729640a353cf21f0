#include "meet/core/sets/normalised.hpp"

#include <cmath>
#include <cstring>
#include <new>

namespace meetc {
namespace {

// Whether all n products with 2^power are exact.
bool multiply(const float *from, std::size_t n, int power, float *to, const execution &on) {
  const double factor = std::ldexp(1.0, power), inverse = std::ldexp(1.0, -power);
  std::uint32_t different = 0;
  for_strips(on, n, [&](std::size_t begin, std::size_t end) {
    std::uint32_t here = 0;
    for (std::size_t i = begin; i < end; ++i) {
      to[i] = static_cast<float>(from[i] * factor);
      const auto back = static_cast<float>(to[i] * inverse);
      std::uint32_t x, y;
      std::memcpy(&x, from + i, sizeof x);
      std::memcpy(&y, &back, sizeof y);
      here |= x ^ y;
    }
    different |= here;
  });
  return different == 0;
}

std::shared_ptr<const normalised_set> multiplied(const element_set &set, int power, const execution &on) {
  const std::size_t n = set.elements * static_cast<std::size_t>(set.kind->fields);
  std::unique_ptr<float[]> rows(new (std::nothrow) float[n]);
  if (!rows || !multiply(set.rows, n, power, rows.get(), on))
    return nullptr;
  auto result = std::make_shared<normalised_set>(normalised_set{std::move(rows), set, stored_table(*set.kind)});
  result->set.rows = result->rows.get();
  return result;
}

} // namespace

// Polynomials have degree 6 at most in the shipped predicates, and edges are often a thousandth of their set: where the
// largest number is from 1 to 2^16, products of six differences stay below 2^103, and those of edges above 2^-60. Sets
// from 2^-8 to 2^20 are left alone, since most sets are of that size and a copy of the rows takes time.
int normalising_power(const element_set &a, const element_set &b) {
  constexpr int least = -8, most = 20, step = 16;
  const float largest = std::max({a.reach, a.longest, b.reach, b.longest});
  if (largest == 0 || !std::isfinite(largest))
    return 0;
  const int exponent = std::ilogb(largest);
  if (exponent >= least && exponent < most)
    return 0;
  return exponent < 0 ? (step - 1 - exponent) / step * step : -(exponent / step * step);
}

stored_table::stored_table(const kind_info &kind)
    : kind_(&kind), rows_(std::make_unique<stored_rows[]>(static_cast<std::size_t>(kind.stored))) {}

stored_rows *stored_table::of(const stored_values &values, const kind_info &of) const {
  const bool any = &of == kind_ && values.number >= 0 && values.number < kind_->stored;
  return any ? &rows_[static_cast<std::size_t>(values.number)] : nullptr;
}

std::shared_ptr<const normalised_set> normalisation::of(const element_set &set, int power, const execution &on) {
  const std::scoped_lock hold(lock_);
  if (power != power_) {
    last_ = multiplied(set, power, on);
    power_ = power;
  }
  return last_;
}

} // namespace meetc
