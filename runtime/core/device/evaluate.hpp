// core/device/evaluate.hpp: the values of a formula, computed on a device.
//
// These are the values of core/query/evaluate.hpp on a CPU with the fused multiply-add, bit for bit. Whoever has columns in
// device memory calls formula_launchers::float32 and float64 of the namespace's catalogue, which neither copy nor wait.
#ifndef MEETC_CORE_DEVICE_EVALUATE_HPP
#define MEETC_CORE_DEVICE_EVALUATE_HPP

#include "meet/core/device/set/device_set.hpp"
#include "meet/core/query/evaluate.hpp"

namespace meetc {

// The launchers of a formula of this name. Throws usage_error where the device's catalogue has none.
const cuda::formula_launchers &launchers_of(const device &on, const formula_info &formula);

// As evaluate() on a CPU, of objects in host memory: copies them to the device and the values back. Throws what that throws,
// and device_error.
template <class Number>
formula_values<Number> evaluate(const device &on, const formula_info &formula,
                                std::span<const operand_columns> operands);
template <class Number>
formula_values<Number> evaluate(const device &on, const formula_info &formula,
                                std::span<const operand_columns> operands, std::span<const std::uint32_t> rows);

// The values of a formula in device memory: columns of `count()` numbers.
template <class Number> class values_there {
public:
  values_there(const device &on, std::size_t count, int columns)
      : on_(on), count_(count), columns_(columns),
        data_(numbers_.reserve(count * static_cast<std::size_t>(columns), "the values of a formula")) {}

  std::size_t count() const { return count_; }
  int columns() const { return columns_; }
  Number *column(int k) const { return data_ + static_cast<std::size_t>(k) * count_; }
  // Throws device_error.
  formula_values<Number> download() const;

private:
  device on_;
  std::size_t count_;
  int columns_;
  device_memory<Number> numbers_;
  Number *data_;
};

// The values for n pairs of elements of two sets in order on this device, as they are posed now: pairs[i].a is an element of a,
// the formula's first operand. The pairs lie in device memory, as those of pairs_there do, and nothing but one number travels
// to the host. The pairs must be written before the call, and the values are there on return. Throws usage_error
// where a set is given or on another device, and where the formula does not take these two kinds; std::out_of_range for an
// element that a set does not hold; device_error.
template <class Number>
values_there<Number> evaluate(const device &on, const formula_info &formula, const device_set &a, const device_set &b,
                              const index_pair *pairs, std::size_t n);

} // namespace meetc

#endif
