// Formulas: a multivector-valued expression on general blades, and a number on stored operands as well.
#include "gen/ir/count.hpp"
#include "gen/ir/fold.hpp"
#include "gen/ir/residue.hpp"
#include "gen/lower/kernel/assume.hpp"
#include "gen/lower/kernel/compile.hpp"
#include "gen/lower/programs/compose.hpp"
#include "gen/search/searched_forms.hpp"

#include <algorithm>
#include <stdexcept>

namespace meetc::lower {
namespace {

// Numbers that no translation moves, for operands that are blades.
std::vector<poly::stored_number> unmoved(const std::vector<std::size_t> &sizes) {
  std::vector<poly::stored_number> out;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    for (std::size_t k = 0; k < sizes[i]; ++k)
      out.push_back({static_cast<int>(i), -1, 0, false});
  return out;
}

// A value expanded into hundreds of terms is never cheaper than one computed from the coefficients of its parts.
constexpr std::size_t longest_direct = 150; // number of terms
// A formula that takes more to expand, about a second, is not expanded.
constexpr long most_steps_of_formula = 50'000;
constexpr std::size_t longest_from_stored = 4000; // terms of a number

// The formula's values on blades and the ways to compute them.
class on_blades {
public:
  on_blades(const model &m, const request &r, formula &out) : model_(m), request_(r), out_(out) {
    for (const lang::kind *k : r.kinds)
      supports_.push_back(support(m, *k));
    for (std::size_t i = 0; i < supports_.size(); ++i)
      for (const blade b : supports_[i])
        out.blade_inputs.push_back(r.names[i] + '.' + m.working().name(b));
    out.numbers = std::make_shared<poly::ring>(out.blade_inputs);
  }

  // Fills in what the formula says of blades.
  void compile() {
    std::vector<std::size_t> sizes;
    for (const auto &blades : supports_)
      sizes.push_back(blades.size());
    const poly::local_origin origin(*out_.numbers, unmoved(sizes));
    builder code(origin, prefer::operations);
    expand();
    std::vector<std::vector<node_id>> forms;
    if (whole_) {
      std::set<blade> where;
      for (const auto &[at, c] : whole_->terms())
        where.insert(at);
      out_.result = sorted_blades(model_.working(), where);
      for (const blade at : out_.result)
        out_.polynomials.push_back(*whole_->find(at));
      if (std::all_of(out_.polynomials.begin(), out_.polynomials.end(),
                      [](const poly::poly &c) { return c.length() <= longest_direct; })) {
        forms.emplace_back();
        for (const poly::poly &c : out_.polynomials)
          forms.back().push_back(code.build(c));
      }
    }
    for (const parts which : {parts::arguments, parts::all})
      if (const auto way = composed(code, which)) {
        if (!whole_ && forms.empty()) { // a composed value may have more coefficients than the formula
          std::set<blade> where;
          for (const auto &[at, id] : without_zeros(code, *way))
            where.insert(at);
          out_.result = sorted_blades(model_.working(), where);
        }
        forms.emplace_back();
        for (const blade at : out_.result) {
          const auto it = way->find(at);
          if (it == way->end())
            throw std::logic_error("a composed value lacks a coefficient");
          forms.back().push_back(it->second);
        }
      }
    if (whole_)
      for (const search::found_program &f :
           search::searched_forms(code.nodes(), subject(), inputs(code), poly::price::whole))
        forms.push_back(f.outputs);
    if (out_.result.empty()) { // identically zero
      out_.result = {0};
      out_.polynomials = {poly::poly(*out_.numbers)};
      forms = {{code.nodes().constant(0)}};
    }
    out_.from_blades = best_of(code, forms);
    if (out_.from_blades.results.size() != out_.result.size())
      throw std::logic_error("a formula lacks a result");
    if (whole_ ? !ir::same_values(out_.from_blades, out_.polynomials, *out_.numbers) : !has_values_of_body())
      throw std::logic_error("a formula's program has other values than its expression");
    out_.result_names = named(model_.working(), out_.result);
    if (whole_)
      assume(
          model_, request_, supports_, subject(), inputs(code),
          [&](const std::vector<multivector> &operands) { return written(code, operands); }, code, out_);
  }

private:
  const model &model_;
  const request &request_;
  formula &out_;
  std::vector<std::vector<blade>> supports_;
  std::optional<multivector> whole_; // nothing where it is too long

  void expand() {
    decision unused;
    expander of(model_, *out_.numbers, unused);
    of.limit(most_steps_of_formula);
    environment env;
    auto from = out_.blade_inputs.begin();
    for (std::size_t i = 0; i < supports_.size(); ++i) {
      const auto to = from + static_cast<std::ptrdiff_t>(supports_[i].size());
      env.emplace_back(request_.names[i], of.general(supports_[i], {from, to}));
      from = to;
    }
    try {
      whole_ = of.evaluate_multivector(*request_.body, env);
    } catch (const too_long &) {
      // It is composed of its parts, which says so again where they are too long, too.
    }
  }

  // The expanded values, for searches.
  search::product_subject subject() const {
    search::product_subject out{model_.working(), *out_.numbers, {}, out_.result, out_.polynomials};
    int input = 0;
    for (const auto &blades : supports_) {
      multivector operand;
      for (const blade b : blades)
        operand.add(b, poly::poly::variable(*out_.numbers, input++));
      out.operands.push_back(std::move(operand));
    }
    return out;
  }
  std::vector<node_id> inputs(builder &code) const {
    std::vector<node_id> out;
    for (int i = 0; i < out_.numbers->size(); ++i)
      out.push_back(code.nodes().input(i));
    return out;
  }

  std::optional<node_values> composed(builder &code, parts which) const {
    composer::scope names;
    int first = 0;
    for (std::size_t i = 0; i < supports_.size(); ++i) {
      names.emplace_back(request_.names[i], composer::inputs(code, supports_[i], first));
      first += static_cast<int>(supports_[i].size());
    }
    return composed(code, which, names);
  }

  // The programs as they were written, for operands whose coefficients are inputs or numbers.
  std::vector<std::vector<node_id>> written(builder &code, const std::vector<multivector> &operands) const {
    composer::scope names;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      node_values v;
      for (const auto &[at, c] : operands[i].terms())
        v.emplace(at, code.build(c));
      names.emplace_back(request_.names[i], std::move(v));
    }
    std::vector<std::vector<node_id>> out;
    for (const parts which : {parts::arguments, parts::all})
      if (const auto way = composed(code, which, names)) {
        out.emplace_back();
        for (const blade at : out_.result) {
          const auto it = way->find(at);
          out.back().push_back(it == way->end() ? code.nodes().constant(0) : it->second);
        }
      }
    return out;
  }

  std::optional<node_values> composed(builder &code, parts which, const composer::scope &names) const {
    try {
      return composer(model_, code, which, out_.polynomials).compose(*request_.body, names);
    } catch (const spec_error &) { // where it expands, it is not this way's to refuse
      if (!whole_ && which == parts::arguments)
        throw;
      return std::nullopt;
    }
  }

  // Whether the program has the values that the expression has at the points of the residues.
  bool has_values_of_body() const {
    const poly::ring none({});
    std::vector<std::vector<rational>> values(out_.result.size());
    for (int point = 0; point < ir::residue_points; ++point) {
      decision unused;
      expander of(model_, none, unused);
      of.allow_bits(1 << 16); // degree 100 in numbers of 61 bits, and room for constants
      environment env;
      int input = 0;
      for (std::size_t i = 0; i < supports_.size(); ++i) {
        multivector m;
        for (const blade b : supports_[i])
          m.add(b, {none, rational(mpz_class(std::to_string(ir::residue_input(point, input++))))});
        env.emplace_back(request_.names[i], value{m});
      }
      const multivector v = of.evaluate_multivector(*request_.body, env);
      for (const auto &[at, c] : v.terms())
        if (std::find(out_.result.begin(), out_.result.end(), at) == out_.result.end())
          return false;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const poly::poly *c = v.find(out_.result[i]);
        values[i].push_back(c ? c->constant() : rational(0));
      }
    }
    const auto have = ir::residues(out_.from_blades);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (have[i] != ir::residues(values[i]))
        return false;
    return true;
  }
};

// A number computed from the operands' stored numbers.
class from_stored {
public:
  from_stored(const model &m, const request &r)
      : model_(m), request_(r), stored_(stored_numbers(m, r.names, r.kinds)), local_(*stored_.numbers, stored_.moves) {
    decision unused;
    expander of(m, *stored_.numbers, unused);
    of.limit(most_steps_of_formula);
    environment objects;
    for (std::size_t i = 0; i < r.kinds.size(); ++i) {
      objects.emplace_back(r.names[i], of.operand(*r.kinds[i], r.names[i] + '.'));
      blades_.push_back(of.blade_of(objects.back().second, r.where));
    }
    try {
      const multivector v = of.evaluate_multivector(*r.body, objects);
      value_ = v.is_zero() ? poly::poly(*stored_.numbers) : v.terms().begin()->second;
      if (value_->length() > longest_from_stored)
        value_.reset();
    } catch (const too_long &) {
    }
  }

  // on_blades: the same formula, with its program on blades.
  program compile(prefer by, const formula &on_blades) const {
    builder code(local_, by);
    if (!value_)
      return code.finish({of_blades(code)});
    node_id best = code.build(*value_);
    // Differences are kept: the blades of a value that no translation changes hold squares of coordinates that cancel.
    if (local_.is_invariant(*value_))
      return code.finish({best});
    try {
      std::vector<node_id> others{of_blades(code)};
      if (on_blades.assumed.taken.empty())
        others.push_back(placed(code, on_blades.from_blades));
      const auto cost = [&](node_id id) {
        const int all = ir::count(code.nodes(), {id}).total();
        return std::pair(by == prefer::pair ? ir::count(code.nodes(), {id}, residency::pair).total() : all, all);
      };
      for (const node_id other : others)
        if (cost(other) < cost(best) && ir::same_values({code.nodes(), {other}}, {*value_}, *stored_.numbers))
          best = other;
    } catch (const spec_error &) { // it is expanded all the same
    }
    return code.finish({best});
  }

  const std::shared_ptr<poly::ring> &numbers() const { return stored_.numbers; }

private:
  const model &model_;
  const request &request_;
  stored_ring stored_;
  poly::local_origin local_;
  std::vector<multivector> blades_;
  std::optional<poly::poly> value_; // nothing where it is too long

  // A program on blades over the blades of the stored numbers.
  node_id placed(builder &code, const program &p) const {
    struct domain {
      using value = node_id;
      arena &to;
      std::vector<node_id> inputs;
      value input(const ir::node_ref &, int number) const { return inputs[static_cast<std::size_t>(number)]; }
      value constant(const ir::node_ref &, const rational &q) { return to.constant(q); }
      value negate(const ir::node_ref &, value x) { return to.negate(x); }
      value add(const ir::node_ref &, value x, value y) { return to.add(x, y); }
      value subtract(const ir::node_ref &, value x, value y) { return to.subtract(x, y); }
      value multiply(const ir::node_ref &, value x, value y) { return to.multiply(x, y); }
      value fused(const ir::node_ref &, value x, value y, value z) { return to.fused(x, y, z); }
    } d{code.nodes(), {}};
    for (std::size_t i = 0; i < blades_.size(); ++i)
      for (const blade b : support(model_, *request_.kinds[i])) {
        const poly::poly *c = blades_[i].find(b);
        d.inputs.push_back(c ? code.build(*c) : code.nodes().constant(0));
      }
    return ir::fold(p, d).at(p.results[0]);
  }

  // The value composed of the operands' blades.
  node_id of_blades(builder &code) const {
    composer::scope names;
    for (std::size_t i = 0; i < blades_.size(); ++i) {
      node_values v;
      for (const auto &[at, c] : blades_[i].terms())
        v.emplace(at, code.build(c));
      names.emplace_back(request_.names[i], std::move(v));
    }
    const node_values v = composer(model_, code, parts::arguments).compose(*request_.body, names);
    const auto it = v.find(0);
    return it == v.end() ? code.nodes().constant(0) : it->second;
  }
};

} // namespace

formula compile_formula(const model &m, const request &r) {
  formula out;
  on_blades(m, r, out).compile();
  if (!out.is_number()) {
    out.result_kind = kind_of_value(m, out.result);
    return out;
  }
  // A number is also computed directly from stored operands, in differences where possible.
  const from_stored stored(m, r);
  out.stored_numbers = stored.numbers();
  out.stored_inputs = out.stored_numbers->names();
  out.from_stored = stored.compile(prefer::operations, out);
  if (r.kinds.size() == 2) {
    program p = stored.compile(prefer::pair, out);
    if (ir::count(p, residency::a).total() + ir::count(p, residency::b).total() > 0)
      out.for_pairs = std::move(p);
  }
  return out;
}

} // namespace meetc::lower
