#include "meet/core/query/evaluate.hpp"

#include "meet/core/sets/element_set.hpp"
#include "meet/core/threads/threads.hpp"
#include "meet/core/views/usage_error.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <string>

namespace meetc {
namespace {

constexpr std::size_t values_in_chunk = 4096;

std::string without_spaces(std::string_view text) {
  std::string out;
  std::copy_if(text.begin(), text.end(), std::back_inserter(out), [](char c) { return c != ' ' && c != '\t'; });
  return out;
}

void evaluate_some(const formula_info &f, const column *in, const std::uint32_t *rows, std::size_t n, float **out) {
  f.float32(in, rows, n, out);
}
void evaluate_some(const formula_info &f, const column *in, const std::uint32_t *rows, std::size_t n, double **out) {
  f.float64(in, rows, n, out);
}

// n values, each of the next rows if there are any.
template <class Number>
void evaluate_all(const formula_info &f, const std::vector<column> &in, const std::uint32_t *rows, std::size_t n,
                  std::span<Number *const> out, const execution &on) {
  if (out.size() != static_cast<std::size_t>(f.result_count))
    throw usage_error(std::string(f.name) + " has " + std::to_string(f.result_count) + " values, " + f.results +
                      "; here is room for " + std::to_string(out.size()));
  if (n && std::any_of(out.begin(), out.end(), [](const Number *column) { return !column; }))
    throw usage_error(std::string(f.name) + ": a column of values has no room");
  const execution workers = execution_on(on.threads, on.stop);
  std::vector<column> first(in.size() * static_cast<std::size_t>(workers.threads));
  std::vector<Number *> into(out.size() * static_cast<std::size_t>(workers.threads));
  for_chunks(workers, n, values_in_chunk, [&](int worker, std::size_t begin, std::size_t end) {
    column *const from = first.data() + in.size() * static_cast<std::size_t>(worker);
    Number **const to = into.data() + out.size() * static_cast<std::size_t>(worker);
    for (std::size_t k = 0; k < in.size(); ++k)
      from[k] = rows ? in[k] : column{in[k].data + static_cast<std::ptrdiff_t>(begin) * in[k].stride, in[k].stride};
    for (std::size_t k = 0; k < out.size(); ++k)
      to[k] = out[k] + begin;
    evaluate_some(f, from, rows ? rows + begin * static_cast<std::size_t>(f.operand_count) : nullptr, end - begin, to);
  });
}

template <class Number>
void evaluate_columns(const formula_info &f, std::span<const operand_columns> operands, std::span<Number *const> out,
                      const execution &on) {
  const std::vector<column> in = columns_of(f, operands);
  evaluate_all(f, in, nullptr, common_objects(f, operands), out, on);
}

template <class Number>
void evaluate_rows(const formula_info &f, std::span<const operand_columns> operands,
                   std::span<const std::uint32_t> rows, std::span<Number *const> out, const execution &on) {
  const std::vector<column> in = columns_of(f, operands);
  require_rows(f, operands, rows, on);
  evaluate_all(f, in, rows.data(), rows.size() / static_cast<std::size_t>(f.operand_count), out, on);
}

// The slot of each element; as many as there are elements where the set does not hold it.
std::vector<std::uint32_t> slots_of(const prepared &p) {
  const element_set &set = p.set();
  std::vector<std::uint32_t> out(p.elements(), std::numeric_limits<std::uint32_t>::max());
  for (std::size_t slot = 0; slot < set.elements; ++slot)
    out[set.order[slot]] = static_cast<std::uint32_t>(slot);
  return out;
}

template <class Number>
void evaluate_pairs(const formula_info &formula, const prepared &a, const prepared &b,
                    std::span<const index_pair> pairs, std::span<Number *const> out, const execution &on) {
  const prepared *const sets[] = {&a, &b};
  if (formula.operand_count != 2 || std::string_view(formula.operands[0].kind) != a.kind().name ||
      std::string_view(formula.operands[1].kind) != b.kind().name)
    throw usage_error(std::string(formula.name) + " does not take a " + a.kind().name + " and a " + b.kind().name);
  std::vector<std::uint32_t> rows(2 * pairs.size());
  const std::vector<std::uint32_t> slot_a = slots_of(a), slot_b = slots_of(b);
  const auto slot = [&](const std::vector<std::uint32_t> &slots, std::uint32_t element, char side) {
    if (element >= slots.size() || slots[element] >= slots.size())
      throw std::out_of_range("element " + std::to_string(element) + " of " + side + " is not in the set");
    return slots[element];
  };
  for_strips(on, pairs.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      rows[2 * i] = slot(slot_a, pairs[i].a, 'a');
      rows[2 * i + 1] = slot(slot_b, pairs[i].b, 'b');
    }
  });
  std::vector<column> columns[2];
  operand_columns operands[2];
  for (std::size_t k = 0; k < 2; ++k) {
    columns[k].resize(static_cast<std::size_t>(sets[k]->kind().fields));
    columns_of(sets[k]->set().rows, columns[k]);
    operands[k] = {columns[k], sets[k]->set().elements};
  }
  evaluate_all(formula, columns_of(formula, operands), rows.data(), pairs.size(), out, on);
}

} // namespace

const formula_info *find_formula(const catalogue &all, std::string_view text) {
  const std::string wanted = without_spaces(text);
  for (int i = 0; i < all.formula_count; ++i)
    if (without_spaces(all.formulas[i].name) == wanted)
      return &all.formulas[i];
  return nullptr;
}

const formula_info &formula_named(const catalogue &all, std::string_view text) {
  if (const formula_info *const f = find_formula(all, text))
    return *f;
  std::string known;
  for (int i = 0; i < all.formula_count; ++i)
    known += (i == 0 ? "" : "; ") + std::string(all.formulas[i].name);
  throw usage_error("no formula '" + std::string(text) + "'; " + all.space + " has " +
                    (known.empty() ? "none" : known));
}

void columns_of(const float *rows, std::span<column> into) {
  for (std::size_t k = 0; k < into.size(); ++k)
    into[k] = {rows ? rows + k : nullptr, static_cast<std::ptrdiff_t>(into.size())};
}

std::vector<column> columns_of(const formula_info &f, std::span<const operand_columns> operands) {
  const std::string name = f.name;
  if (operands.size() != static_cast<std::size_t>(f.operand_count))
    throw usage_error(name + " takes " + std::to_string(f.operand_count) + " operands, not " +
                      std::to_string(operands.size()));
  std::vector<column> out;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    const formula_operand &of = f.operands[k];
    if (operands[k].numbers.size() != static_cast<std::size_t>(of.number_count))
      throw usage_error(name + ": operand " + std::to_string(k) + ", a " + of.kind + ", has the columns " + of.numbers +
                        "; here are " + std::to_string(operands[k].numbers.size()));
    for (const column &c : operands[k].numbers) {
      if (!c.data && operands[k].objects != 0)
        throw usage_error(name + ": operand " + std::to_string(k) + " has a column without data");
      out.push_back(c);
    }
  }
  return out;
}

std::size_t common_objects(const formula_info &f, std::span<const operand_columns> operands) {
  for (const operand_columns &o : operands)
    if (o.objects != operands[0].objects)
      throw usage_error(std::string(f.name) + ": the operands have " + std::to_string(operands[0].objects) + " and " +
                        std::to_string(o.objects) + " objects");
  return operands[0].objects;
}

void require_rows(const formula_info &f, std::span<const operand_columns> operands, std::span<const std::uint32_t> rows,
                  const execution &on) {
  const auto each = static_cast<std::size_t>(f.operand_count);
  if (rows.size() % each != 0)
    throw usage_error(std::string(f.name) + ": " + std::to_string(rows.size()) + " rows are no multiple of " +
                      std::to_string(each) + " operands");
  std::atomic<std::size_t> bad{rows.size()};
  for_chunks(execution_on(on.threads, on.stop), rows.size() / each, std::size_t{1} << 16,
             [&](int, std::size_t begin, std::size_t end) {
               for (std::size_t k = 0; k < each; ++k) {
                 bool all = true;
                 for (std::size_t i = begin; i < end; ++i)
                   all &= rows[i * each + k] < operands[k].objects;
                 for (std::size_t i = begin; !all && i < end; ++i)
                   if (rows[i * each + k] >= operands[k].objects) {
                     std::size_t least = bad.load();
                     while (i * each + k < least && !bad.compare_exchange_weak(least, i * each + k)) {
                     }
                     break;
                   }
               }
             });
  if (const std::size_t at = bad.load(); at < rows.size())
    throw std::out_of_range(std::string(f.name) + ": value " + std::to_string(at / each) + " takes object " +
                            std::to_string(rows[at]) + " of operand " + std::to_string(at % each) + ", which has " +
                            std::to_string(operands[at % each].objects));
}

void evaluate(const formula_info &formula, std::span<const operand_columns> operands, std::span<float *const> out,
              const execution &on) {
  evaluate_columns(formula, operands, out, on);
}
void evaluate(const formula_info &formula, std::span<const operand_columns> operands, std::span<double *const> out,
              const execution &on) {
  evaluate_columns(formula, operands, out, on);
}
void evaluate(const formula_info &formula, std::span<const operand_columns> operands,
              std::span<const std::uint32_t> rows, std::span<float *const> out, const execution &on) {
  evaluate_rows(formula, operands, rows, out, on);
}
void evaluate(const formula_info &formula, std::span<const operand_columns> operands,
              std::span<const std::uint32_t> rows, std::span<double *const> out, const execution &on) {
  evaluate_rows(formula, operands, rows, out, on);
}

void evaluate(const formula_info &formula, const prepared &a, const prepared &b, std::span<const index_pair> pairs,
              std::span<float *const> out, const execution &on) {
  evaluate_pairs(formula, a, b, pairs, out, on);
}
void evaluate(const formula_info &formula, const prepared &a, const prepared &b, std::span<const index_pair> pairs,
              std::span<double *const> out, const execution &on) {
  evaluate_pairs(formula, a, b, pairs, out, on);
}

template <class Number>
formula_values<Number> evaluate(const formula_info &formula, const prepared &a, const prepared &b,
                                std::span<const index_pair> pairs, const execution &on) {
  formula_values<Number> out;
  out.count = pairs.size();
  out.numbers.resize(out.count * static_cast<std::size_t>(formula.result_count));
  std::vector<Number *> into;
  for (int k = 0; k < formula.result_count; ++k)
    into.push_back(out.numbers.data() + static_cast<std::size_t>(k) * out.count);
  evaluate(formula, a, b, pairs, std::span<Number *const>(into), on);
  return out;
}
template formula_values<float> evaluate(const formula_info &, const prepared &, const prepared &,
                                        std::span<const index_pair>, const execution &);
template formula_values<double> evaluate(const formula_info &, const prepared &, const prepared &,
                                         std::span<const index_pair>, const execution &);

} // namespace meetc
