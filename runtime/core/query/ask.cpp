#include "meet/core/query/ask.hpp"

#include <string>
#include <utility>

namespace meetc {

choice chosen(const catalogue &all, const kind_info &a, const kind_info &b, const how &asked) {
  if (asked.mode != "solid" && asked.mode != "surface")
    throw usage_error("no mode '" + std::string(asked.mode) + "'; there are: solid, surface");
  const std::vector<choice> fit = fitting(all, a, b);
  if (asked.predicate.empty()) {
    if (const std::optional<choice> first = first_for(fit, asked.mode))
      return *first;
  } else
    for (const choice &c : fit)
      if (c.predicate->name == asked.predicate)
        return c;
  std::string known;
  for (int i = 0; i < all.predicate_count; ++i)
    known += std::string(i == 0 ? "" : ", ") + all.predicates[i].name;
  const std::string what =
      asked.predicate.empty() ? "no predicate" : "no predicate '" + std::string(asked.predicate) + "'";
  throw usage_error(what + " in " + all.space + " takes a " + a.name + " and a " + b.name + ", mode '" +
                    std::string(asked.mode) + "'; there " + (known.empty() ? "is none" : "are: " + known));
}

result ask(const catalogue &all, const prepared &a, const prepared &b, const how &asked) {
  const choice by = chosen(all, a.kind(), b.kind(), asked);
  if (!by.swapped)
    return collide(a, b, *by.predicate, asked.precision, asked.with);
  if (asked.with.first_met)
    throw usage_error(std::string(by.predicate->name) + " tells what a " + by.predicate->a->name +
                      " meets first, not a " + by.predicate->b->name);
  collide_options turned_options = asked.with;
  std::swap(turned_options.owner_a, turned_options.owner_b);
  return turned(collide(b, a, *by.predicate, asked.precision, turned_options));
}

} // namespace meetc
