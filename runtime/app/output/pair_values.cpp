#include "meet/app/output/pair_values.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/text/nearest.hpp"
#include "meet/core/query/evaluate.hpp"
#include "meet/core/views/nouns.hpp"
#include "meet/io/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace meetc::app {

namespace {

constexpr std::size_t pairs_at_once = std::size_t{1} << 16;

bool takes(const formula_info &f, const kind_info &first, const kind_info &second) {
  return f.operand_count == 2 && std::string_view(f.operands[0].kind) == first.name &&
         std::string_view(f.operands[1].kind) == second.name;
}

std::string joined(const std::vector<std::string> &names) {
  std::string out;
  for (const std::string &name : names)
    out += (out.empty() ? "" : "; ") + name;
  return out;
}

// Some pairs' elements as columns, and their values.
template <class Number> class values_of_pairs {
public:
  values_of_pairs(const formula_choice &by, const io::element_set &a, const io::element_set &b, int threads)
      : by_(by), sets_{by.swapped ? &b : &a, by.swapped ? &a : &b}, threads_(threads),
        values_(static_cast<std::size_t>(by.formula->result_count), std::vector<Number>(pairs_at_once)) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto fields = static_cast<std::size_t>(sets_[k]->kind->fields);
      rows_[k].resize(pairs_at_once * fields);
      columns_[k].resize(fields);
      columns_of(rows_[k].data(), columns_[k]);
    }
    for (auto &column : values_)
      out_.push_back(column.data());
  }

  void compute(std::span<const index_pair> pairs) {
    operand_columns operands[2];
    for (std::size_t k = 0; k < 2; ++k) {
      const bool of_b = (k == 1) != by_.swapped;
      for (std::size_t i = 0; i < pairs.size(); ++i)
        sets_[k]->row(of_b ? pairs[i].b : pairs[i].a, rows_[k].data() + i * columns_[k].size());
      operands[k] = {columns_[k], pairs.size()};
    }
    evaluate(*by_.formula, operands, out_, threads_);
  }
  void append(std::size_t i, std::string &line) const {
    for (const auto &column : values_)
      fmt::format_to(std::back_inserter(line), ",{}", column[i]);
  }

private:
  const formula_choice &by_;
  const io::element_set *sets_[2];
  int threads_;
  std::vector<float> rows_[2];
  std::vector<column> columns_[2];
  std::vector<std::vector<Number>> values_;
  std::vector<Number *> out_;
};

template <class Number>
void write_all(const std::filesystem::path &to, const formula_choice &by, const io::element_set &a,
               const io::element_set &b, std::span<const index_pair> pairs, int threads) {
  values_of_pairs<Number> values(by, a, b, threads);
  io::write_pairs_csv(to, pairs, fmt::format(",{}", by.formula->results), [&](std::size_t i, std::string &line) {
    if (i % pairs_at_once == 0)
      values.compute(pairs.subspan(i, std::min(pairs_at_once, pairs.size() - i)));
    values.append(i % pairs_at_once, line);
  });
}

} // namespace

formula_choice choose_formula(const catalogue &all, const io::element_set &set_a, const io::element_set &set_b,
                              const std::string &text, bool float32) {
  const kind_info &a = *set_a.kind, &b = *set_b.kind;
  std::vector<std::string> fitting;
  for (int i = 0; i < all.formula_count; ++i)
    if (const formula_info &f = all.formulas[i]; takes(f, a, b) || takes(f, b, a))
      fitting.emplace_back(f.name);
  const std::string those = fmt::format("for {} and {} the scene has {}", plural_of(a.name), plural_of(b.name),
                                        fitting.empty() ? "none" : joined(fitting));
  const formula_info *const f = find_formula(all, text);
  if (!f) {
    const std::string meant = nearest(text, fitting);
    throw failure(fmt::format("--evaluate: no formula '{}'{}", text, meant.empty() ? "; " + those : meant));
  }
  if (!takes(*f, a, b) && !takes(*f, b, a))
    throw failure(fmt::format("--evaluate: '{}' takes other kinds; {}", text, those));
  if (!set_a.owner.empty() || !set_b.owner.empty())
    throw failure(fmt::format("--evaluate: {} has items that were cut into several elements, and a formula takes one",
                              set_a.owner.empty() ? "B" : "A"));
  return {f, !takes(*f, a, b), float32};
}

void write_pair_values(const std::filesystem::path &to, const formula_choice &by, const io::element_set &a,
                       const io::element_set &b, std::span<const index_pair> pairs, int threads) {
  if (by.float32)
    write_all<float>(to, by, a, b, pairs, threads);
  else
    write_all<double>(to, by, a, b, pairs, threads);
}

} // namespace meetc::app
