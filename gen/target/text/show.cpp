#include "gen/target/text/text.hpp"

#include "gen/ir/count.hpp"
#include "gen/ir/print.hpp"
#include "gen/target/cpp/body.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

// Each program of the kernel under its title, written by `text`, with its counts.
template <class Text> std::string each_program(const lower::kernel &k, const Text &text) {
  std::string out;
  lower::kernel copy = k; // programs() returns references that passes may replace
  for (const lower::kernel_program &p : lower::programs(copy)) {
    out += fmt::format("{}\n{}  ; {}\n", p.title, text(*p.code, *p.inputs),
                       count_text(ir::count(p.code->nodes, p.code->results)));
    if (!p.code->stored.empty())
      out += fmt::format("  ; of these, where sets store values, for each pair: {}\n",
                         count_text(ir::count_pair(*p.code)));
  }
  return out;
}

} // namespace

std::string poly_text(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  std::string out;
  if (k.is_predicate) {
    int i = 0;
    for (const lower::stage *s : lower::stages(k.decision))
      for (const int a : s->atoms) {
        const poly::poly local = k.decision.local->lower(k.decision.signs.atoms()[static_cast<std::size_t>(a)]);
        out += fmt::format("s[{}] = sign of {}\n", i++, local.text());
      }
    return out;
  }
  for (std::size_t i = 0; i < k.value.result.size(); ++i)
    out += fmt::format("{}: {}\n", k.value.result_names[i].text(), k.value.polynomials[i].text());
  return out;
}

std::string graph_text(const unit &u, std::size_t kernel) {
  return each_program(u.kernels[kernel], ir::print);
}

std::string schedule_text(const unit &u, std::size_t kernel) {
  return each_program(u.kernels[kernel], [](const ir::program &p, const std::vector<std::string> &inputs) {
    body_names names;
    names.input = [&](int i) { return inputs[static_cast<std::size_t>(i)]; };
    names.result = [](std::size_t i, const std::string &value) { return fmt::format("result[{}] = {};", i, value); };
    return body(p, names, "  ");
  });
}

} // namespace meetc::target
