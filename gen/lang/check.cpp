// Checks names: duplicates, unknown ones, kinds that contain themselves, functions that call themselves.
#include "gen/lang/analytic.hpp"
#include "gen/lang/hints.hpp"
#include "gen/lang/operators.hpp"
#include "gen/lang/relations.hpp"
#include "gen/lang/spec.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace meetc::lang {

namespace {
template <class T> const T *find_named(const std::vector<T> &all, const std::string &name) {
  const auto it = std::find_if(all.begin(), all.end(), [&](const T &t) { return t.name == name; });
  return it == all.end() ? nullptr : &*it;
}

using scope = std::set<std::string>;

class name_checker {
public:
  explicit name_checker(const algebra &a) : a_(a) {
    for (const std::string &v : a.vectors)
      add(v, a.where, "vector");
    for (const named_expr &c : a.constants)
      add(c.name, c.where, "constant");
    for (const kind &k : a.kinds)
      add(k.name, k.where, "kind");
    for (const function &f : a.functions)
      add(f.name, f.where, "function");
    for (const predicate &p : a.predicates)
      add(p.name, p.where, "predicate");
  }

  void run() {
    for (const kind &k : a_.kinds) {
      contains_itself(k, {});
      fields(k.store);
      hide_nothing(k.store);
      expression(*k.blade, names(k.store));
      for (const constructor &c : k.from) {
        fields(c.of);
        hide_nothing(c.of);
        expression(*c.blade, names(c.of));
      }
      for (const named_expr &p : k.parts) {
        if (find_named(k.store, p.name))
          throw spec_error(p.where, fmt::format("'{}' is stored already", p.name));
        expression(*p.body, names(k.store));
      }
      if (k.rule) {
        scope known = names(k.store);
        known.insert(k.name); // the kind itself: all its numbers
        expression(*k.rule, known);
      }
      for (const expr_ptr &e : {k.hull, k.pad})
        if (e)
          expression(*e, names(k.store));
      for (const relation &r : k.relations)
        for (const expr_ptr &side : {r.left, r.right}) {
          of_blade_alone(*side, k);
          expression(*side, {k.name});
        }
      fields(k.sample_of);
      hide_nothing(k.sample_of);
      for (const expr_ptr &e : k.samples)
        expression(*e, names(k.sample_of));
      if (k.position && std::any_of(k.store.begin(), k.store.end(), [](const field &f) { return f.type != "real"; }))
        throw spec_error(k.where, "a kind with 'position' stores only reals, one for each spatial axis");
      if (k.position && k.store.size() > 3)
        throw spec_error(k.where, "a kind with 'position' has at most three axes");
      if (k.position)
        has_all_axes(k);
      if (const auto cut = k.name.rfind("_blade");
          cut != std::string::npos && cut + 6 == k.name.size() && a_.find_kind(k.name.substr(0, cut)))
        throw spec_error(k.where, fmt::format("'{}' is the name of the blade of '{}'", k.name, k.name.substr(0, cut)));
    }
    for (const named_expr &c : a_.constants)
      constant(c, {});
    for (const named_expr &n : a_.null)
      if (!a_.find_constant(n.name))
        throw spec_error(
            n.where,
            fmt::format("null vector '{0}' is not a constant; declare it in [constants], as {0} = '…'", n.name));
    for (const function &f : a_.functions) {
      expression(*f.body, scope(f.params.begin(), f.params.end()));
      if (f.domain)
        expression(*f.domain, scope(f.params.begin(), f.params.end()));
      calls_itself(f.name, f.where);
      if (!f.orders.empty() && !a_.find_predicate(f.orders)) {
        std::vector<std::string> known;
        for (const predicate &p : a_.predicates)
          known.push_back(p.name);
        throw spec_error(f.orders_where, fmt::format("no predicate '{}'; predicates: {}{}", f.orders, join(known, ", "),
                                                     nearest(f.orders, known)));
      }
      if (!f.orders.empty() && f.params.size() != 2)
        throw spec_error(
            f.orders_where,
            fmt::format("'{}' orders {} and needs two arguments: an element, and a pair of those that it meets", f.name,
                        f.orders));
    }
    for (const predicate &p : a_.predicates) {
      fields(p.of);
      scope s = names(p.of);
      for (const named_expr &l : p.lets) {
        expression(*l.body, s); // a let sees the operands and earlier lets
        if (!s.insert(l.name).second)
          throw spec_error(l.where, fmt::format("'{}' is given twice", l.name));
      }
      for (const expr_ptr &r : p.reject)
        expression(*r, s);
      expression(*p.hit, s);
      calls_itself(p.name, p.where);
      check_meaning(a_, p);
      if (!p.contacts.empty() && p.contacts != one_witness)
        contacts_of(p);
    }
    for (const reading &r : a_.readings)
      reads(r);
  }

private:
  const algebra &a_;
  bool in_reading_ = false; // where sqrt is a function of numbers
  std::map<std::string, location> declared_;
  std::set<std::string> open_, done_;
  std::map<std::string, std::size_t> whole_kinds_; // known to end, with the number of values that each stores
  std::set<std::string> whole_constants_;

  static constexpr std::size_t most_nested = 500; // definitions within definitions; protects the stack
  static constexpr std::size_t most_stored = 1000;

  void contacts_of(const predicate &p) {
    const function *const f = a_.find_function(p.contacts);
    if (!f) {
      std::vector<std::string> known;
      for (const function &other : a_.functions)
        known.push_back(other.name);
      throw spec_error(p.contacts_where, fmt::format("no function '{}'; functions: {}{}", p.contacts, join(known, ", "),
                                                     nearest(p.contacts, known)));
    }
    if (f->params.size() != 2)
      throw spec_error(p.contacts_where,
                       fmt::format("'{}' tells the contacts of {} and needs two arguments: an operand, and a point",
                                   f->name, p.name));
  }

  void add(const std::string &name, const location &where, const char *what) {
    if (const auto [it, fresh] = declared_.try_emplace(name, where); !fresh)
      throw spec_error(where, fmt::format("{} '{}' is already declared at {}", what, name, it->second.text()));
  }
  static scope names(const std::vector<field> &fields) {
    scope s;
    for (const field &f : fields)
      s.insert(f.name);
    return s;
  }
  void reads(const reading &r) {
    if (!a_.find_kind(r.kind))
      throw spec_error(r.where, fmt::format("no kind '{}'; kinds: {}{}", r.kind, join(a_.kind_names(), ", "),
                                            nearest(r.kind, a_.kind_names())));
    for (const reading &other : a_.readings)
      if (&other < &r && other.kind == r.kind)
        throw spec_error(r.where, fmt::format("[gives.{}] is already declared at {}", r.kind, other.where.text()));
    scope s{r.kind};
    in_reading_ = true;
    for (const named_expr &e : r.entries) {
      if (e.name == "exists" || e.name == "is_real")
        throw spec_error(e.where,
                         fmt::format("'{}' is a member of everything that is read back; choose another name", e.name));
      if (const auto at = declared_.find(e.name); at != declared_.end())
        throw spec_error(e.where, fmt::format("'{}' would hide what is declared at {}; choose another name", e.name,
                                              at->second.text()));
      expression(*e.body, s);
      s.insert(e.name);
    }
    in_reading_ = false;
  }
  // A stored number must not hide a vector of either basis: the blade would be made of numbers alone.
  void hide_nothing(const std::vector<field> &all) const {
    for (const field &f : all)
      if (std::find(a_.vectors.begin(), a_.vectors.end(), f.name) != a_.vectors.end() || find_named(a_.null, f.name))
        throw spec_error(f.where, fmt::format("'{}' would hide the vector of that name, declared at {}; choose another "
                                              "name",
                                              f.name, declared_.at(f.name).text()));
  }
  void fields(const std::vector<field> &all) const {
    for (const field &f : all)
      if (f.type != "real" && !a_.find_kind(f.type))
        throw spec_error(f.where, fmt::format("no kind '{}'; kinds: {}{}", f.type, join(a_.kind_names(), ", "),
                                              nearest(f.type, a_.kind_names())));
  }
  std::size_t contains_itself(const kind &k, std::vector<std::string> open) {
    if (const auto known = whole_kinds_.find(k.name); known != whole_kinds_.end())
      return known->second;
    if (std::find(open.begin(), open.end(), k.name) != open.end())
      throw spec_error(k.where, fmt::format("kind '{}' contains itself", k.name));
    open.push_back(k.name);
    nests(open.size(), k.where);
    std::size_t numbers = 0;
    for (const field &f : k.store) {
      const kind *inner = a_.find_kind(f.type);
      numbers += inner ? contains_itself(*inner, open) : 1;
    }
    if (numbers > most_stored)
      throw spec_error(k.where, fmt::format("kind '{}' stores more than {} numbers", k.name, most_stored));
    return whole_kinds_[k.name] = numbers;
  }
  // Points have the same axes, since differences of any two are formed.
  void has_all_axes(const kind &k) const {
    const auto needs = [&](std::size_t axes, const std::string &other) {
      if (k.store.size() != axes)
        throw spec_error(
            k.where, fmt::format("kind '{}' stores {} coordinates, but '{}' has {}: a kind with 'position' has one for "
                                 "each spatial axis",
                                 k.name, k.store.size(), other, axes));
    };
    if (const named_expr *axes = a_.find_constant("axes"); axes && axes->body->kind == op::list)
      needs(axes->body->args.size(), axes->name);
    const auto first = std::find_if(a_.kinds.begin(), a_.kinds.end(), [](const kind &other) { return other.position; });
    needs(first->store.size(), first->name);
  }
  static void nests(std::size_t depth, const location &where) {
    if (depth > most_nested)
      throw spec_error(where, fmt::format("definitions are nested more than {} deep here", most_nested));
  }
  void constant(const named_expr &c, std::vector<std::string> open) {
    if (whole_constants_.count(c.name))
      return;
    if (std::find(open.begin(), open.end(), c.name) != open.end())
      throw spec_error(c.where, fmt::format("constant '{}' is defined by itself", c.name));
    open.push_back(c.name);
    nests(open.size(), c.where);
    expression(*c.body, {});
    // They are collected first, because a walk within a walk would use stack for every level of every expression.
    std::vector<const named_expr *> others;
    walk(*c.body, [&](const expr &e) {
      const builtin *called = called_builtin(a_, e);
      if (e.kind == op::name || (called && called->needs_pseudoscalar()))
        if (const named_expr *other = a_.find_constant(called ? "I" : e.text))
          others.push_back(other);
    });
    for (const named_expr *other : others)
      constant(*other, open);
    whole_constants_.insert(c.name);
  }
  template <class F> static void walk(const expr &e, F &&f) {
    f(e);
    for (const binder &b : e.binders)
      walk(*b.over, f);
    for (const expr_ptr &arg : e.args)
      walk(*arg, f);
  }
  // A relation is about the blade, which may be made otherwise than from stored numbers.
  static void of_blade_alone(const expr &e, const kind &k) {
    const scope stored = names(k.store);
    walk(e, [&](const expr &part) {
      if (part.kind == op::name && stored.count(part.text))
        throw spec_error(part.where,
                         fmt::format("'{}' is a stored number, and a relation is about the blade: write its "
                                     "coefficient, as in '{}[1]'",
                                     part.text, k.name));
    });
  }
  // Visits calls depth first. `open` marks what is being visited, `done` what is known to end.
  void calls_itself(const std::string &name, const location &where) {
    if (done_.count(name))
      return;
    if (!open_.insert(name).second)
      throw spec_error(where, fmt::format("'{}' calls itself; there is no recursion", name));
    nests(open_.size(), where);
    std::vector<const expr *> calls; // collected first, as in constant()
    const auto visit = [&](const expr_ptr &body) {
      walk(*body, [&](const expr &e) {
        if (e.kind == op::call && (a_.find_function(e.text) || a_.find_predicate(e.text)))
          calls.push_back(&e);
      });
    };
    if (const function *f = a_.find_function(name)) {
      visit(f->body);
      if (f->domain)
        visit(f->domain);
    }
    if (const predicate *p = a_.find_predicate(name)) {
      visit(p->hit);
      for (const named_expr &l : p->lets)
        visit(l.body);
      for (const expr_ptr &r : p->reject)
        visit(r);
    }
    for (const expr *e : calls)
      calls_itself(e->text, e->where);
    open_.erase(name);
    done_.insert(name);
  }
  void expression(const expr &e, const scope &s) const {
    if (e.kind == op::name && !s.count(e.text) && !declared_.count(e.text) && !is_value(e)) {
      if (e.text == "*")
        throw spec_error(e.where, "'*' stands for all kinds in the kernels of a scene alone");
      std::vector<std::string> known(s.begin(), s.end());
      for (const auto &[name, where] : declared_)
        known.push_back(name);
      const std::string hint = hint_for_name(a_, e.text), near = nearest(e.text, known);
      const std::string local = join({s.begin(), s.end()}, ", ");
      throw spec_error(e.where, fmt::format("unknown name '{}'{}", e.text,
                                            !hint.empty()   ? hint
                                            : !near.empty() ? near
                                            : !local.empty()
                                                ? fmt::format("; beside what the algebra declares there is: {}", local)
                                                : ""));
    }
    if (e.kind == op::call)
      call(e);
    scope inner = s;
    for (const binder &b : e.binders) {
      expression(*b.over, inner);
      inner.insert(b.name);
    }
    for (const expr_ptr &arg : e.args)
      expression(*arg, inner);
  }
  // Names with a value and without a declaration: I, and a basis blade such as e12.
  bool is_value(const expr &e) const {
    const std::vector<std::string> vectors = vectors_of_name(a_, e.text);
    for (auto v = vectors.begin(); v != vectors.end(); ++v)
      if (std::find(vectors.begin(), v, *v) != v)
        throw spec_error(e.where,
                         fmt::format("'{}' has the vector {} twice; a basis blade has different ones", e.text, *v));
    return e.text == "I" || !vectors.empty();
  }
  void call(const expr &e) const {
    std::size_t want = 1;
    if (const builtin *of_language = called_builtin(a_, e)) {
      want = of_language->params.size();
    } else if (e.text == "sign" || e.text == "grade") {
    } else if (const function *called = a_.find_function(e.text)) {
      want = called->params.size();
    } else if (const predicate *asked = a_.find_predicate(e.text)) {
      want = asked->of.size();
    } else if (const kind *made = a_.find_kind(e.text)) {
      want = made->store.size();
    } else if (called_analytic(a_, e)) {
      if (!in_reading_ || e.text != "sqrt")
        refuse_analytic(e);
    } else if (e.text != "zero") {
      std::vector<std::string> known{"sign", "zero"};
      for (const builtin &b : builtins())
        known.push_back(b.name);
      for (const function &f : a_.functions)
        known.push_back(f.name);
      for (const predicate &p : a_.predicates)
        known.push_back(p.name);
      for (const kind &k : a_.kinds)
        known.push_back(k.name);
      const std::string hint = hint_for_function(e.text);
      throw spec_error(e.where,
                       fmt::format("unknown function '{}'{}", e.text, hint.empty() ? nearest(e.text, known) : hint));
    }
    if (e.kind == op::call && e.args.size() != want)
      refuse_arguments(e, want);
  }
};
} // namespace

const kind *algebra::find_kind(const std::string &n) const {
  return find_named(kinds, n);
}
const function *algebra::find_function(const std::string &n) const {
  return find_named(functions, n);
}
const predicate *algebra::find_predicate(const std::string &n) const {
  return find_named(predicates, n);
}
const named_expr *algebra::find_constant(const std::string &n) const {
  return find_named(constants, n);
}
const reading *algebra::find_reading(const std::string &kind) const {
  const auto at = std::find_if(readings.begin(), readings.end(), [&](const reading &r) { return r.kind == kind; });
  return at == readings.end() ? nullptr : &*at;
}
std::vector<std::string> algebra::kind_names() const {
  std::vector<std::string> out;
  for (const kind &k : kinds)
    out.push_back(k.name);
  return out;
}

void check(const algebra &a) {
  name_checker(a).run();
}

} // namespace meetc::lang
