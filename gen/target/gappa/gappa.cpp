// Scripts for Gappa (https://gappa.gitlabpages.inria.fr): each proves the box form of a sign.
//
// Claim (gen/bound/bound.hpp, boxed_signs in runtime/kernel/meetc/boxes.hpp): where every leaf of object A is at most alpha, of B at
// most beta and of the pair at most D, powers of two with alpha, beta <= D, the last operation of the sign's graph
// rounds a number that is within c alpha^a beta^b D^pair of the truth. Why a script says that:
//
// - Values are divided by the powers of (alpha, beta, D) that box_nodes gives their node. Powers of two commute with
//   rounding to 24 bits, but for the subnormals: their spacing, 2^-149, grows to at most 2^box_format_lowest.
// - A term of a sum that has other powers than the sum is multiplied by the quotient, (alpha/D)^i (beta/D)^j, a free
//   number s in [0, 1]. In the static form, alpha = beta = D, it is 1.
// - A leaf is rnd(d) for an exact difference d, or a stored number r: any number in [-1, 1]. It is the exact
//   difference that alpha, beta and D must bound; one that is a little more than a power of two is rounded to it.
// - Every operation is one rnd of what it computes exactly, an fma's too; constants are exact, or rounded where they
//   have more than 24 bits; negations and products with powers of two round nothing. The exact twin is the same line
//   without rnd. Nothing is reordered.
// - The last rounding is left out: it keeps the order of a value and a threshold that is itself a float32. A leaf that
//   is a sign has no other and needs no proof.
// - rnd rounds to multiples of 2^box_format_lowest, the code to the same or finer ones. A proof holds for every finer
//   format if all that it uses of rnd is how far a number below 2^k moves, and that numbers of 1 and more bound what
//   they bounded. The tests look at the theorems that each proof applies.
// - No value overflows: D is at most 2^box_highest.
#include "gen/target/gappa/gappa.hpp"

#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace meetc::target {
namespace {
using bound::box_node;
using ir::node;
using ir::node_id;
using ir::op;

constexpr int precision = 24;

// A dyadic rational as Gappa reads it: 33b-25.
std::string dyadic(const ir::rational &q) {
  const long exponent = static_cast<long>(mpz_sizeinbase(q.get_den().get_mpz_t(), 2)) - 1;
  return exponent ? fmt::format("{}b-{}", q.get_num().get_str(), exponent) : q.get_num().get_str();
}

// A sum's operand or a factor: its sign stands apart from its text.
struct term {
  std::string text;
  bool negative = false;
};
struct twin {
  term computed, exact;
};

// A script's text, for one sign.
class script {
public:
  // `root` rounds, and nothing after it does; c bounds its error in the powers that `boxes` gives it.
  script(const ir::program &p, const std::vector<box_node> &boxes, node_id root, const ir::rational &c)
      : p_(p), boxes_(boxes), root_(root) {
    for (const node_id id : operands_first())
      write(id);
    std::string bounds;
    for (const std::string &l : leaves_)
      bounds += fmt::format("{}|{}| <= 1", bounds.empty() ? "" : " /\\\n  ", l);
    for (std::size_t i = 0; i < scales_.size(); ++i)
      bounds += fmt::format(" /\\\n  s{} in [0, 1]", i);
    text_ = fmt::format("@rnd = float<{}, {}, ne>;\n\n{}\n{{ {}\n  -> |v - e| <= {} }}\n", precision,
                        bound::box_format_lowest, lines_, bounds, dyadic(c));
  }

  // Equal for signs that are the same but for the names of their leaves.
  const std::string &text() const { return text_; }
  // What the leaves are, in the order of their numbers.
  const std::vector<bound::leaf> &leaves() const { return meaning_; }

private:
  const ir::program &p_;
  const std::vector<box_node> &boxes_;
  node_id root_;
  std::map<node_id, twin> value_;
  std::vector<std::pair<int, int>> scales_; // powers of alpha / D and of beta / D
  std::vector<std::string> leaves_;
  std::vector<bound::leaf> meaning_;
  std::string lines_, text_;
  int next_ = 0;

  // The nodes that the root needs, in an order that depends on the shape alone.
  std::vector<node_id> operands_first() const {
    std::vector<node_id> out;
    std::vector<std::pair<node_id, bool>> stack{{root_, false}};
    std::set<node_id> seen;
    while (!stack.empty()) {
      const auto [id, ready] = stack.back();
      stack.pop_back();
      if (ready) {
        out.push_back(id);
      } else if (seen.insert(id).second) {
        stack.emplace_back(id, true);
        const node &n = p_.nodes.at(id);
        if (n.kind != op::constant && !bound::leaf_at(p_, id))
          for (const node_id operand : {n.c, n.b, n.a}) // a is pushed last and comes first
            if (operand >= 0)
              stack.emplace_back(operand, false);
      }
    }
    return out;
  }

  void write(node_id id) {
    const node &n = p_.nodes.at(id);
    if (const auto l = bound::leaf_at(p_, id)) {
      const std::size_t i = meaning_.size();
      meaning_.push_back(*l);
      leaves_.push_back(fmt::format("{}{}", l->subtrahend < 0 ? 'r' : 'd', i));
      if (l->subtrahend >= 0)
        lines_ += fmt::format("t{0} = rnd(d{0});\n", i);
      value_[id] = {{l->subtrahend < 0 ? leaves_.back() : fmt::format("t{}", i)}, {leaves_.back()}};
    } else if (n.kind == op::constant) {
      const ir::rational q = abs(p_.nodes.value(id));
      const bool negative = p_.nodes.value(id) < 0, fits = bound::rounded_up(q, precision) == q;
      value_[id] = {{fmt::format(fmt::runtime(fits ? "{}" : "rnd({})"), q.get_str()), negative},
                    {q.get_str(), negative}};
    } else if (n.kind == op::negate) {
      const twin &of = value_.at(n.a);
      value_[id] = {{of.computed.text, !of.computed.negative}, {of.exact.text, !of.exact.negative}};
    } else {
      const std::string i = id == root_ ? "" : fmt::format("{}", next_++);
      const bool rounds = id != root_ && !bound::scales_exactly(p_, id);
      lines_ +=
          fmt::format(fmt::runtime(rounds ? "v{} = rnd({});\n" : "v{} = {};\n"), i, operation(id, &twin::computed));
      lines_ += fmt::format("e{} = {};\n", i, operation(id, &twin::exact));
      value_[id] = {{"v" + i}, {"e" + i}};
    }
  }

  // What an operation computes, before it rounds.
  std::string operation(node_id id, term twin::*side) {
    const node &n = p_.nodes.at(id);
    const auto of = [&](node_id i) { return value_.at(i).*side; };
    if (n.kind == op::add || n.kind == op::subtract) {
      const term x = scaled(of(n.a), powers_of(n.a), id);
      term y = scaled(of(n.b), powers_of(n.b), id);
      y.negative = y.negative != (n.kind == op::subtract);
      return sum(x, y);
    }
    const term a = of(n.a), b = of(n.b);
    const term product{fmt::format("{} * {}", a.text, b.text), a.negative != b.negative};
    if (n.kind == op::multiply)
      return (product.negative ? "-" : "") + product.text;
    const auto [alphas, betas] = powers_of(n.a);
    const auto [more_alphas, more_betas] = powers_of(n.b);
    const term x = scaled(product, {alphas + more_alphas, betas + more_betas}, id);
    return sum(x, scaled(of(n.c), powers_of(n.c), id));
  }

  static std::string sum(const term &x, const term &y) {
    return fmt::format("{}{} {} {}", x.negative ? "-" : "", x.text, y.negative ? '-' : '+', y.text);
  }

  std::pair<int, int> powers_of(node_id id) const {
    const box_node &n = boxes_[static_cast<std::size_t>(id)];
    return {n.a, n.b};
  }

  // A term with these powers, in a sum that may have less.
  term scaled(const term &x, std::pair<int, int> powers, node_id in_sum) {
    const auto [a, b] = powers_of(in_sum);
    const std::pair<int, int> quotient{powers.first - a, powers.second - b};
    if (quotient == std::pair{0, 0})
      return x;
    auto at = std::find(scales_.begin(), scales_.end(), quotient);
    if (at == scales_.end())
      at = scales_.insert(at, quotient);
    const bool product = x.text.find(' ') != std::string::npos;
    return {fmt::format(fmt::runtime(product ? "s{} * ({})" : "s{} * {}"), at - scales_.begin(), x.text), x.negative};
  }
};

// A script with the signs that it is of.
struct proof {
  std::string name, text, first;
  std::vector<std::string> covers; // "side_triangle_point, common: 0"
};

// What the script's names are, for the sign that it was first made for.
std::string meaning(const lower::kernel &k, const script &s, int atom) {
  const lower::predicate &p = k.decision;
  std::string out = wrapped(poly_with_names(p.signs.atoms()[static_cast<std::size_t>(atom)], p.stored_inputs), "#   ");
  const auto input = [&](int i) { return p.stored_inputs[static_cast<std::size_t>(i)]; };
  for (std::size_t i = 0; i < s.leaves().size(); ++i) {
    const bound::leaf &l = s.leaves()[i];
    const char *of = l.where == poly::residency::a ? "A" : l.where == poly::residency::b ? "B" : "the pair";
    out += l.subtrahend < 0 ? fmt::format("#   r{} = {}, of {}\n", i, input(l.minuend), of)
                            : fmt::format("#   d{} = {} - {}, of {}\n", i, input(l.minuend), input(l.subtrahend), of);
  }
  return out;
}
} // namespace

std::vector<bounded_stage> bounded_stages(const unit &u, std::size_t i) {
  std::vector<bounded_stage> out;
  if (!u.bounds[i])
    return out;
  const lower::predicate &p = u.kernels[i].decision;
  for (const bounded_stage &s :
       {bounded_stage{"reject", p.reject, u.bounds[i]->reject}, bounded_stage{"common", p.common, u.bounds[i]->common},
        bounded_stage{"rare", p.rare, u.bounds[i]->rare}})
    if (!s.signs.atoms.empty())
      out.push_back(s);
  return out;
}

std::vector<file> proof_files(const unit &u) {
  std::vector<proof> proofs;
  std::map<std::string, std::size_t> known; // by text
  for (std::size_t i = 0; i < u.kernels.size(); ++i)
    for (const bounded_stage &stage : bounded_stages(u, i)) {
      const ir::program &p = stage.signs.code;
      const std::vector<box_node> boxes = bound::box_nodes(p, precision, bound::box_format_lowest);
      const std::string kernel = u.kernels[i].asked.name();
      std::map<std::pair<std::size_t, std::string>, std::string> covers; // of one stage, by proof and powers
      for (std::size_t sign = 0; sign < p.results.size(); ++sign) {
        const bound::box_bound &bound = stage.bounds.box[sign];
        if (bound.value == 0) // a leaf: the sign of its only rounding
          continue;
        const auto [root, scale] = bound::last_rounding_of(p, p.results[sign]);
        const script s(p, boxes, root, bound.value / scale);
        const auto [at, fresh] = known.try_emplace(s.text(), proofs.size());
        if (fresh)
          proofs.push_back({fmt::format("{}_{}_{}", kernel, stage.name, sign),
                            s.text(),
                            meaning(u.kernels[i], s, stage.signs.atoms[sign]),
                            {}});
        covers[{at->second, powers_text(bound)}] += fmt::format(" {}", sign);
      }
      for (const auto &[which, signs] : covers)
        proofs[which.first].covers.push_back(fmt::format("{} {}:{}; c {}", kernel, stage.name, signs, which.second));
    }
  std::vector<file> out;
  for (const proof &p : proofs) {
    std::string text =
        banner(u.scene, "The error of these signs in fp32 before the last rounding, in their box form:", "#");
    for (const std::string &c : p.covers)
      text += wrapped(c, "#   ");
    out.push_back({fmt::format("{}/proofs/{}.gappa", identifier(u.scene.space), p.name),
                   text + "# The first of them is the sign of\n" + p.first + p.text});
  }
  std::sort(out.begin(), out.end(), [](const file &a, const file &b) { return a.path < b.path; });
  return out;
}

} // namespace meetc::target
