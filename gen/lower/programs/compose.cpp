#include "gen/lower/programs/compose.hpp"

#include "gen/ir/count.hpp"
#include "gen/ir/residue.hpp"
#include "gen/search/searched_forms.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace meetc::lower {
namespace {
using kind = lang::op;

constexpr std::size_t longest = 150;      // terms of a coefficient that is expanded
constexpr long most_steps_tried = 20'000; // of an expansion that may turn out long
constexpr int most_degree = 100;          // as in expansion

const node_values *find(const composer::scope &names, const std::string &name) {
  const auto it = std::find_if(names.rbegin(), names.rend(), [&](const auto &n) { return n.first == name; });
  return it == names.rend() ? nullptr : &it->second;
}

// Names for the parts of an expression, which no spec can have.
std::string part_name(std::size_t i) {
  return fmt::format("#{}", i);
}

lang::expr name_of_part(const lang::expr &part, std::size_t i) {
  lang::expr out = part;
  out.kind = kind::name;
  out.text = part_name(i);
  out.args.clear();
  out.binders.clear();
  return out;
}

// A scope's values as an expander takes them: numbers, variables, and their negatives.
class variables {
public:
  variables(const arena &nodes, const composer::scope &names) : nodes_(nodes) {
    for (const auto &[name, value] : names)
      for (const auto &[at, id] : value)
        add(id);
  }

  const std::vector<node_id> &leaves() const { return leaves_; }
  std::vector<std::string> ring_names() const {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < leaves_.size(); ++i)
      out.push_back(fmt::format("v{}", i));
    return out;
  }
  bool all_inputs() const {
    return std::all_of(leaves_.begin(), leaves_.end(), [&](node_id id) { return nodes_.at(id).kind == ir::op::input; });
  }
  // With `inputs`, variables are numbered as the program's inputs.
  poly::poly coefficient(node_id id, const poly::ring &ring, bool inputs) const {
    if (nodes_.at(id).kind == ir::op::constant)
      return {ring, nodes_.value(id)};
    const bool negative = nodes_.at(id).kind == ir::op::negate;
    const node_id leaf = negative ? nodes_.at(id).a : id;
    const int v = inputs ? nodes_.at(leaf).a
                         : static_cast<int>(std::find(leaves_.begin(), leaves_.end(), leaf) - leaves_.begin());
    return poly::poly::variable(ring, v).scaled(negative ? -1 : 1);
  }

private:
  const arena &nodes_;
  std::vector<node_id> leaves_;

  void add(node_id id) {
    const node &n = nodes_.at(id);
    if (n.kind == ir::op::constant)
      return;
    const node_id leaf = n.kind == ir::op::negate ? n.a : id;
    if (std::find(leaves_.begin(), leaves_.end(), leaf) == leaves_.end())
      leaves_.push_back(leaf);
  }
};

void mentioned(const lang::expr &e, const composer::scope &names, composer::scope &out) {
  if (e.kind == kind::name && !find(out, e.text))
    if (const node_values *v = find(names, e.text))
      out.emplace_back(e.text, *v);
  for (const lang::binder &b : e.binders)
    mentioned(*b.over, names, out);
  for (const lang::expr_ptr &arg : e.args)
    mentioned(*arg, names, out);
}

} // namespace

node_values without_zeros(const builder &code, const node_values &v) {
  std::vector<node_id> ids;
  for (const auto &[at, id] : v)
    ids.push_back(id);
  const auto residues = ir::residues(program{code.nodes(), ids});
  node_values out;
  auto of = residues.begin();
  for (const auto &[at, id] : v)
    if (const ir::residue_list &r = *of++; std::any_of(r.begin(), r.end(), [](std::uint64_t x) { return x != 0; }))
      out.emplace(at, id);
  return out;
}

node_values composer::inputs(builder &code, const std::vector<blade> &blades, int first) {
  node_values out;
  for (const blade b : blades)
    out.emplace(b, code.nodes().input(first++));
  return out;
}

void composer::charge(long steps, const location &where) {
  steps_ += steps;
  if (steps_ > most_steps)
    throw too_long(where, fmt::format("this expands to more than {} steps", most_steps));
}

int composer::degree(node_id id) const {
  const node &n = code_.nodes().at(id);
  if (n.kind == ir::op::constant)
    return 0;
  const auto it = degrees_.find(n.kind == ir::op::negate ? n.a : id);
  return it == degrees_.end() ? 1 : it->second;
}

// Expands over the values that the names stand for. Throws too_long; with `is_short` also where a coefficient is long.
node_values composer::expanded(const lang::expr &e, const scope &names, long most, bool is_short) {
  scope used;
  mentioned(e, names, used);
  const variables of(code_.nodes(), used);
  const bool inputs = of.all_inputs();
  const poly::ring own(inputs ? std::vector<std::string>{} : of.ring_names());
  const poly::ring &ring = inputs ? code_.numbers() : own;
  decision unused;
  expander expand(model_, ring, unused);
  expand.limit(std::min(most, most_steps - steps_));
  environment env;
  for (const auto &[name, value] : used) {
    multivector m;
    for (const auto &[at, id] : value)
      m.add(at, of.coefficient(id, ring, inputs));
    env.emplace_back(name, lower::value{m});
  }
  multivector found;
  try {
    found = expand.evaluate_multivector(e, env);
  } catch (const too_long &) {
    charge(expand.steps() / (is_short ? 4 : 1), e.where); // what was only tried costs less
    throw;
  }
  charge(expand.steps(), e.where);
  for (const auto &[at, c] : found.terms())
    if (is_short && c.length() > longest)
      throw too_long(e.where, "a coefficient of this is long");
  node_values out;
  for (const auto &[at, c] : found.terms()) {
    int highest = 0;
    for (const poly::term &t : c.terms()) {
      int sum = 0;
      for (const poly::power &f : t.factors)
        sum += f.exponent * (inputs ? 1 : degree(of.leaves()[static_cast<std::size_t>(f.variable)]));
      highest = std::max(highest, sum);
    }
    if (highest > most_degree)
      throw spec_error(e.where, fmt::format("this is of a degree above {}", most_degree));
    const node_id id = inputs ? code_.build(c) : code_.build_over(c, of.leaves());
    const node &n = code_.nodes().at(id);
    degrees_[n.kind == ir::op::negate ? n.a : id] = highest;
    out.emplace(at, id);
  }
  if (!is_short)
    return out;
  search::product_subject subject{model_.working(), ring, {}, {}, {}};
  for (const auto &[name, value] : env)
    subject.operands.push_back(std::get<multivector>(value.is));
  for (const auto &[at, c] : found.terms()) {
    subject.result.push_back(at);
    subject.values.push_back(c);
  }
  if (subject.values == searched_ || !repeats_an_operand(subject))
    return out;
  std::vector<node_id> leaves = of.leaves();
  if (inputs) {
    leaves.clear();
    for (int v = 0; v < ring.size(); ++v)
      leaves.push_back(code_.nodes().input(v));
  }
  const node_values plain = out;
  for (const search::found_program &f : search::searched_forms(code_.nodes(), subject, leaves, poly::price::whole)) {
    node_values other;
    for (std::size_t i = 0; i < subject.result.size(); ++i)
      other.emplace(subject.result[i], f.outputs[i]);
    out = cheaper(out, other);
  }
  for (const auto &[at, id] : out) {
    const auto bare = [&](node_id x) { return code_.nodes().at(x).kind == ir::op::negate ? code_.nodes().at(x).a : x; };
    degrees_[bare(id)] = degrees_.at(bare(plain.at(at)));
  }
  return out;
}

node_values composer::cheaper(const node_values &x, const node_values &y) const {
  node_values same; // y, with the coefficients of x alone
  std::vector<node_id> of_x, of_y;
  for (const auto &[at, id] : x) {
    const auto it = y.find(at);
    if (it == y.end())
      return x;
    same.emplace(at, it->second);
    of_x.push_back(id);
    of_y.push_back(it->second);
  }
  const auto cost = [&](const std::vector<node_id> &of) { return ir::count(code_.nodes(), of).total(); };
  return cost(of_y) < cost(of_x) ? same : x;
}

// Whether the expression is a value already, or nothing but numbers, so that there is no part to compute first.
bool composer::is_value(const lang::expr &e) const {
  return e.kind == kind::name || e.kind == kind::number;
}

// f(parts): the parts become values, and the body of f is composed of them.
node_values composer::of_call(const lang::expr &e, const scope &names) {
  const lang::function *f = model_.spec().find_function(e.text);
  if (const lang::builtin *of = lang::called_builtin(model_.spec(), e); of && of->params.size() == e.args.size())
    return of_builtin(*of, e, names);
  if (!f || f->params.size() != e.args.size())
    return expanded(e, names, most_steps, false);
  scope inner;
  poly::ring none({});
  decision unused;
  expander check(model_, none, unused);
  std::vector<value> grades; // of the arguments, for the domain
  for (std::size_t i = 0; i < e.args.size(); ++i) {
    node_values argument = compose(*e.args[i], names);
    if (f->domain)
      argument = without_zeros(code_, argument);
    inner.emplace_back(f->params[i], std::move(argument));
    multivector m;
    for (const auto &[at, id] : inner.back().second)
      m.add(at, poly::poly(none, 1));
    grades.push_back({m});
  }
  check.check_domain(*f, grades, e);
  return compose(*f->body, inner);
}

// The arguments become values, and then the operator is taken of them. One that asks for grades gets no zeros.
node_values composer::of_builtin(const lang::builtin &of, const lang::expr &e, const scope &names) {
  scope inner = names;
  lang::expr over = e;
  const std::size_t values = of.does == lang::operation::grade_part ? 1 : e.args.size();
  for (std::size_t i = 0; i < values; ++i) {
    const std::string name = of.body ? of.params[i] : part_name(i);
    node_values argument = compose(*e.args[i], names);
    if (of.does == lang::operation::of_versor && i == versor_argument(of))
      argument = without_zeros(code_, argument);
    inner.emplace_back(name, std::move(argument));
    over.args[i] = std::make_shared<lang::expr>(name_of_part(*e.args[i], i));
  }
  if (!of.body)
    return expanded(over, inner, most_steps, false);
  const scope parameters(inner.end() - static_cast<std::ptrdiff_t>(values), inner.end());
  return compose(body_of(of, algebra::parity_of(parameters[versor_argument(of)].second), e), parameters);
}

node_values composer::of_parts(const lang::expr &e, const scope &names) {
  if (e.kind == kind::call || e.kind == kind::builtin)
    return of_call(e, names);
  // The index of a coefficient and a divisor are constants.
  const bool products = e.kind == kind::multiply || e.kind == kind::outer || e.kind == kind::inner ||
                        e.kind == kind::add || e.kind == kind::subtract;
  if (!products && e.kind != kind::negate && e.kind != kind::index && e.kind != kind::divide)
    return expanded(e, names, most_steps, false);
  lang::expr over = e;
  scope inner = names;
  for (std::size_t i = 0; i < (products ? std::size_t{2} : std::size_t{1}); ++i) {
    if (is_value(*e.args[i]))
      continue;
    inner.emplace_back(part_name(i), compose(*e.args[i], names));
    over.args[i] = std::make_shared<lang::expr>(name_of_part(*e.args[i], i));
  }
  return expanded(over, inner, most_steps, false);
}

node_values composer::compose(const lang::expr &e, const scope &names) {
  if (e.kind == kind::name)
    if (const node_values *v = find(names, e.text))
      return *v;
  scope used;
  mentioned(e, names, used);
  const auto key = std::pair(&e, used);
  if (const auto it = known_.find(key); it != known_.end())
    return it->second;
  return known_[key] = composed(e, used);
}

node_values composer::composed(const lang::expr &e, const scope &names) {
  const parts which = std::exchange(parts_, parts_ == parts::arguments ? parts::long_ones : parts_);
  if (is_value(e))
    return expanded(e, names, most_steps, false);
  const bool is_call = e.kind == kind::call || e.kind == kind::builtin;
  if (which == parts::long_ones || (which == parts::arguments && !is_call)) {
    try {
      node_values found = expanded(e, names, most_steps_tried, true);
      if (e.kind != kind::call)
        return found;
      composer as_written(model_, code_, parts::all);
      as_written.steps_ = steps_;
      as_written.degrees_ = degrees_;
      try {
        return cheaper(found, as_written.of_parts(e, names));
      } catch (const spec_error &) { // it is expanded all the same
        return found;
      }
    } catch (const spec_error &) {
      // Either it is long, or it is not defined for values whose relations are lost. Its parts tell which.
      if (steps_ > most_steps)
        throw;
    }
  }
  try {
    return of_parts(e, names);
  } catch (spec_error &error) {
    if (is_call)
      error.add_step(lang::print(e), e.where);
    throw;
  }
}

} // namespace meetc::lower
