#include "gen/lower/kernel/relations.hpp"

#include "gen/lower/kernel/kernel.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace meetc::lower {
namespace {

constexpr int draws = 3; // of each sample that is checked

multivector residual(expander &expand, const lang::relation &r, const environment &env) {
  return expand.evaluate_multivector(*r.left, env) - expand.evaluate_multivector(*r.right, env);
}

// Rational numbers, the same ones in each run.
class drawing {
public:
  rational operator()() {
    rational q(static_cast<long>(random_() % 19) - 9, static_cast<long>(random_() % 5) + 1);
    q.canonicalize();
    return q;
  }

private:
  std::mt19937 random_{7};
};

void check_sample(const model &m, const lang::kind &k, const lang::expr &sample) {
  const std::vector<blade> room = support(m, k);
  const poly::ring none({});
  decision unused;
  drawing draw;
  for (int made = 0, tried = 0; made < draws; ++tried) {
    expander expand(m, none, unused);
    expand.allow_bits(1 << 20);
    environment env;
    for (const lang::field &f : k.sample_of)
      env.emplace_back(f.name, f.type == "real" ? value{multivector(0, poly::poly(none, draw()))}
                                                : expand.operand(*m.spec().find_kind(f.type), std::ref(draw)));
    multivector v;
    try {
      v = expand.evaluate_multivector(sample, env);
    } catch (const spec_error &) { // a divisor may be 0
      if (tried < 20)
        continue;
      throw;
    }
    ++made;
    for (const auto &[at, c] : v.terms())
      if (std::find(room.begin(), room.end(), at) == room.end())
        throw spec_error(sample.where,
                         fmt::format("this sample of '{}' has a coefficient of {}, which the kind's blade has not",
                                     k.name, m.working().name(at)));
    for (const lang::relation &r : k.relations)
      if (!residual(expand, r, {{k.name, value{v}}}).is_zero())
        throw spec_error(sample.where, fmt::format("this sample of '{}' does not satisfy '{} = {}'", k.name,
                                                   lang::print(*r.left), lang::print(*r.right)));
  }
}

} // namespace

std::vector<stated_relation> relations_on(const model &m, const lang::kind &k, const std::vector<blade> &blades,
                                          const poly::ring &numbers, std::size_t operand, std::size_t first) {
  std::vector<stated_relation> out;
  decision unused;
  expander expand(m, numbers, unused);
  multivector general;
  for (std::size_t i = 0; i < blades.size(); ++i)
    general.add(blades[i], poly::poly::variable(numbers, static_cast<int>(first + i)));
  for (const lang::relation &r : k.relations) {
    const multivector zero = residual(expand, r, {{k.name, value{general}}});
    for (const auto &[at, c] : zero.terms())
      out.push_back({operand, &r, c});
  }
  return out;
}

void check_relations(const model &m, const lang::kind &k) {
  if (k.relations.empty())
    return;
  const kind_layout layout = m.layout(k);
  std::vector<std::string> names;
  for (const stored_real &r : layout.reals)
    names.push_back(r.path);
  const poly::ring stored(names);
  decision unused;
  expander expand(m, stored, unused);
  const multivector own = expand.blade_of(expand.operand(k, ""), k.where);
  for (const lang::relation &r : k.relations)
    if (!r.nearly && !residual(expand, r, {{k.name, value{own}}}).is_zero())
      throw spec_error(r.where,
                       fmt::format("'{} = {}' does not hold identically in the stored numbers of '{}'; if rounding "
                                   "makes it true, state it as relations.nearly, with relations.within",
                                   lang::print(*r.left), lang::print(*r.right), k.name));
  for (const lang::expr_ptr &sample : k.samples)
    check_sample(m, k, *sample);
}

} // namespace meetc::lower
