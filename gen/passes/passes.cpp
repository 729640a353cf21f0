#include "gen/passes/passes.hpp"

#include "gen/ir/evaluate.hpp"
#include "gen/ir/residue.hpp"
#include "gen/passes/fuse.hpp"
#include "gen/passes/prune.hpp"
#include "gen/passes/store.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace meetc::passes {
namespace {

constexpr pass list[] = {
    {"prune", "drops the nodes that no chosen form needs; keeps the order of the others", prune},
    {"fuse", "turns a product that is used once, in a sum of the same residency, into a fused multiply-add", fuse},
    {"keep", "stores every value of one object that a pair reads; callers prepare the objects", keep,
     lower::use::pairs},
    {"store", "stores values of one object beside it if they cost more than one operation", store, lower::use::sets},
};

} // namespace

std::span<const pass> all() {
  return list;
}

ir::program run(const ir::program &p, const poly::ring &inputs, const std::string &last, lower::use as) {
  ir::program out = p;
  if (last == "lower")
    return out;
  const auto wanted = ir::short_polys(p, inputs); // once for all passes
  for (const pass &step : list) {
    if (!step.only || step.only == as)
      out = step.run(out);
    if (!(wanted ? ir::same_values(out, *wanted, inputs) : ir::residues(out) == ir::residues(p)))
      throw std::logic_error(fmt::format("the pass '{}' changed a value", step.name));
    if (last == step.name)
      break;
  }
  return out;
}

void run(lower::kernel &k, const std::string &last) {
  for (const lower::kernel_program &p : lower::programs(k))
    *p.code = run(*p.code, *p.numbers, last, p.as);
}

void run(std::vector<lower::blade_maker> &makers) {
  for (lower::blade_maker &m : makers)
    m.code = run(m.code, *m.numbers);
}

void run(lower::analytic_kernel &k) {
  if (k.read)
    for (lower::reading::step &s : k.read->steps)
      s.code = run(s.code, *k.read->numbers);
}

void run(bound::kernel_bounds &b) {
  for (bound::stage_bounds *s : {&b.reject, &b.common}) {
    ir::program stored = store(s->magnitudes);
    if (stored.results != s->magnitudes.results || stored.nodes.size() != s->magnitudes.nodes.size())
      throw std::logic_error("the pass 'store' changed a magnitude");
    s->magnitudes = std::move(stored);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> out{"lower"};
  for (const pass &step : list)
    out.emplace_back(step.name);
  return out;
}

} // namespace meetc::passes
