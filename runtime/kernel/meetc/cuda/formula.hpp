// A formula on columns, on a device: a thread for each value. Included by nvcc, or behind a stand-in for a block.
//
// The numbers of a value are read once and its values written once, so that memory binds: neighbouring threads read
// neighbouring numbers of a column. Values equal, bit for bit, those of a CPU with the fused multiply-add.
#ifndef MEETC_CUDA_FORMULA_HPP
#define MEETC_CUDA_FORMULA_HPP

#include <meetc/cuda/launch.hpp>
#include <meetc/cuda/table.hpp>

namespace meetc::cuda {

// Columns in device memory, as an argument of a kernel.
template <int Numbers> struct columns_read { column of[Numbers]; };
template <int Results, class Number> struct columns_written { Number *of[Results]; };

inline constexpr unsigned threads_to_evaluate = 256;

template <class F, class Number>
__global__ void __launch_bounds__(threads_to_evaluate)
    evaluate_kernel(columns_read<F::numbers> in, const std::uint32_t *rows, std::size_t n,
                    columns_written<F::results, Number> out) {
  begin();
  const std::size_t step = static_cast<std::size_t>(gridDim.x) * blockDim.x;
  for (std::size_t i = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x; i < n; i += step) {
    std::size_t which[F::operands];
    for (int k = 0; k < F::operands; ++k)
      which[k] = rows ? rows[i * F::operands + static_cast<std::size_t>(k)] : i;
    Number row[F::numbers], value[F::results];
    for (int k = 0; k < F::numbers; ++k)
      row[k] =
          static_cast<Number>(in.of[k].data[static_cast<std::ptrdiff_t>(which[F::operand_of(k)]) * in.of[k].stride]);
    F::values(row, value);
    for (int k = 0; k < F::results; ++k)
      out.of[k][i] = value[k];
  }
}

// formula_launchers::float32 and float64 of a formula, as formula_columns.hpp describes it.
template <class F, class Number>
cudaError_t evaluate(const column *in, const std::uint32_t *rows, std::size_t n, Number *const *out,
                     cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  columns_read<F::numbers> read;
  columns_written<F::results, Number> written;
  for (int k = 0; k < F::numbers; ++k)
    read.of[k] = in[k];
  for (int k = 0; k < F::results; ++k)
    written.of[k] = out[k];
  constexpr unsigned most_blocks = 1U << 20; // a thread takes more values of larger sets
  const std::size_t blocks = (n + threads_to_evaluate - 1) / threads_to_evaluate;
  return launch<evaluate_kernel<F, Number>>(blocks < most_blocks ? static_cast<unsigned>(blocks) : most_blocks,
                                            threads_to_evaluate, stream, read, rows, n, written);
}

template <class F> formula_launchers launchers_of(const char *name) {
  return {.name = name,
          .number_count = F::numbers,
          .result_count = F::results,
          .float32 = evaluate<F, float>,
          .float64 = evaluate<F, double>};
}

} // namespace meetc::cuda

#endif
