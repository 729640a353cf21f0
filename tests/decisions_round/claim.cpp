#include "tests/decisions_round/claim.hpp"

#include <algorithm>

namespace meetc::decisions_round {
namespace {

const fact *find(const claim &c, const std::string &name) {
  const auto it = std::find_if(c.facts.begin(), c.facts.end(), [&](const fact &f) { return f.name == name; });
  return it == c.facts.end() ? nullptr : &*it;
}

void append(std::vector<claim> &to, const std::vector<claim> &more) {
  to.insert(to.end(), more.begin(), more.end());
}

} // namespace

std::string refusal(const claim &c) {
  polynomial sum = gram::ring().zero;
  bool positive = false;
  for (const product &p : c.products) {
    polynomial value = square(p.squared).scaled(p.factor);
    bool strict = p.squared.is_constant() && !p.squared.is_zero();
    for (const std::string &name : p.of) {
      const fact *f = find(c, name);
      if (!f)
        return "there is no fact '" + name + "'";
      if (f->is == relation::equal)
        return "'" + name + "' is an equation";
      strict = strict && f->is == relation::above;
      value = value * f->value;
    }
    if (p.factor <= 0)
      return "a factor is not positive";
    positive = positive || strict;
    sum = sum + value;
  }
  for (const equation &e : c.equations) {
    const fact *f = find(c, e.of);
    if (!f || f->is != relation::equal)
      return "there is no equation '" + e.of + "'";
    sum = sum + e.times * f->value;
  }
  if (!positive)
    return "no product is positive";
  return sum.is_zero() ? "" : "the sum is " + sum.text() + ", not zero";
}

std::vector<claim> claims_of(const emitted &e, const decision &d) {
  if (e.value)
    return side_claims();
  if (e.second == other::sphere)
    return sphere_claims(d, e.surface);
  std::vector<claim> out = corner_claims(d);
  append(out, e.second == other::segment ? segment_claims(d) : triangle_claims(d));
  if (e.surface)
    append(out, far_claims(d, e.second == other::triangle));
  return out;
}

} // namespace meetc::decisions_round
