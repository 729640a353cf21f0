#include "tests/decisions/round/solver.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <set>
#include <stdexcept>

namespace meetc::decisions_round {
namespace {

std::string number(const rational &q) {
  const rational size = abs(q);
  const std::string text = size.get_den() == 1
                               ? size.get_num().get_str()
                               : fmt::format("(/ {} {})", size.get_num().get_str(), size.get_den().get_str());
  return q < 0 ? "(- " + text + ")" : text;
}

std::string text(const polynomial &p) {
  std::string sum;
  for (const poly::term &t : p.terms()) {
    std::string one = number(t.coefficient);
    for (const poly::power &f : t.factors)
      for (int i = 0; i < f.exponent; ++i)
        one += ' ' + p.in().name(f.variable);
    sum += t.factors.empty() ? ' ' + one : " (* " + one + ')';
  }
  return "(+ 0" + sum + ")";
}

std::string text(const fact &f) {
  const char *is = f.is == relation::equal ? "=" : f.is == relation::above ? ">" : ">=";
  return fmt::format("({} {} 0)", is, text(f.value));
}

std::string text(const decision &d, const literal &l) {
  const decision::inequality i = d.holds(l);
  return fmt::format("({} {} 0)", i.strict ? ">" : ">=", text(i.value));
}
std::string text(const decision &d) {
  std::string near, far;
  for (const way &w : d.near) {
    near += " (and true";
    for (const literal &l : w.all)
      near += ' ' + text(d, l);
    near += ')';
  }
  for (const literal &l : d.far)
    far += ' ' + text(d, l);
  return fmt::format("(and (or false{}){})", near, d.bounded_below ? " (or false" + far + ")" : "");
}

// Declares the ring's variables and asserts.
query script(const std::string &name, const std::vector<std::string> &assertions) {
  std::string out = "; " + name + "\n(set-logic QF_NRA)\n";
  for (const std::string &v : gram::ring().numbers.names())
    out += fmt::format("(declare-const {} Real)\n", v);
  for (const std::string &a : assertions)
    out += "(assert " + a + ")\n";
  return {name, out + "(check-sat)\n"};
}

std::string at_least(const polynomial &p) {
  return fmt::format("(>= {} 0)", text(p));
}
std::string above(const polynomial &p) {
  return fmt::format("(> {} 0)", text(p));
}

std::vector<query> whole_segment(const emitted &e, const decision &d) {
  const gram &g = gram::ring();
  const std::vector<std::string> real = {at_least(g.ww), at_least(g.g11), at_least(g.R),
                                         at_least(g.ww * g.g11 - square(g.w1))};
  const auto within = [&](const polynomial &s) { return std::vector<std::string>{at_least(s), at_least(g.one - s)}; };
  const polynomial at_s = g.reach(g.s, g.zero), at_t = g.reach(g.t, g.zero);
  std::vector<std::string> miss = real, hit = real;
  // A point is within reach and, for a surface, one is not nearer than it; yet there is no hit.
  for (const std::string &a : within(g.s))
    miss.push_back(a);
  miss.push_back(at_least(g.R - at_s));
  if (e.surface) {
    for (const std::string &a : within(g.t))
      miss.push_back(a);
    miss.push_back(at_least(at_t - g.R));
  }
  miss.push_back("(not " + text(d) + ")");
  // There is a hit; yet the nearest point, the foot clamped to the ends, is out of reach, or for a surface both
  // ends are inside.
  hit.push_back(fmt::format("(or (and (<= w1 0) (= s 0)) (and (> w1 0) (>= w1 g11) (= s 1))"
                            " (and (< 0 w1 g11) (= (* s g11) w1)))"));
  hit.push_back(fmt::format("(or {} {})", above(at_s - g.R),
                            e.surface ? fmt::format("(and {} {})", above(g.R - g.ww), above(g.R - g.wb)) : "false"));
  hit.push_back(text(d));
  return {script(e.name + ": they touch, yet no hit", miss), script(e.name + ": a hit, yet they do not touch", hit)};
}

query whole_spheres(const emitted &e, const decision &d) {
  const std::string touching =
      e.surface ? "(and (<= d (+ r1 r2)) (>= d (- r1 r2)) (>= d (- r2 r1)))" : "(<= d (+ r1 r2))";
  return script(e.name + ": hit and touch differ", {"(>= d 0)", "(>= r1 0)", "(>= r2 0)", "(= dd (* d d))",
                                                    fmt::format("(distinct {} {})", text(d), touching)});
}

} // namespace

query query_of(const claim &c) {
  std::set<std::string> used;
  for (const product &p : c.products)
    used.insert(p.of.begin(), p.of.end());
  for (const equation &e : c.equations)
    used.insert(e.of);
  const bool proved = refusal(c).empty();
  std::vector<std::string> assertions;
  for (const fact &f : c.facts)
    if (!proved || used.count(f.name))
      assertions.push_back(text(f));
  return script(c.name, assertions);
}

std::vector<query> whole_queries(const emitted &e, const decision &d) {
  if (e.value)
    return {};
  if (e.second == other::sphere)
    return {whole_spheres(e, d)};
  if (e.second == other::segment)
    return whole_segment(e, d);
  return {};
}

// The weights of the point are m0, m1, m2, those of the foot l0, l1, l2. At the step tau = m_k / (m_k - l_k),
// where the weight of corner k becomes zero, no other is negative, for one k with l_k <= 0; times m_k - l_k.
query way_out() {
  std::string out = "; a way out of a triangle leaves it through an edge\n(set-logic QF_NRA)\n";
  for (const char *v : {"m0", "m1", "m2", "l0", "l1", "l2"})
    out += fmt::format("(declare-const {} Real)\n", v);
  out += "(assert (and (>= m0 0) (>= m1 0) (>= m2 0) (= (+ m0 m1 m2) 1) (= (+ l0 l1 l2) 1)))\n"
         "(assert (or (<= l0 0) (<= l1 0) (<= l2 0)))\n";
  for (int k = 0; k < 3; ++k) {
    std::string stays;
    for (int j = 0; j < 3; ++j)
      stays += fmt::format(" (>= (- (* m{0} l{1}) (* l{0} m{1})) 0)", k, j);
    out += fmt::format("(assert (not (and (<= l{0} 0){1})))\n", k, stays);
  }
  return {"a way out of a triangle leaves it through an edge", out + "(check-sat)\n"};
}

std::string answer(const query &q, const std::string &z3, const std::string &folder, int seconds) {
  const std::string path = folder + "/query.smt2";
  std::ofstream(path) << q.script;
  const std::string command = fmt::format("'{}' -T:{} '{}' 2>&1", z3, seconds, path);
  const std::unique_ptr<FILE, int (*)(FILE *)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe)
    throw std::runtime_error("cannot start " + z3);
  std::string said;
  for (int c = std::fgetc(pipe.get()); c != EOF && c != '\n'; c = std::fgetc(pipe.get()))
    said += static_cast<char>(c);
  return said;
}

} // namespace meetc::decisions_round
