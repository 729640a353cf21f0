// core/device/evaluate.hpp: the values of a formula, computed on a device.
//
// These are the values of core/query/evaluate.hpp on a CPU with the fused multiply-add, bit for bit. Whoever has columns in
// device memory calls formula_launchers::float32 and float64 of the namespace's catalogue, which neither copy nor wait.
#ifndef MEETC_CORE_DEVICE_EVALUATE_HPP
#define MEETC_CORE_DEVICE_EVALUATE_HPP

#include "meet/core/device/memory/device.hpp"
#include "meet/core/query/evaluate.hpp"

namespace meetc {

// The launchers of a formula of this name. Throws std::invalid_argument where the device's catalogue has none.
const cuda::formula_launchers &launchers_of(const device &on, const formula_info &formula);

// As evaluate() on a CPU, of objects in host memory: copies them to the device and the values back. Throws what that throws,
// and device_error.
template <class Number>
formula_values<Number> evaluate(const device &on, const formula_info &formula,
                                std::span<const operand_columns> operands);
template <class Number>
formula_values<Number> evaluate(const device &on, const formula_info &formula,
                                std::span<const operand_columns> operands, std::span<const std::uint32_t> rows);

} // namespace meetc

#endif
