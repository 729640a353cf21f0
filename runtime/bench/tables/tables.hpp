// bench/tables/tables.hpp: the benchmarks. Each returns the text for standard output, and throws app::failure, with
// app::check_failed where a method that promises the truth gives another answer, or io::error.
#ifndef MEETC_BENCH_TABLES_TABLES_HPP
#define MEETC_BENCH_TABLES_TABLES_HPP

#include "meet/app/query/choose.hpp"
#include "meet/bench/harness/options.hpp"

#include <string>

namespace meetc::bench {

// `meet bench paper`: the paper's tables and its figures 1 to 6 again.
std::string paper(const catalogue &all, const request &q);

// `meet bench gpu`: kernels and queries on the CUDA device, beside the classic tests.
std::string gpu(const catalogue &all, const request &q);

// `meet bench cpu`: kernels and queries on the CPU, beside other libraries.
std::string cpu(const app::kernel_library &kernels, const request &q);

// `meet bench read`: the reader of each format beside the least that such a file takes: for text, one thread that passes all
// numbers to std::from_chars; for a binary file, a copy of its bytes into fresh memory. Files lie in a temporary folder, and so
// in the page cache; all memory is fresh in each run.
std::string read(const catalogue &all, const request &q);

// `meet bench formulas`: formulas on columns beside a copy of as many bytes, and on listed rows beside a loop that gathers the
// same numbers and writes as many.
std::string formulas(const app::kernel_library &kernels, const request &q);

// `meet trade`: the cost of each rung, the number of its errors, and their size.
std::string trade(const app::kernel_library &kernels, const request &q);

} // namespace meetc::bench

#endif
