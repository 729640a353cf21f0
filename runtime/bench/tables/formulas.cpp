// How long formulas on sets take, beside the least that moving their numbers takes.
#include "meet/bench/harness/method.hpp"
#include "meet/bench/harness/report.hpp"
#include "meet/bench/tables/formula_times.hpp"
#include "meet/bench/tables/tables.hpp"
#include "meet/core/query/evaluate.hpp"
#include "meet/core/threads/threads.hpp"

#include <fmt/format.h>

#include <cstring>
#include <random>

namespace meetc::bench {

namespace {

// Objects for a formula with two operands, and room for its values.
struct works_of {
  works_of(const formula_info &f, std::size_t n)
      : formula(f), count(n), numbers(static_cast<std::size_t>(f.number_count)),
        values(static_cast<std::size_t>(f.result_count)), rows(2 * n) {
    std::mt19937 random(1);
    for (auto &column : numbers) {
      column.resize(n);
      for (float &x : column)
        x = static_cast<float>(random() % 65536) / 65536;
      in.push_back({column.data(), 1});
    }
    for (auto &column : values) {
      column.resize(n);
      out.push_back(column.data());
    }
    for (std::uint32_t &row : rows)
      row = static_cast<std::uint32_t>(random() % n);
    const auto first = static_cast<std::size_t>(f.operands[0].number_count);
    operands = {{std::span(in).first(first), n}, {std::span(in).subspan(first), n}};
  }
  std::size_t bytes() const { return 4 * count * (numbers.size() + values.size()); }

  const formula_info &formula;
  std::size_t count;
  std::vector<std::vector<float>> numbers, values;
  std::vector<std::uint32_t> rows; // two for each value
  std::vector<meetc::column> in;
  std::vector<float *> out;
  std::vector<operand_columns> operands;
};

// Reads and writes as many bytes as the formula does, in one copy.
struct byte_copy {
  explicit byte_copy(std::size_t bytes) : from(bytes / 2, 1), to(bytes / 2) {}
  void run(int threads) {
    for_chunks(thread_count(threads), from.size(), std::size_t{1} << 18, [&](int, std::size_t begin, std::size_t end) {
      std::memcpy(to.data() + begin, from.data() + begin, end - begin);
    });
  }
  std::vector<char> from, to;
};

// Gathers the numbers of each value, and writes their sum in its place.
void gather_and_write(const works_of &w, int threads) {
  const std::size_t first = w.operands[0].numbers.size();
  for_chunks(thread_count(threads), w.count, 4096, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t a = w.rows[2 * i], b = w.rows[2 * i + 1];
      float sum = 0;
      for (std::size_t k = 0; k < first; ++k)
        sum += w.in[k].data[a];
      for (std::size_t k = first; k < w.in.size(); ++k)
        sum += w.in[k].data[b];
      for (float *const column : w.out)
        column[i] = sum;
    }
  });
}

formula_times time_of(const formula_info &f, std::size_t n, const request &q) {
  works_of w(f, n);
  byte_copy copy(w.bytes());
  host_clock clock(0);
  const std::span<float *const> out(w.out);
  const measured_methods m = measure(f.name, clock,
                                     {{"columns", false, {[&] { evaluate(f, w.operands, out, q.threads); }}, {}},
                                      {"copy", false, {[&] { copy.run(q.threads); }}, {}},
                                      {"listed", false, {[&] { evaluate(f, w.operands, w.rows, out, q.threads); }}, {}},
                                      {"gather", false, {[&] { gather_and_write(w, q.threads); }}, {}}},
                                     {q.repetitions, 600, 0});
  return {f.name,
          f.number_count,
          f.result_count,
          m.of[0].seconds[0],
          m.of[1].seconds[0],
          m.of[2].seconds[0],
          m.of[3].seconds[0]};
}

} // namespace

std::string formulas(const app::kernel_library &kernels, const request &q) {
  const catalogue &all = app::kernels_named(kernels, q.instruction_set);
  const std::size_t n = q.quick ? 10000 : 2000000;
  std::vector<formula_times> rows;
  for (const char *const name : measured_formulas)
    rows.push_back(time_of(formula_named(all, name), n, q));
  report r;
  r.tables = {
      table_of_formulas(fmt::format("{} values of formulas on {} threads, {}", n, q.threads, name_of(all.compiled_for)),
                        rows, fmt::format("Medians of {} interleaved runs, by the clock on the wall.", q.repetitions))};
  return q.json ? as_json(r) : as_text(r);
}

} // namespace meetc::bench
