#include "gen/lower/expand/decision.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace meetc::lower {

sign_value operator-(sign_value a) {
  a.unit = -a.unit;
  return a;
}

sign_value operator*(const sign_value &a, const sign_value &b) {
  sign_value out{a.unit * b.unit, {}};
  if (out.unit == 0)
    return out;
  std::map<int, int> powers;
  for (const auto &list : {a.atoms, b.atoms})
    for (const auto &[atom, e] : list)
      powers[atom] += e;
  for (const auto &[atom, e] : powers)
    out.atoms.emplace_back(atom, e % 2 ? 1 : 2);
  return out;
}

sign_value decision::sign_of(const poly::poly &p) {
  if (p.is_zero())
    return {};
  const auto [content, primitive] = p.primitive();
  const int unit = content > 0 ? 1 : -1;
  const auto [memo, unseen] = signs_.try_emplace(primitive.key());
  if (!unseen) {
    sign_value known = memo->second;
    known.unit *= unit;
    return known;
  }
  const auto f = primitive.factors();
  sign_value out{f.content > 0 ? 1 : -1, {}};
  for (const auto &[part, exponent] : f.parts) {
    if (known_.is_positive(part))
      continue;
    out.atoms.emplace_back(id_of(part), exponent % 2 ? 1 : 2);
  }
  std::sort(out.atoms.begin(), out.atoms.end());
  memo->second = out;
  out.unit *= unit;
  return out;
}

sign_value decision::sign_of_atom(const poly::poly &atom) {
  return {1, {{id_of(atom), 1}}};
}

int decision::id_of(const poly::poly &atom) {
  const auto [it, fresh] = atom_ids_.try_emplace(atom.key(), static_cast<int>(atoms_.size()));
  if (fresh) {
    atoms_.push_back(atom);
    texts_.emplace_back();
  }
  return it->second;
}

namespace {
sign_mask mirrored(sign_mask m) {
  return (m & 2) | (m & 1) << 2 | m >> 2;
}
} // namespace

std::string decision::text(int atom) const {
  const name &n = texts_[static_cast<std::size_t>(atom)];
  if (n.text.empty() || !n.opposite)
    return n.text;
  return n.text.back() == ')' ? '-' + n.text : "-(" + n.text + ')'; // a call, or a difference
}

void decision::describe(const sign_value &s, const std::string &text, long mark) {
  const bool whole = s.atoms.size() == 1 && s.atoms.front().second == 1;
  for (const auto &[atom, exponent] : s.atoms) {
    name &n = texts_[static_cast<std::size_t>(atom)];
    if (!n.text.empty() && n.given <= mark)
      continue;
    n.text = whole ? text : "a factor of " + text;
    n.opposite = whole && s.unit < 0;
    n.given = ++given_;
  }
}

int decision::intern(truth_node n) {
  const auto [it, fresh] = node_ids_.try_emplace(n, static_cast<int>(nodes_.size()));
  if (fresh)
    nodes_.push_back(std::move(n));
  return it->second;
}

int decision::constant(bool b) {
  return intern({truth_node::type::constant, b, {}, {}});
}

int decision::test(const sign_value &s, sign_mask mask) {
  sign_value v = s;
  if (v.unit < 0) {
    mask = mirrored(mask);
    v.unit = 1;
  }
  if (v.unit == 0)
    return constant((mask & 2) != 0);
  if (v.atoms.empty())
    return constant((mask & 4) != 0);
  const bool even = std::all_of(v.atoms.begin(), v.atoms.end(), [](const auto &a) { return a.second == 2; });
  if (even)
    mask = (mask & 6) | (mask & 4) >> 2; // a square is never negative, so only zero and positive count
  if (mask == 7 || mask == 0)
    return constant(mask == 7);
  return intern({truth_node::type::test, mask, std::move(v), {}});
}

int decision::negate(int a) {
  const truth_node n = at(a);
  switch (n.kind) {
  case truth_node::type::constant:
    return constant(!n.flag);
  case truth_node::type::test:
    return test(n.sign, 7 & ~n.flag);
  case truth_node::type::negate:
    return n.args[0];
  default:
    return intern({truth_node::type::negate, 0, {}, {a}});
  }
}

int decision::connect(truth_node::type kind, const std::vector<int> &args) {
  const bool absorbing = kind == truth_node::type::either;
  std::set<int> flat;
  for (const int a : args) {
    const truth_node &n = at(a);
    if (n.kind == truth_node::type::constant) {
      if ((n.flag != 0) == absorbing)
        return constant(absorbing);
    } else if (n.kind == kind) {
      flat.insert(n.args.begin(), n.args.end());
    } else {
      flat.insert(a);
    }
  }
  if (flat.empty())
    return constant(!absorbing);
  if (flat.size() == 1)
    return *flat.begin();
  return intern({kind, 0, {}, {flat.begin(), flat.end()}});
}

int decision::choose(int condition, int then, int otherwise) {
  if (at(condition).kind == truth_node::type::constant)
    return at(condition).flag ? then : otherwise;
  if (then == otherwise)
    return then;
  return intern({truth_node::type::choose, 0, {}, {condition, then, otherwise}});
}

bool decision::evaluate(int id, const std::vector<int> &signs) const {
  // Ids grow from parts to wholes, so one sweep in their order sees parts first.
  std::vector<char> value(static_cast<std::size_t>(id) + 1);
  const auto of = [&](int i) { return value[static_cast<std::size_t>(i)] != 0; };
  for (int i = 0; i <= id; ++i) {
    const truth_node &n = at(i);
    bool v = false;
    switch (n.kind) {
    case truth_node::type::constant:
      v = n.flag != 0;
      break;
    case truth_node::type::test: {
      int s = n.sign.unit;
      for (const auto &[atom, e] : n.sign.atoms) {
        const int a = signs[static_cast<std::size_t>(atom)];
        s *= e == 2 ? a * a : a;
      }
      v = (n.flag >> (s + 1) & 1) != 0;
      break;
    }
    case truth_node::type::both:
      v = std::all_of(n.args.begin(), n.args.end(), of);
      break;
    case truth_node::type::either:
      v = std::any_of(n.args.begin(), n.args.end(), of);
      break;
    case truth_node::type::negate:
      v = !of(n.args[0]);
      break;
    case truth_node::type::choose:
      v = of(n.args[0]) ? of(n.args[1]) : of(n.args[2]);
      break;
    }
    value[static_cast<std::size_t>(i)] = v;
  }
  return of(id);
}

std::vector<int> decision::atoms_of(int id, bool rare) const {
  std::set<int> seen, atoms;
  const std::function<void(int)> visit = [&](int i) {
    if (!seen.insert(i).second)
      return;
    const truth_node &n = at(i);
    for (const auto &[atom, e] : n.sign.atoms)
      atoms.insert(atom);
    for (std::size_t k = 0; k < n.args.size(); ++k)
      if (rare || n.kind != truth_node::type::choose || k != 1)
        visit(n.args[k]);
  };
  visit(id);
  return {atoms.begin(), atoms.end()};
}

std::vector<int> decision::conditions_of(int id) const {
  std::set<int> seen, conditions;
  const std::function<void(int)> visit = [&](int i) {
    if (!seen.insert(i).second)
      return;
    const truth_node &n = at(i);
    if (n.kind == truth_node::type::choose) {
      conditions.insert(n.args[0]);
      visit(n.args[2]);
    } else {
      for (const int a : n.args)
        visit(a);
    }
  };
  visit(id);
  return {conditions.begin(), conditions.end()};
}

int decision::usual(int id) {
  std::map<int, int> done;
  const std::function<int(int)> rewrite = [&](int i) -> int {
    if (const auto it = done.find(i); it != done.end())
      return it->second;
    const truth_node n = at(i);
    int out = i;
    if (n.kind == truth_node::type::choose) {
      out = rewrite(n.args[2]);
    } else if (!n.args.empty()) {
      std::vector<int> args;
      for (const int a : n.args)
        args.push_back(rewrite(a));
      out = n.kind == truth_node::type::negate ? negate(args[0]) : connect(n.kind, args);
    }
    return done[i] = out;
  };
  return rewrite(id);
}

} // namespace meetc::lower
