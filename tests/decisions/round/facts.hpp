// How a decision's literals become facts of claims.
#ifndef MEETC_TESTS_DECISIONS_ROUND_FACTS_HPP
#define MEETC_TESTS_DECISIONS_ROUND_FACTS_HPP

#include "tests/decisions/round/claim.hpp"

namespace meetc::decisions_round {

inline fact at_least(const std::string &name, const polynomial &p) {
  return {name, p, relation::at_least};
}
inline fact above(const std::string &name, const polynomial &p) {
  return {name, p, relation::above};
}
inline fact equal(const std::string &name, const polynomial &p) {
  return {name, p, relation::equal};
}
inline fact holds(const decision &d, const literal &l) {
  const decision::inequality i = d.holds(l);
  return {l.name, i.value, i.strict ? relation::above : relation::at_least};
}
inline fact fails(const decision &d, const literal &l) {
  const decision::inequality i = d.fails(l);
  return {"not " + l.name, i.value, i.strict ? relation::above : relation::at_least};
}

// The facts, and after them that every literal of the way holds.
inline std::vector<fact> with(const decision &d, const way &w, std::vector<fact> facts) {
  for (const literal &l : w.all)
    facts.push_back(holds(d, l));
  return facts;
}
// The facts, and after them that a way of one literal fails. A decision without that way says nothing.
inline void add_failure(const decision &d, const std::string &name, std::vector<fact> &facts) {
  if (const way *w = d.find(name); w && w->all.size() == 1)
    facts.push_back(fails(d, w->all.front()));
}

// One claim for each literal by which a way can fail, since a way fails where one of its literals does; where
// the decision has no such way, or one that asks for nothing, the facts alone. `prove` adds the certificate
// by the literal's name.
template <class Prove>
void add_failures(const decision &d, const std::string &name, const std::string &what, const std::vector<fact> &facts,
                  std::vector<claim> &out, const Prove &prove) {
  const way *w = d.find(name);
  if (!w) {
    out.push_back({what + ", but there is no " + name, facts, {}, {}});
    return;
  }
  for (const literal &l : w->all) {
    claim c{what + ", not " + l.name, facts, {}, {}};
    c.facts.push_back(fails(d, l));
    prove(l.name, c);
    out.push_back(std::move(c));
  }
}

} // namespace meetc::decisions_round

#endif
