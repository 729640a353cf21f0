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

// The facts, followed by the fact that each literal of the way holds.
inline std::vector<fact> with(const decision &d, const way &w, std::vector<fact> facts) {
  for (const literal &l : w.all)
    facts.push_back(holds(d, l));
  return facts;
}
// The facts, followed by the fact that a way with one literal fails. A decision without that way adds nothing.
inline void add_failure(const decision &d, const std::string &name, std::vector<fact> &facts) {
  if (const way *w = d.find(name); w && w->all.size() == 1)
    facts.push_back(fails(d, w->all.front()));
}

// One claim for each literal of a way, since a way fails if one of its literals does; only the facts if the
// decision has no such way, or one without literals. `prove` adds the certificate by the name of the literal.
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
