#include "gen/lower/kernel/assume.hpp"

#include "gen/ir/count.hpp"
#include "gen/ir/evaluate.hpp"
#include "gen/lower/kernel/relations.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace meetc::lower {
namespace {

using search::certified_difference;

// The sizes of the terms: every coefficient positive.
poly::poly sizes(const poly::poly &p) {
  std::vector<poly::term> terms = p.terms();
  for (poly::term &t : terms)
    t.coefficient = abs(t.coefficient);
  return poly::poly::from_terms(p.in(), terms);
}

class taking {
public:
  taking(const request &r, const search::product_subject &of, const std::vector<stated_relation> &stated)
      : request_(r), of_(of), stated_(stated) {}

  assumptions by(const program &p, const std::vector<certified_difference> &differences) const {
    assumptions out;
    out.computed = ir::to_poly(p, of_.numbers);
    if (!search::is_certified(of_, differences, out.computed))
      throw std::logic_error("a program's certificate does not prove it");
    for (const certified_difference &d : differences) {
      assumption &a = of(out, stated_[d.relation]);
      a.left_out[d.output] = a.left_out[d.output] + sizes(d.multiplier);
    }
    if (out.taken.empty())
      out.computed.clear();
    return out;
  }

private:
  const request &request_;
  const search::product_subject &of_;
  const std::vector<stated_relation> &stated_;

  assumption &of(assumptions &all, const stated_relation &r) const {
    const std::string &operand = request_.names[r.operand];
    const std::string text = fmt::format("{} = {}", lang::print(*r.of->left), lang::print(*r.of->right));
    const auto it = std::find_if(all.taken.begin(), all.taken.end(),
                                 [&](const assumption &a) { return a.operand == operand && a.text == text; });
    if (it != all.taken.end())
      return *it;
    all.taken.push_back({operand, text, r.of->nearly, r.of->nearly ? request_.kinds[r.operand]->within : 0,
                         std::vector<poly::poly>(of_.values.size(), poly::poly(of_.numbers))});
    return all.taken.back();
  }
};

} // namespace

void assume(const model &m, const request &r, const std::vector<std::vector<blade>> &supports,
            search::product_subject subject, const std::vector<node_id> &leaves,
            const search::written_programs &written, builder &code, formula &out) {
  std::vector<stated_relation> stated;
  std::size_t first = 0;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    check_relations(m, *r.kinds[i]);
    for (stated_relation &s : relations_on(m, *r.kinds[i], supports[i], subject.numbers, i, first))
      stated.push_back(std::move(s));
    first += supports[i].size();
  }
  for (const stated_relation &s : stated)
    subject.relations.push_back(s.zero);
  const taking take(r, subject, stated);
  const auto cost = [](const program &p) { return ir::count(p.nodes, p.results).total(); };
  if (const auto found = search::under_relations(code.nodes(), subject, leaves, written, cost(out.from_blades))) {
    program p = code.finish(found->outputs);
    assumptions assumed = take.by(p, found->differences);
    // A formula that becomes a constant asks how far the relation holds.
    if (!std::all_of(assumed.computed.begin(), assumed.computed.end(), [](const auto &c) { return c.is_constant(); })) {
      out.from_blades = std::move(p);
      out.assumed = std::move(assumed);
    }
  }
  if (out.is_number())
    return;
  if (const auto found = search::prepared(code.nodes(), subject, leaves)) {
    program p = code.finish(found->outputs);
    if (ir::count(p, residency::pair).total() < cost(out.from_blades)) {
      out.prepared_assumed = take.by(p, found->differences);
      out.prepared = std::move(p);
    }
  }
}

} // namespace meetc::lower
