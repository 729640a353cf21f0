#include "gen/lower/kinds.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace meetc::lower {
namespace {

using kind_set = std::set<const lang::kind *>;

// The kinds of operands and results of all kernels, or of formulas only.
kind_set used_by(const std::vector<kernel> &kernels, bool formulas_alone) {
  kind_set out;
  for (const kernel &k : kernels) {
    if (k.is_predicate && formulas_alone)
      continue;
    out.insert(k.asked.kinds.begin(), k.asked.kinds.end());
    if (!k.is_predicate && k.value.result_kind)
      out.insert(k.value.result_kind);
  }
  return out;
}

// Adds the kinds that they and their constructors contain.
kind_set with_parts(const lang::algebra &a, const kind_set &kinds) {
  kind_set out;
  const std::function<void(const lang::kind *)> want = [&](const lang::kind *k) {
    if (!k || !out.insert(k).second)
      return;
    for (const lang::field &f : k->store)
      want(a.find_kind(f.type));
    for (const lang::constructor &c : k->from)
      for (const lang::field &f : c.of)
        want(a.find_kind(f.type));
  };
  for (const lang::kind *k : kinds)
    want(k);
  return out;
}

// In the spec's order, except that parts come first.
std::vector<const lang::kind *> parts_first(const lang::algebra &a, const kind_set &kinds) {
  std::vector<const lang::kind *> out;
  kind_set done;
  const std::function<void(const lang::kind *)> place = [&](const lang::kind *k) {
    if (!done.insert(k).second)
      return;
    for (const lang::field &f : k->store)
      if (const lang::kind *part = a.find_kind(f.type))
        place(part);
    out.push_back(k);
  };
  for (const lang::kind &k : a.kinds)
    if (kinds.count(&k))
      place(&k);
  return out;
}

} // namespace

bool on_sets(const kernel &k) {
  return k.is_predicate && !k.is_sign && std::all_of(k.asked.kinds.begin(), k.asked.kinds.end(), [](const auto *kind) {
           return kind->hull || kind->position;
         });
}

std::vector<lowered_kind> kinds_of(const model &m, const std::vector<kernel> &kernels,
                                   const std::vector<analytic_kernel> &analytic) {
  kind_set with_blade = used_by(kernels, true), used = used_by(kernels, false);
  for (const analytic_kernel &k : analytic) {
    with_blade.insert(k.kind);
    if (k.result_kind)
      with_blade.insert(k.result_kind);
    for (const reading::entry &e : k.read ? k.read->entries : std::vector<reading::entry>{})
      if (e.kind)
        used.insert(e.kind);
  }
  used.insert(with_blade.begin(), with_blade.end());
  kind_set elements;
  for (const kernel &k : kernels)
    if (on_sets(k))
      elements.insert(k.asked.kinds.begin(), k.asked.kinds.end());
  std::vector<lowered_kind> out;
  for (const lang::kind *k : parts_first(m.spec(), with_parts(m.spec(), used))) {
    kind_layout layout = m.layout(*k);
    lowered_kind lowered;
    lowered.name = k->name;
    lowered.declared = static_cast<int>(k - m.spec().kinds.data());
    lowered.is_element = elements.count(k) > 0;
    lowered.fields = k->store;
    lowered.reals = std::move(layout.reals);
    lowered.points = layout.points;
    if (with_blade.count(k)) {
      lowered.blades = named(m.working(), support(m, *k));
      lowered.makers = makers(m, *k);
    }
    out.push_back(std::move(lowered));
  }
  return out;
}

void enclose(const model &m, std::vector<lowered_kind> &kinds) {
  for (lowered_kind &k : kinds) {
    const lang::kind &spec = m.spec().kinds[static_cast<std::size_t>(k.declared)];
    if (!k.is_element && !spec.rule)
      continue;
    k.enclosed = enclosing(m, spec);
  }
}

} // namespace meetc::lower
