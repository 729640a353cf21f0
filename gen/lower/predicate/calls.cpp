#include "gen/lower/predicate/calls.hpp"

#include "gen/lower/expand/rewriter.hpp"
#include "gen/lower/kernel/compile.hpp"

#include <functional>
#include <optional>
#include <set>

namespace meetc::lower {
namespace {

// The caller's sign for each of the callee's atoms. Both take their signs in the same order.
std::optional<std::vector<sign_value>> signs_of(const predicate &callee, const std::vector<sign_value> &taken) {
  if (taken.size() != callee.taken.size())
    return std::nullopt;
  std::vector<sign_value> out;
  for (const int atom : callee.order()) {
    std::size_t k = 0;
    while (k < taken.size() && callee.taken[k].atoms != std::vector<std::pair<int, int>>{{atom, 1}})
      ++k;
    if (k == taken.size())
      return std::nullopt; // only a factor of a sign
    out.push_back(callee.taken[k].unit < 0 ? -taken[k] : taken[k]);
  }
  return out;
}

} // namespace

std::vector<int> predicate::order() const {
  std::vector<int> out;
  for (const stage *s : stages(*this))
    out.insert(out.end(), s->atoms.begin(), s->atoms.end());
  return out;
}

void find_calls(const model &m, const std::vector<predicate_call> &calls, predicate &caller) {
  std::map<std::string, std::shared_ptr<const predicate>> callees;
  std::set<int> known;
  for (const predicate_call &call : calls) {
    if (caller.signs.at(call.truth).kind == truth_node::type::constant || !known.insert(call.truth).second)
      continue;
    std::shared_ptr<const predicate> &callee = callees[call.callee->name];
    if (!callee) {
      request r;
      r.text = r.function = call.callee->name;
      r.asked = call.callee;
      r.where = call.callee->where;
      for (const lang::field &f : call.callee->of) {
        r.names.push_back(f.name);
        r.kinds.push_back(&m.kind(f.type, call.callee->where));
      }
      callee = std::make_shared<const predicate>(compile_predicate(m, r));
    }
    const auto signs = signs_of(*callee, call.signs);
    if (!signs)
      continue;
    // The callee's truth with the caller's signs.
    std::vector<sign_value> images(callee->signs.atoms().size());
    const std::vector<int> order = callee->order();
    for (std::size_t i = 0; i < order.size(); ++i)
      images[static_cast<std::size_t>(order[i])] = (*signs)[i];
    rewriter over(callee->signs, caller.signs, images);
    const int usual = caller.signs.usual(call.truth);
    if (over.of(callee->truths.hit) == call.truth && over.of(callee->usual) == usual)
      caller.calls.push_back({callee, call.callee->name, call.text, call.truth, usual, *signs});
  }
}

} // namespace meetc::lower
