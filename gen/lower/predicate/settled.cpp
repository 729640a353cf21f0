#include "gen/lower/predicate/settled.hpp"

#include "gen/lower/expand/rewriter.hpp"

#include <algorithm>

namespace meetc::lower {
namespace {

constexpr int most_steps = 20000, most_cases = 3; // of one proof; atoms by whose signs it makes cases

// Sets of signs and of truths, as bits: negative, zero, positive; false, true.
using sign_bits = unsigned;
using truth_bits = unsigned;
constexpr sign_bits any_sign = 7;
constexpr truth_bits is_false = 1, is_true = 2, unknown = 3;

sign_bits product(sign_bits a, sign_bits b) {
  sign_bits out = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      if (a >> (i + 1) & 1 && b >> (j + 1) & 1)
        out |= 1U << (i * j + 1);
  return out;
}

// Proves that truths hold for all signs of the atoms.
class prover {
public:
  explicit prover(const decision &d) : d_(d), signs_(d.atoms().size(), any_sign) {}

  bool proves(int id) {
    for (int cases = 0; cases <= most_cases && steps_ < most_steps; ++cases)
      if (holds(id, cases))
        return true;
    return false;
  }

private:
  const decision &d_;
  std::vector<sign_bits> signs_; // by atom: those that it can have in this case
  int steps_ = 0;
  // By node: its truth in step `of`, the last step that evaluated it.
  struct evaluated {
    int of = 0;
    truth_bits truth = unknown;
  };
  std::vector<evaluated> known_;

  bool holds(int id, int cases) {
    if (++steps_ > most_steps)
      return false;
    const truth_bits whole = evaluate(id);
    if (whole != unknown)
      return whole == is_true;
    const truth_node &n = d_.at(id);
    const auto each = [&](int a) { return holds(a, cases); };
    switch (n.kind) {
    case truth_node::type::both:
      return std::all_of(n.args.begin(), n.args.end(), each);
    case truth_node::type::either:
      if (std::any_of(n.args.begin(), n.args.end(), each))
        return true;
      break;
    case truth_node::type::choose:
      if (holds(n.args[1], cases) && holds(n.args[2], cases))
        return true;
      break;
    default:
      break;
    }
    if (cases == 0)
      return false;
    const std::vector<int> atoms = d_.atoms_of(id, true);
    return std::any_of(atoms.begin(), atoms.end(), [&](int atom) {
      return signs_[static_cast<std::size_t>(atom)] == any_sign && holds_for_each_sign(id, atom, cases - 1);
    });
  }
  bool holds_for_each_sign(int id, int atom, int cases) {
    sign_bits &s = signs_[static_cast<std::size_t>(atom)];
    bool all = true;
    for (const sign_bits one : {1U, 2U, 4U})
      if (all) {
        s = one;
        all = holds(id, cases);
      }
    s = any_sign;
    return all;
  }

  sign_bits set_of(const sign_value &s) const {
    sign_bits out = 1U << (s.unit + 1);
    for (const auto &[atom, exponent] : s.atoms) {
      sign_bits factor = signs_[static_cast<std::size_t>(atom)];
      if (exponent == 2)
        factor = (factor & 2) | ((factor & 5) ? 4U : 0U);
      out = product(out, factor);
    }
    return out;
  }
  truth_bits evaluate(int id) {
    const auto at = static_cast<std::size_t>(id);
    if (at >= known_.size())
      known_.resize(at + 1);
    if (known_[at].of == steps_)
      return known_[at].truth;
    const truth_node &n = d_.at(id);
    const auto of = [&](int a) { return evaluate(a); };
    truth_bits out = unknown;
    switch (n.kind) {
    case truth_node::type::constant:
      out = n.flag ? is_true : is_false;
      break;
    case truth_node::type::test: {
      const sign_bits set = set_of(n.sign), mask = static_cast<sign_bits>(n.flag);
      out = (set & ~mask ? is_false : 0U) | (set & mask ? is_true : 0U);
      break;
    }
    case truth_node::type::both:
    case truth_node::type::either: {
      const truth_bits decisive = n.kind == truth_node::type::both ? is_false : is_true;
      out = decisive ^ unknown;
      for (const int a : n.args) {
        const truth_bits part = of(a);
        if (part == decisive) {
          out = decisive;
          break;
        }
        out |= part;
      }
      break;
    }
    case truth_node::type::negate: {
      const truth_bits part = of(n.args[0]);
      out = part == unknown ? unknown : part ^ unknown;
      break;
    }
    case truth_node::type::choose: {
      const truth_bits condition = of(n.args[0]);
      out = (condition & is_true ? of(n.args[1]) : 0U) | (condition & is_false ? of(n.args[2]) : 0U);
      break;
    }
    }
    known_[at] = {steps_, out};
    return out;
  }
};

} // namespace

bool is_settled_by(const predicate &p, const std::vector<bound::coincidence> &all) {
  decision merged;
  std::vector<sign_value> images;
  for (const poly::poly &atom : p.signs.atoms()) {
    const poly::poly image = bound::with_equal_points(atom, all);
    images.push_back(image == atom ? merged.sign_of_atom(atom) : merged.sign_of(image));
  }
  rewriter rewrite(p.signs, merged, images);
  std::vector<int> wanted{rewrite.of(p.truths.hit)};
  for (const int r : p.truths.reject)
    wanted.push_back(merged.negate(rewrite.of(r)));
  return prover(merged).proves(merged.both(wanted));
}

void find_settled(const predicate &p, bound::kernel_bounds &out) {
  std::vector<bound::coincidence> &all = out.coincidences;
  const auto bit_of = [&](const bound::coincidence &c) -> std::uint32_t {
    auto at = std::find(all.begin(), all.end(), c);
    if (at == all.end() && all.size() < bound::most_coincidences)
      at = all.insert(at, c);
    return at == all.end() ? 0 : std::uint32_t{1} << (at - all.begin());
  };
  const auto joins = [&](const bound::coincidence &c) { return c.x.front() < p.inputs_a && c.y.front() >= p.inputs_a; };
  std::vector<bound::coincidence> open;
  for (const bound::coincidence &c : bound::pairs_of_points(*p.local)) {
    if (!is_settled_by(p, {c}))
      open.push_back(c);
    else if (const std::uint32_t bit = bit_of(c))
      out.settled_by.push_back(bit);
  }
  // Two are tried together if one of them joins the operands.
  for (std::size_t i = 0; i < open.size(); ++i)
    for (std::size_t j = i + 1; j < open.size(); ++j)
      if ((joins(open[i]) || joins(open[j])) && is_settled_by(p, {open[i], open[j]})) {
        const std::uint32_t first = bit_of(open[i]), second = bit_of(open[j]);
        if (first && second)
          out.settled_by.push_back(first | second);
      }
}

} // namespace meetc::lower
