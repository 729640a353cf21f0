// The device's time for values of formulas, beside the least that moving their numbers takes.
#include "meet/bench/tables/formula_times.hpp"
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/core/device/evaluate.hpp"

#include <fmt/format.h>

#include <random>

namespace meetc::bench {

namespace {

constexpr int runs = 15;

// Columns in device memory, of random objects.
class columns_there {
public:
  columns_there(int columns, std::size_t n) : n_(n) {
    std::vector<float> numbers(n * static_cast<std::size_t>(columns));
    std::minstd_rand random(1);
    for (float &x : numbers)
      x = static_cast<float>(random() % 65536) / 65536;
    check(cudaMemcpy(memory_.reserve(numbers.size(), "columns"), numbers.data(), numbers.size() * sizeof(float),
                     cudaMemcpyHostToDevice),
          "uploading columns");
  }
  float *column(int k) const { return memory_.data() + static_cast<std::size_t>(k) * n_; }

private:
  std::size_t n_;
  device_memory<float> memory_;
};

} // namespace

table gpu_bench::measure_formulas(std::size_t values) {
  std::vector<std::uint32_t> rows(2 * values);
  std::mt19937 random(2);
  for (std::uint32_t &r : rows)
    r = static_cast<std::uint32_t>(random() % values);
  device_memory<std::uint32_t> listed;
  check(cudaMemcpy(listed.reserve(rows.size(), "rows"), rows.data(), rows.size() * sizeof rows[0],
                   cudaMemcpyHostToDevice),
        "uploading rows");
  std::vector<formula_times> out;
  for (const char *const name : measured_formulas) {
    const formula_info &f = formula_named(all_, name);
    const cuda::formula_launchers &launchers = launchers_of(on_, f);
    const columns_there numbers(f.number_count, values), results(f.result_count, values);
    std::vector<meetc::column> in;
    std::vector<float *> to;
    gathering g{.in = {},
                .numbers = f.number_count,
                .of_first = f.operands[0].number_count,
                .out = {},
                .values = f.result_count};
    for (int k = 0; k < f.number_count; ++k) {
      in.push_back({numbers.column(k), 1});
      g.in[k] = numbers.column(k);
    }
    for (int k = 0; k < f.result_count; ++k) {
      to.push_back(results.column(k));
      g.out[k] = results.column(k);
    }
    const std::size_t bytes = sizeof(float) * values * static_cast<std::size_t>(f.number_count + f.result_count) / 2;
    device_memory<std::byte> from, copied;
    from.reserve(bytes, "bytes to copy"), copied.reserve(bytes, "bytes to copy");
    const auto evaluated = [&](const std::uint32_t *of) {
      check(launchers.float32(in.data(), of, values, to.data(), on_.stream()), "evaluating a formula");
    };
    const auto times = take_turns(
        timer_,
        {[&] { evaluated(nullptr); },
         [&] {
           check(cudaMemcpyAsync(copied.data(), from.data(), bytes, cudaMemcpyDeviceToDevice, on_.stream()), "copying");
         },
         [&] { evaluated(listed.data()); },
         [&] { check(gather(g, listed.data(), values, on_.stream()), "starting to gather"); }},
        {runs, 60, 0});
    out.push_back({f.name, f.number_count, f.result_count, times.seconds[0], times.seconds[1], times.seconds[2],
                   times.seconds[3]});
  }
  return table_of_formulas(fmt::format("{} values of formulas, float32", values), out,
                           fmt::format("Medians of {} interleaved runs, by the device's events.", runs));
}

} // namespace meetc::bench
