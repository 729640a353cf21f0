#include "gen/lower/calls.hpp"

#include "gen/lower/compile.hpp"

#include <functional>
#include <optional>
#include <set>

namespace meetc::lower {
namespace {

// Writes the callee's truth with the caller's signs.
class transfer {
public:
  transfer(const predicate &from, const std::vector<sign_value> &signs, decision &to) : from_(from.signs), to_(to) {
    const std::vector<int> order = from.order();
    for (std::size_t i = 0; i < order.size(); ++i)
      signs_[order[i]] = signs[i];
  }

  int operator()(int id) {
    const truth_node n = from_.at(id);
    std::vector<int> args;
    for (const int a : n.args)
      args.push_back((*this)(a));
    switch (n.kind) {
    case truth_node::type::constant:
      return to_.constant(n.flag != 0);
    case truth_node::type::test: {
      sign_value s{n.sign.unit, {}};
      for (const auto &[atom, exponent] : n.sign.atoms)
        for (int k = 0; k < exponent; ++k)
          s = s * signs_.at(atom);
      return to_.test(s, n.flag);
    }
    case truth_node::type::both:
      return to_.both(args);
    case truth_node::type::either:
      return to_.either(args);
    case truth_node::type::negate:
      return to_.negate(args[0]);
    default:
      return to_.choose(args[0], args[1], args[2]);
    }
  }

private:
  const decision &from_;
  decision &to_;
  std::map<int, sign_value> signs_;
};

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
    transfer over(*callee, *signs, caller.signs);
    const int usual = caller.signs.usual(call.truth);
    if (over(callee->truths.hit) == call.truth && over(callee->usual) == usual)
      caller.calls.push_back({callee, call.callee->name, call.text, call.truth, usual, *signs});
  }
}

} // namespace meetc::lower
