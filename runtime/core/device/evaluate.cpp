#include "meet/core/device/evaluate.hpp"

#include "meet/core/device/memory/memory.hpp"
#include "meet/core/device/query/slots.hpp"
#include "meet/core/views/usage_error.hpp"

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
formula_values<Number> values_for(const device &on, const formula_info &f, std::span<const operand_columns> operands,
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

// The slots of a set's elements, in device memory.
class element_slots {
public:
  element_slots(const device_rows &rows, cudaStream_t stream) : numbers_(rows.numbers()) {
    check(on_device::find_slots(rows.order(), rows.elements(), slot_of_.reserve(numbers_, "the rows of elements"),
                                numbers_, stream),
          "finding the rows of elements");
  }
  on_device::slots_there there() const { return {slot_of_.data(), numbers_}; }

private:
  std::uint32_t numbers_;
  device_memory<std::uint32_t> slot_of_;
};

// Rows of a formula's first two operands for pairs of elements, in device memory. Waits. Throws std::out_of_range.
device_memory<std::uint32_t> rows_for(const device_rows &a, const device_rows &b, const index_pair *pairs,
                                      std::size_t n, cudaStream_t stream) {
  const element_slots of_a(a, stream), of_b(b, stream);
  device_memory<std::uint32_t> rows;
  device_memory<unsigned long long> bad;
  unsigned long long least = n;
  check(cudaMemcpyAsync(bad.reserve(1, "a fault"), &least, sizeof least, cudaMemcpyHostToDevice, stream),
        "uploading a number");
  check(on_device::rows_of_pairs(pairs, n, of_a.there(), of_b.there(), rows.reserve(2 * n, "the rows of pairs"),
                                 bad.data(), stream),
        "finding the rows of pairs");
  check(cudaMemcpyAsync(&least, bad.data(), sizeof least, cudaMemcpyDeviceToHost, stream), "downloading a number");
  check(cudaStreamSynchronize(stream), "finding the rows of pairs");
  if (least < n)
    throw std::out_of_range("pair " + std::to_string(least) + " names an element that is not in its set");
  return rows;
}

} // namespace

const cuda::formula_launchers &launchers_of(const device &on, const formula_info &formula) {
  const cuda::catalogue &all = on.kernels();
  for (int i = 0; i < all.formula_count; ++i)
    if (const cuda::formula_launchers &f = all.formulas[i]; std::string_view(f.name) == formula.name) {
      if (f.number_count != formula.number_count || f.result_count != formula.result_count)
        throw usage_error(std::string(formula.name) + " is another formula on the device");
      return f;
    }
  throw usage_error(std::string(formula.name) + ": the device's catalogue has no such formula");
}

template <class Number>
formula_values<Number> evaluate(const device &on, const formula_info &formula,
                                std::span<const operand_columns> operands) {
  columns_of(formula, operands); // checks them
  return values_for<Number>(on, formula, operands, nullptr, common_objects(formula, operands));
}
template <class Number>
formula_values<Number> evaluate(const device &on, const formula_info &formula,
                                std::span<const operand_columns> operands, std::span<const std::uint32_t> rows) {
  columns_of(formula, operands);
  require_rows(formula, operands, rows);
  return values_for<Number>(on, formula, operands, rows.data(),
                            rows.size() / static_cast<std::size_t>(formula.operand_count));
}

template <class Number> formula_values<Number> values_there<Number>::download() const {
  formula_values<Number> out;
  out.count = count_;
  out.numbers.resize(count_ * static_cast<std::size_t>(columns_));
  if (out.numbers.empty())
    return out;
  const auto lock = on_.use();
  check(cudaMemcpyAsync(out.numbers.data(), data_, out.numbers.size() * sizeof(Number), cudaMemcpyDeviceToHost,
                        on_.stream()),
        "downloading values");
  check(cudaStreamSynchronize(on_.stream()), "downloading values");
  return out;
}

template <class Number>
values_there<Number> evaluate(const device &on, const formula_info &formula, const device_set &a, const device_set &b,
                              const index_pair *pairs, std::size_t n) {
  const device_set *const sets[] = {&a, &b};
  if (formula.operand_count != 2 || std::string_view(formula.operands[0].kind) != a.kind().name ||
      std::string_view(formula.operands[1].kind) != b.kind().name)
    throw usage_error(std::string(formula.name) + " does not take a " + a.kind().name + " and a " + b.kind().name);
  const cuda::formula_launchers &launchers = launchers_of(on, formula);
  std::vector<column> in;
  for (const device_set *set : sets) {
    if (!(set->on() == on))
      throw usage_error("a set lies on another device");
    if (set->as_given())
      throw usage_error("the rows of a given set are in no order; make a set that is");
    const int fields = set->kind().fields;
    for (int k = 0; k < fields; ++k)
      in.push_back({set->rows().data() + k, fields});
  }
  const auto lock = on.use();
  values_there<Number> out(on, n, formula.result_count);
  if (n == 0)
    return out;
  const device_memory<std::uint32_t> rows = rows_for(a.rows(), b.rows(), pairs, n, on.stream());
  std::vector<Number *> columns;
  for (int k = 0; k < formula.result_count; ++k)
    columns.push_back(out.column(k));
  check(launch(launchers, in.data(), rows.data(), n, columns.data(), on.stream()), "evaluating a formula");
  check(cudaStreamSynchronize(on.stream()), "evaluating a formula");
  return out;
}

template class values_there<float>;
template class values_there<double>;
template values_there<float> evaluate(const device &, const formula_info &, const device_set &, const device_set &,
                                      const index_pair *, std::size_t);
template values_there<double> evaluate(const device &, const formula_info &, const device_set &, const device_set &,
                                       const index_pair *, std::size_t);
template formula_values<float> evaluate(const device &, const formula_info &, std::span<const operand_columns>);
template formula_values<double> evaluate(const device &, const formula_info &, std::span<const operand_columns>);
template formula_values<float> evaluate(const device &, const formula_info &, std::span<const operand_columns>,
                                        std::span<const std::uint32_t>);
template formula_values<double> evaluate(const device &, const formula_info &, std::span<const operand_columns>,
                                         std::span<const std::uint32_t>);

} // namespace meetc
