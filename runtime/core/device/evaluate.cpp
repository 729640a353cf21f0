#include "meet/core/device/evaluate.hpp"

#include "meet/core/device/memory/memory.hpp"

#include <stdexcept>
#include <string>
#include <string_view>

namespace meetc {
namespace {

cudaError_t launch(const cuda::formula_launchers &f, const column *in, const std::uint32_t *rows, std::size_t n,
                   float *const *out, cudaStream_t stream) {
  return f.float32(in, rows, n, out, stream);
}
cudaError_t launch(const cuda::formula_launchers &f, const column *in, const std::uint32_t *rows, std::size_t n,
                   double *const *out, cudaStream_t stream) {
  return f.float64(in, rows, n, out, stream);
}

// Columns in device memory. One number for all objects stays one.
class columns_there {
public:
  columns_there(std::span<const column> from, std::span<const std::size_t> objects, cudaStream_t stream) {
    std::size_t all = 0;
    for (std::size_t k = 0; k < from.size(); ++k)
      all += from[k].stride ? objects[k] : 1;
    float *to = memory_.reserve(all, "the numbers of a formula");
    for (std::size_t k = 0; k < from.size(); ++k) {
      const std::size_t n = from[k].stride ? objects[k] : 1;
      const float *data = from[k].data;
      if (from[k].stride != 1) { // packed first
        packed_.emplace_back(n);
        for (std::size_t i = 0; i < n; ++i)
          packed_.back()[i] = from[k].data[static_cast<std::ptrdiff_t>(i) * from[k].stride];
        data = packed_.back().data();
      }
      check(cudaMemcpyAsync(to, data, n * sizeof(float), cudaMemcpyHostToDevice, stream), "uploading a column");
      all_.push_back({to, from[k].stride ? 1 : 0});
      to += n;
    }
  }
  const column *data() const { return all_.data(); }

private:
  device_memory<float> memory_;
  std::vector<std::vector<float>> packed_; // until the copies have ended
  std::vector<column> all_;
};

template <class Number>
formula_values<Number> values_there(const device &on, const formula_info &f, std::span<const operand_columns> operands,
                                    const std::uint32_t *rows, std::size_t n) {
  const cuda::formula_launchers &launchers = launchers_of(on, f);
  formula_values<Number> out;
  out.count = n;
  out.numbers.resize(n * static_cast<std::size_t>(f.result_count));
  if (n == 0)
    return out;
  const auto lock = on.use();
  std::vector<std::size_t> objects;
  for (const operand_columns &o : operands)
    objects.insert(objects.end(), o.numbers.size(), o.objects);
  const columns_there in(columns_of(f, operands), objects, on.stream());
  device_memory<std::uint32_t> rows_there;
  if (rows) {
    const std::size_t count = n * operands.size();
    check(cudaMemcpyAsync(rows_there.reserve(count, "the rows of a formula"), rows, count * sizeof *rows,
                          cudaMemcpyHostToDevice, on.stream()),
          "uploading rows");
  }
  device_memory<Number> values;
  Number *const to = values.reserve(out.numbers.size(), "the values of a formula");
  std::vector<Number *> columns;
  for (std::size_t k = 0; k < static_cast<std::size_t>(f.result_count); ++k)
    columns.push_back(to + k * n);
  check(launch(launchers, in.data(), rows_there.data(), n, columns.data(), on.stream()), "evaluating a formula");
  check(
      cudaMemcpyAsync(out.numbers.data(), to, out.numbers.size() * sizeof(Number), cudaMemcpyDeviceToHost, on.stream()),
      "downloading values");
  check(cudaStreamSynchronize(on.stream()), "evaluating a formula");
  return out;
}

} // namespace

const cuda::formula_launchers &launchers_of(const device &on, const formula_info &formula) {
  const cuda::catalogue &all = on.kernels();
  for (int i = 0; i < all.formula_count; ++i)
    if (const cuda::formula_launchers &f = all.formulas[i]; std::string_view(f.name) == formula.name) {
      if (f.number_count != formula.number_count || f.result_count != formula.result_count)
        throw std::invalid_argument(std::string(formula.name) + " is another formula on the device");
      return f;
    }
  throw std::invalid_argument(std::string(formula.name) + ": the device's catalogue has no such formula");
}

template <class Number>
formula_values<Number> evaluate(const device &on, const formula_info &formula,
                                std::span<const operand_columns> operands) {
  columns_of(formula, operands); // checks them
  return values_there<Number>(on, formula, operands, nullptr, common_objects(formula, operands));
}
template <class Number>
formula_values<Number> evaluate(const device &on, const formula_info &formula,
                                std::span<const operand_columns> operands, std::span<const std::uint32_t> rows) {
  columns_of(formula, operands);
  require_rows(formula, operands, rows);
  return values_there<Number>(on, formula, operands, rows.data(),
                              rows.size() / static_cast<std::size_t>(formula.operand_count));
}
template formula_values<float> evaluate(const device &, const formula_info &, std::span<const operand_columns>);
template formula_values<double> evaluate(const device &, const formula_info &, std::span<const operand_columns>);
template formula_values<float> evaluate(const device &, const formula_info &, std::span<const operand_columns>,
                                        std::span<const std::uint32_t>);
template formula_values<double> evaluate(const device &, const formula_info &, std::span<const operand_columns>,
                                         std::span<const std::uint32_t>);

} // namespace meetc
