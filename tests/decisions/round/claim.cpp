#include "tests/decisions/round/facts.hpp"

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
  std::vector<std::string> known = {"touch"};
  std::vector<claim> out;
  if (e.second == other::sphere) {
    out = sphere_claims(d, e.surface);
  } else if (e.second == other::segment) {
    known = {"corner a", "corner b", "edge ab"};
    out = corner_claims(d);
    append(out, segment_claims(d));
  } else {
    known = {"corner a", "corner b", "corner c", "edge ab", "edge bc", "edge ac", "face", "reversed face"};
    out = corner_claims(d);
    append(out, triangle_claims(d));
  }
  if (e.surface && e.second != other::sphere)
    append(out, far_claims(d, e.second == other::triangle));
  // A hit by a way that no claim above covers.
  for (const way &w : d.near)
    if (std::find(known.begin(), known.end(), w.name) == known.end())
      out.push_back({w.name + " hit, which touches nothing that is known", with(d, w, {}), {}, {}});
  return out;
}

} // namespace meetc::decisions_round
