// Readings: an expression with divisions and square roots becomes polynomials in variables, of which each quotient, each root
// and each value of an entry is a new one.
#include "gen/lower/analytic/analytic.hpp"
#include "gen/lower/kernel/compile.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace meetc::lower {
namespace {

constexpr int most_made = 100; // variables besides those of the blade

std::vector<std::string> ring_names(const std::vector<std::string> &blade) {
  std::vector<std::string> out = blade;
  for (int i = 0; i < most_made; ++i)
    out.push_back(fmt::format("#{}", i));
  return out;
}

class reader final : public number_maker {
public:
  reader(const model &m, const lang::kind &k)
      : model_(m), kind_(k), blades_(support(m, k)), names_(coefficient_names(m, blades_)),
        numbers_(std::make_shared<poly::ring>(ring_names(names_))), ring_(*numbers_),
        still_(ring_, std::vector<poly::stored_number>(static_cast<std::size_t>(ring_.size()), {0, -1, 0, false})),
        expand_(m, ring_, unused_) {
    out_.variables = names_;
    out_.numbers = numbers_;
    expand_.allow(*this);
  }

  reading read(const lang::reading &r) {
    environment env{{kind_.name, expand_.general(blades_, names_)}};
    for (const lang::named_expr &e : r.entries) {
      entry_ = e.name;
      value v = expand_.evaluate(*e.body, env);
      if (const auto *m = std::get_if<multivector>(&v.is)) {
        const bool number = m->is_scalar();
        const multivector known = stored(*m, e);
        if (number)
          out_.entries.push_back(
              {e.name, on_one_line(lang::print(*e.body)), nullptr, numbers_of({expand_.scalar_of(known, e.where)}, e)});
        v = {known};
      } else if (const auto *o = std::get_if<std::shared_ptr<const object>>(&v.is)) {
        std::vector<poly::poly> numbers;
        flatten(**o, e.where, numbers);
        out_.entries.push_back({e.name, on_one_line(lang::print(*e.body)), (*o)->kind, numbers_of(numbers, e)});
      } else {
        throw spec_error(e.body->where,
                         "what is read back is a number or an element of a kind, as in 'point(x, y, z)'; "
                         "a multivector is a name for what follows");
      }
      env.emplace_back(e.name, std::move(v));
    }
    if (out_.entries.empty())
      throw spec_error(r.where,
                       fmt::format("[gives.{}] has no entry that is a number or an element of a kind", r.kind));
    prune();
    return std::move(out_);
  }

  poly::poly reciprocal(const poly::poly &x, const location &where) override {
    return made(reading::what::reciprocal, x, fmt::format("one_over_{}", ++reciprocals_), where);
  }
  poly::poly root(const poly::poly &x, const location &where) override {
    return made(reading::what::root, x, fmt::format("root_{}", ++roots_), where);
  }

private:
  const model &model_;
  const lang::kind &kind_;
  std::vector<blade> blades_;
  std::vector<std::string> names_;
  std::shared_ptr<poly::ring> numbers_;
  const poly::ring &ring_;
  poly::local_origin still_;
  decision unused_;
  expander expand_;
  reading out_;
  std::string entry_;
  std::map<std::pair<reading::what, std::string>, int> known_; // by the polynomial's key
  int reciprocals_ = 0, roots_ = 0;

  static std::vector<std::string> coefficient_names(const model &m, const std::vector<blade> &blades) {
    std::vector<std::string> out;
    for (const blade b : blades)
      out.push_back(m.working().name(b));
    return out;
  }

  int add(const std::string &name, const location &where) {
    const int at = static_cast<int>(out_.variables.size());
    if (at == ring_.size())
      throw spec_error(where, fmt::format("[gives.{}] computes more than {} numbers", kind_.name, most_made));
    std::string free = name;
    while (std::find(out_.variables.begin(), out_.variables.end(), free) != out_.variables.end())
      free += '_';
    out_.variables.push_back(free);
    return at;
  }

  // Leaves out results that no entry needs.
  void prune() {
    std::set<int> read;
    for (const reading::entry &e : out_.entries)
      read.insert(e.numbers.begin(), e.numbers.end());
    for (auto s = out_.steps.rbegin(); s != out_.steps.rend(); ++s) {
      std::vector<node_id> results;
      std::vector<int> sets;
      for (std::size_t i = 0; i < s->sets.size(); ++i)
        if (read.count(s->sets[i])) {
          results.push_back(s->code.results[i]);
          sets.push_back(s->sets[i]);
        }
      s->code.results = std::move(results);
      s->sets = std::move(sets);
      for (const node_id id : ir::needed(s->code.nodes, s->code.results))
        if (const node &n = s->code.nodes.at(id); n.kind == op::input)
          read.insert(n.a);
    }
    std::erase_if(out_.steps, [](const reading::step &s) { return s.sets.empty(); });
  }

  // A step for these polynomials, which are results of one program.
  int step(reading::what makes, const std::vector<poly::poly> &of, const std::vector<std::string> &names,
           const std::string &text, const location &where) {
    builder code(still_, prefer::operations);
    std::vector<node_id> results;
    for (const poly::poly &p : of)
      results.push_back(code.build(p));
    const int first = static_cast<int>(out_.variables.size());
    std::vector<int> sets;
    for (const std::string &name : names)
      sets.push_back(add(name, where));
    out_.steps.push_back({makes, code.finish(results), std::move(sets), text});
    return first;
  }

  poly::poly made(reading::what makes, const poly::poly &x, const std::string &name, const location &where) {
    const auto [at, fresh] = known_.try_emplace({makes, x.key()}, 0);
    if (fresh)
      at->second = step(makes, {x}, {name}, entry_, where);
    return poly::poly::variable(ring_, at->second);
  }

  static std::string said(const lang::named_expr &e) {
    return fmt::format("{} = {}", e.name, on_one_line(lang::print(*e.body)));
  }

  // Whether a polynomial costs nothing: a number, or a multiple of a variable.
  static bool is_free(const poly::poly &p) { return p.length() <= 1 && p.total_degree() <= 1; }

  static bool is_variable(const poly::poly &p) {
    return p.length() == 1 && p.total_degree() == 1 && p.terms()[0].coefficient == 1;
  }

  // The multivector with a variable for each coefficient that costs an operation.
  multivector stored(const multivector &m, const lang::named_expr &e) {
    std::vector<poly::poly> of;
    std::vector<std::string> names;
    std::vector<blade> at;
    for (const auto &[b, c] : m.terms())
      if (!is_free(c)) {
        of.push_back(c);
        at.push_back(b);
        names.push_back(b == 0 ? e.name : e.name + '_' + model_.working().name(b, "_"));
      }
    if (of.empty())
      return m;
    const int first = step(reading::what::values, of, names, said(e), e.where);
    multivector out;
    for (const auto &[b, c] : m.terms()) {
      const auto i = std::find(at.begin(), at.end(), b) - at.begin();
      out.add(b, i == std::ssize(at) ? c : poly::poly::variable(ring_, first + static_cast<int>(i)));
    }
    return out;
  }

  std::vector<int> numbers_of(const std::vector<poly::poly> &of, const lang::named_expr &e) {
    std::vector<poly::poly> costly;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < of.size(); ++i)
      if (!is_variable(of[i])) {
        costly.push_back(of[i]);
        names.push_back(fmt::format("{}_number_{}", e.name, i + 1));
      }
    int next = costly.empty() ? 0 : step(reading::what::values, costly, names, said(e), e.where);
    std::vector<int> out;
    for (const poly::poly &p : of)
      out.push_back(is_variable(p) ? p.variables()[0] : next++);
    return out;
  }

  void flatten(const object &o, const location &where, std::vector<poly::poly> &out) {
    for (const value &field : o.fields)
      if (const auto *part = std::get_if<std::shared_ptr<const object>>(&field.is))
        flatten(**part, where, out);
      else
        out.push_back(expand_.scalar_of(std::get<multivector>(field.is), where));
  }
};

} // namespace

reading compile_reading(const model &m, const lang::kind &k, const location &where) {
  const lang::reading *r = m.spec().find_reading(k.name);
  if (!r) {
    std::vector<std::string> known;
    for (const lang::reading &other : m.spec().readings)
      known.push_back(other.kind);
    throw spec_error(
        where, fmt::format("the algebra has no table [gives.{}]; {}", k.name,
                           known.empty() ? "it has none of [gives.KIND]" : "it has those of: " + join(known, ", ")));
  }
  return reader(m, k).read(*r);
}

} // namespace meetc::lower
