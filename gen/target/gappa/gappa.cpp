// Scripts for Gappa (https://gappa.gitlabpages.inria.fr): each proves the box form of a sign.
//
// Claim (gen/bound/bound.hpp, boxed_signs in runtime/kernel/meetc/decide/boxes.hpp): where every leaf of object A is at most
// alpha, of B at most beta and of the pair at most D, powers of two with alpha, beta <= D, the last operation of the
// sign's graph rounds a number that is within c alpha^a beta^b D^pair of the truth. Why a script states this:
//
// - Values are divided by the powers of (alpha, beta, D) that box_nodes gives their node. Powers of two commute with
//   rounding to 24 bits, except for the subnormals: their spacing, 2^-149, grows to at most 2^box_format_lowest.
// - A term of a sum whose powers differ from those of the sum is multiplied by the quotient, (alpha/D)^i (beta/D)^j, a
//   free number s in [0, 1]. In the static form, alpha = beta = D, it is 1.
// - A leaf is rnd(d) for an exact difference d, or a stored number r: any number in [-1, 1]. alpha, beta and D must bound
//   the exact difference; one slightly above a power of two is rounded to it.
// - Every operation is one rnd of what it computes exactly, an fma as well. The scripts named "unfused" are about the
//   schedule without fma. Constants are exact, or rounded where they
//   have more than 24 bits. Negations and products with powers of two round nothing. The exact twin is the same line
//   without rnd. Nothing is reordered.
// - The last rounding is left out: it keeps the order of a value and a threshold that is itself a float32. A leaf that
//   is a sign has no other rounding and needs no proof.
// - rnd rounds to multiples of 2^box_format_lowest, the code to the same or finer ones. A proof holds for every finer
//   format if it uses only two properties of rnd: how far a number below 2^k moves, and that bounds of 1 and more remain
//   bounds. The tests check which theorems each proof applies.
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

constexpr int precision = 24;

// A dyadic rational in Gappa's notation: 33b-25.
std::string dyadic(const ir::rational &q) {
  const long exponent = static_cast<long>(mpz_sizeinbase(q.get_den().get_mpz_t(), 2)) - 1;
  return exponent ? fmt::format("{}b-{}", q.get_num().get_str(), exponent) : q.get_num().get_str();
}

// An operand of a sum, or a factor. Its sign is kept apart from its text.
struct term {
  std::string text;
  bool negative = false;
};
struct twin {
  term computed, exact;
};

// The text of a script for one sign: a domain that writes a line for every operation and its exact twin.
class script {
public:
  using value = twin;

  // `root` is the last node that rounds; c bounds its error in the powers that `boxes` gives it.
  script(const ir::program &p, const ir::folded<box_node> &boxes, node_id root, const ir::rational &c)
      : boxes_(boxes), root_(root) {
    const auto is_leaf = [&](node_id id) { return bound::leaf_at(p.nodes, id).has_value(); };
    ir::fold(p.nodes, *this, ir::operands_first(p.nodes, root, is_leaf));
    std::string bounds;
    for (const std::string &l : leaves_)
      bounds += fmt::format("{}|{}| <= 1", bounds.empty() ? "" : " /\\\n  ", l);
    for (std::size_t i = 0; i < scales_.size(); ++i)
      bounds += fmt::format(" /\\\n  s{} in [0, 1]", i);
    text_ = fmt::format("@rnd = float<{}, {}, ne>;\n\n{}\n{{ {}\n  -> |v - e| <= {} }}\n", precision,
                        bound::box_format_lowest, lines_, bounds, dyadic(c));
  }

  // Equal for signs that differ only in the names of their leaves.
  const std::string &text() const { return text_; }
  // The leaves, in the order of their numbers.
  const std::vector<bound::leaf> &leaves() const { return meaning_; }

  // ---- the domain ----

  std::optional<value> given(const ir::node_ref &at) {
    const auto l = bound::leaf_at(at.nodes, at.id);
    if (!l)
      return std::nullopt;
    const std::size_t i = meaning_.size();
    meaning_.push_back(*l);
    leaves_.push_back(fmt::format("{}{}", l->subtrahend < 0 ? 'r' : 'd', i));
    if (l->subtrahend >= 0)
      lines_ += fmt::format("t{0} = rnd(d{0});\n", i);
    return value{{l->subtrahend < 0 ? leaves_.back() : fmt::format("t{}", i)}, {leaves_.back()}};
  }
  value input(const ir::node_ref &, int) { return {}; } // a leaf
  value constant(const ir::node_ref &, const ir::rational &q) {
    const ir::rational size = abs(q);
    const bool negative = q < 0, fits = bound::rounded_up(size, precision) == size;
    return {{fmt::format(fmt::runtime(fits ? "{}" : "rnd({})"), size.get_str()), negative}, {size.get_str(), negative}};
  }
  value negate(const ir::node_ref &, const value &x) {
    return {{x.computed.text, !x.computed.negative}, {x.exact.text, !x.exact.negative}};
  }
  value add(const ir::node_ref &at, const value &x, const value &y) {
    const node &n = at.operation();
    return each(at, [&](term twin::*side) {
      const term first = scaled(x.*side, powers_of(n.a), at.id);
      return sum(first, scaled(y.*side, powers_of(n.b), at.id));
    });
  }
  value subtract(const ir::node_ref &at, const value &x, const value &y) { return add(at, x, negate(at, y)); }
  value multiply(const ir::node_ref &at, const value &x, const value &y) {
    return each(at, [&](term twin::*side) {
      const term p = product(x.*side, y.*side);
      return (p.negative ? "-" : "") + p.text;
    });
  }
  value fused(const ir::node_ref &at, const value &x, const value &y, const value &z) {
    const node &n = at.operation();
    const auto [alphas, betas] = powers_of(n.a);
    const auto [more_alphas, more_betas] = powers_of(n.b);
    const std::pair powers{alphas + more_alphas, betas + more_betas};
    return each(at, [&](term twin::*side) {
      const term p = scaled(product(x.*side, y.*side), powers, at.id);
      return sum(p, scaled(z.*side, powers_of(n.c), at.id));
    });
  }

private:
  const ir::folded<box_node> &boxes_;
  node_id root_;
  std::vector<std::pair<int, int>> scales_; // powers of alpha / D and of beta / D
  std::vector<std::string> leaves_;
  std::vector<bound::leaf> meaning_;
  std::string lines_, text_;
  int next_ = 0;

  // Writes an operation, before rounding, on computed and on exact values.
  template <class Operation> value each(const ir::node_ref &at, const Operation &of) {
    const std::string i = at.id == root_ ? "" : fmt::format("{}", next_++);
    const bool rounds = at.id != root_ && !bound::scales_exactly(at.nodes, at.id);
    lines_ += fmt::format(fmt::runtime(rounds ? "v{} = rnd({});\n" : "v{} = {};\n"), i, of(&twin::computed));
    lines_ += fmt::format("e{} = {};\n", i, of(&twin::exact));
    return {{"v" + i}, {"e" + i}};
  }

  static term product(const term &x, const term &y) {
    return {fmt::format("{} * {}", x.text, y.text), x.negative != y.negative};
  }
  static std::string sum(const term &x, const term &y) {
    return fmt::format("{}{} {} {}", x.negative ? "-" : "", x.text, y.negative ? '-' : '+', y.text);
  }

  std::pair<int, int> powers_of(node_id id) const { return {boxes_.at(id).a, boxes_.at(id).b}; }

  // A term with these powers, in a sum that may have lower ones.
  term scaled(const term &x, std::pair<int, int> powers, node_id in_sum) {
    const auto [a, b] = powers_of(in_sum);
    const std::pair<int, int> quotient{powers.first - a, powers.second - b};
    if (quotient == std::pair{0, 0})
      return x;
    auto at = std::find(scales_.begin(), scales_.end(), quotient);
    if (at == scales_.end())
      at = scales_.insert(at, quotient);
    const bool is_product = x.text.find(' ') != std::string::npos;
    return {fmt::format(fmt::runtime(is_product ? "s{} * ({})" : "s{} * {}"), at - scales_.begin(), x.text),
            x.negative};
  }
};

// A script with the signs that it covers.
struct proof {
  std::string name, text, first;
  std::vector<std::string> covers; // "side_triangle_point, common: 0"
};

// The meaning of the script's names, for the first sign that it covers.
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

void check_bounded(const unit &u, std::size_t kernel) {
  if (!u.kernels[kernel].is_predicate)
    throw spec_error({}, "only predicates and signs have error bounds; this is a formula");
  if (!u.bounds[kernel])
    throw spec_error({}, "the scene asks for neither 'exact' nor 'certified', so nothing bounds its errors");
}

std::vector<bounded_stage> bounded_stages(const unit &u, std::size_t i) {
  std::vector<bounded_stage> out;
  if (!u.bounds[i])
    return out;
  const auto signs = lower::stages(u.kernels[i].decision);
  const auto bounds = lower::stages(*u.bounds[i]);
  for (std::size_t s = 0; s < signs.size(); ++s)
    if (!signs[s]->atoms.empty())
      out.push_back({lower::name_of(lower::stage_kinds[s]), *signs[s], *bounds[s]});
  return out;
}

std::vector<file> proof_files(const unit &u) {
  std::vector<proof> proofs;
  std::map<std::string, std::size_t> known; // by text
  for (std::size_t i = 0; i < u.kernels.size(); ++i)
    for (const bounded_stage &stage : bounded_stages(u, i)) {
      const std::string kernel = u.kernels[i].asked.name();
      if (stage.bounds.box.empty()) // there is no box form
        continue;
      const auto prove = [&](const ir::program &p, const bound::stage_bounds &bounds, const char *schedule) {
        const ir::folded<box_node> boxes = bound::box_nodes(p, precision, bound::box_format_lowest);
        std::map<std::pair<std::size_t, std::string>, std::string> covers; // of one stage, by proof and powers
        for (std::size_t sign = 0; sign < p.results.size(); ++sign) {
          const bound::box_bound &bound = bounds.box[sign];
          if (bound.value == 0) // a leaf: the sign of its only rounding
            continue;
          const auto [root, scale] = bound::last_rounding_of(p.nodes, p.results[sign]);
          const script s(p, boxes, root, bound.value / scale);
          const auto [at, fresh] = known.try_emplace(s.text(), proofs.size());
          if (fresh)
            proofs.push_back({fmt::format("{}_{}_{}{}", kernel, stage.name, sign, schedule),
                              s.text(),
                              meaning(u.kernels[i], s, stage.signs.atoms[sign]),
                              {}});
          covers[{at->second, powers_text(bound)}] += fmt::format(" {}", sign);
        }
        for (const auto &[which, signs] : covers)
          proofs[which.first].covers.push_back(
              fmt::format("{} {}{}:{}; c {}", kernel, stage.name, schedule, signs, which.second));
      };
      prove(stage.signs.code, stage.bounds, "");
      prove(stage.bounds.unfused->code, stage.bounds.unfused->bounds, "_unfused");
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

std::string show_proofs(const unit &u, std::size_t kernel) {
  check_bounded(u, kernel);
  std::string out;
  for (const file &f : proof_files(u))
    out += fmt::format("{}# {}\n{}", out.empty() ? "" : "\n", f.path, f.text);
  return out;
}

} // namespace meetc::target
