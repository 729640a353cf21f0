#include "gen/ir/evaluate.hpp"
#include "gen/ir/residue.hpp"
#include "gen/verify/dense_model.hpp"
#include "gen/verify/verify.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace meetc::verify {
namespace {

std::string describe(const std::vector<oracle::rational> &numbers) {
  std::string out;
  for (const auto &q : numbers)
    out += (out.empty() ? "" : ", ") + q.get_str();
  return out;
}

class checker {
public:
  checker(const lower::model &m, const lower::kernel &k, unsigned seed)
      : m_(m), k_(k), dense_(dense_evaluator_of(m)), random_(seed) {}

  report run(long cases) {
    if (!whole())
      return out_;
    for (long i = 0; i < cases; ++i) {
      blades();
      if (!k_.value.stored_inputs.empty())
        stored();
    }
    for (const lang::kind *kind : k_.asked.kinds)
      for (const lower::blade_maker &maker : lower::makers(m_, *kind))
        for (long i = 0; i < std::min(cases, 20L); ++i)
          made(*kind, maker);
    return out_;
  }

  report run_sign(long cases) {
    const lower::predicate &p = k_.decision;
    for (long i = 0; i < cases; ++i) {
      std::vector<oracle::rational> inputs;
      for (std::size_t n = 0; n < p.stored_inputs.size(); ++n)
        inputs.emplace_back(static_cast<long>(random_() % 5)); // small, so that zeros occur
      if (!valid(inputs))
        continue;
      dense_scope scope;
      std::size_t next = 0;
      for (std::size_t o = 0; o < k_.asked.kinds.size(); ++o)
        scope[k_.asked.names[o]] = dense_.operand(*k_.asked.kinds[o], inputs, next);
      int sign = p.value.unit;
      const auto values =
          p.common.atoms.empty() ? std::vector<oracle::rational>{} : ir::evaluate(p.common.code, inputs);
      for (const auto &[atom, exponent] : p.value.atoms) {
        const auto at = std::find(p.common.atoms.begin(), p.common.atoms.end(), atom) - p.common.atoms.begin();
        const int s = sgn(values[static_cast<std::size_t>(at)]);
        sign *= exponent == 2 ? s * s : s;
      }
      compare(dense_.evaluate(*k_.asked.body, scope), number, {sign}, "sign", inputs);
    }
    return out_;
  }

private:
  const lower::model &m_;
  const lower::kernel &k_;
  dense_evaluator dense_;
  std::mt19937 random_;
  report out_;
  const std::vector<lower::basis_blade> number{{}}; // the scalar

  static const std::vector<poly::poly> &expected(const lower::formula &f, const lower::assumptions &a) {
    return a.taken.empty() ? f.polynomials : a.computed;
  }

  // Whether every coefficient of the result is an output, and the program of blades computes the polynomials.
  bool whole() {
    const lower::formula &f = k_.value;
    ++out_.cases;
    if (f.result.empty() || f.from_blades.results.size() != f.result.size() ||
        f.result_names.size() != f.result.size() || (f.is_number() && f.from_stored.results.size() != 1))
      out_.first_wrong = fmt::format("{} lacks a coefficient", k_.asked.text);
    else if (f.is_expanded() && !ir::same_values(f.from_blades, expected(f, f.assumed), *f.numbers))
      out_.first_wrong = fmt::format("the program of {} does not expand to its polynomials", k_.asked.text);
    else
      return true;
    ++out_.wrong;
    return false;
  }

  // Whether the operands of these stored numbers obey the rules of their kinds, which signs assume.
  bool valid(const std::vector<oracle::rational> &inputs) const {
    auto at = inputs.begin();
    return std::all_of(k_.asked.kinds.begin(), k_.asked.kinds.end(), [&](const lang::kind *kind) {
      const auto from = at;
      at += static_cast<std::ptrdiff_t>(m_.layout(*kind).reals.size());
      return lower::obeys(lower::rule_of(m_, *kind), {from, at});
    });
  }

  std::vector<oracle::rational> numbers(std::size_t n) {
    std::vector<oracle::rational> out;
    for (std::size_t i = 0; i < n; ++i) {
      oracle::rational q(static_cast<long>(random_() % 41) - 20, static_cast<long>(random_() % 7) + 1);
      q.canonicalize();
      out.push_back(q);
    }
    return out;
  }

  // A basis blade of the working basis as a dense multivector, by the names of its vectors.
  oracle::multivector dense(const lower::basis_blade &b) const {
    const std::vector<std::string> &names = m_.working().names();
    oracle::multivector out = dense_.algebra().scalar(1);
    for (const std::string &v : b.vectors) {
      const auto at = std::find(names.begin(), names.end(), v) - names.begin();
      out = oracle::outer(out, dense_.algebra().vector(static_cast<int>(at)));
    }
    return out;
  }
  std::vector<lower::basis_blade> blades_of(const lang::kind &kind) const {
    return lower::named(m_.working(), lower::support(m_, kind));
  }
  // The coefficient on a basis blade: the one of its mask, with the sign of its product.
  static std::size_t mask_of(const oracle::multivector &blade) {
    const auto at = std::find_if(blade.begin(), blade.end(), [](const oracle::rational &q) { return q != 0; });
    return static_cast<std::size_t>(at - blade.begin());
  }

  void compare(const oracle::multivector &want, const std::vector<lower::basis_blade> &blades,
               const std::vector<oracle::rational> &have, const char *what,
               const std::vector<oracle::rational> &inputs) {
    ++out_.cases;
    oracle::multivector got = dense_.algebra().zero();
    for (std::size_t i = 0; i < blades.size(); ++i)
      got = oracle::add(got, oracle::scale(have[i], dense(blades[i])));
    if (got == want)
      return;
    if (out_.wrong++ == 0)
      out_.first_wrong = fmt::format("{} of {} at ({})", what, k_.asked.text, describe(inputs));
  }

  // A blade that satisfies the relations of its kind: one of the samples, or the blade of stored numbers.
  oracle::multivector related(const lang::kind &kind) {
    for (;;) {
      const auto draw = [&](const std::vector<lang::field> &of) {
        dense_scope scope;
        for (const lang::field &f : of) {
          const lang::kind *part = m_.spec().find_kind(f.type);
          const auto inputs = numbers(part ? m_.layout(*part).reals.size() : 1);
          std::size_t next = 0;
          scope[f.name] =
              part ? dense_.operand(*part, inputs, next) : dense_value{dense_.algebra().scalar(inputs[0]), {}};
        }
        return scope;
      };
      if (kind.samples.empty())
        return dense_.evaluate(*kind.blade, draw(kind.store));
      try {
        return dense_.evaluate(*kind.samples[random_() % kind.samples.size()], draw(kind.sample_of));
      } catch (const spec_error &) { // a divisor was 0; lowering has drawn samples too, and succeeded
      }
    }
  }

  // Operands are general elements of their kinds' supports, for all of which the formula holds; where a program assumes
  // relations, they satisfy them.
  void blades() {
    const lower::formula &f = k_.value;
    const bool assumes = !f.assumed.taken.empty() || !f.prepared_assumed.taken.empty();
    auto inputs = numbers(f.blade_inputs.size());
    dense_scope scope;
    std::size_t at = 0;
    for (std::size_t i = 0; i < k_.asked.kinds.size(); ++i) {
      const lang::kind &kind = *k_.asked.kinds[i];
      const bool is_related = assumes && !kind.relations.empty();
      oracle::multivector operand = is_related ? related(kind) : dense_.algebra().zero();
      for (const lower::basis_blade &b : blades_of(kind)) {
        const oracle::multivector blade = dense(b);
        const std::size_t mask = mask_of(blade);
        if (is_related)
          inputs[at++] = operand[mask] * blade[mask];
        else
          operand[mask] = inputs[at++] * blade[mask];
      }
      scope[k_.asked.names[i]] = {operand, {}};
    }
    const oracle::multivector want = dense_.evaluate(*k_.asked.body, scope);
    compare(want, f.result_names, ir::evaluate(f.from_blades, inputs), "blades", inputs);
    if (!f.prepared.results.empty())
      compare(want, f.result_names, ir::evaluate(f.prepared, inputs), "prepared blades", inputs);
  }

  void stored() {
    const auto inputs = numbers(k_.value.stored_inputs.size());
    dense_scope scope;
    std::size_t next = 0;
    for (std::size_t i = 0; i < k_.asked.kinds.size(); ++i)
      scope[k_.asked.names[i]] = dense_.operand(*k_.asked.kinds[i], inputs, next);
    const oracle::multivector want = dense_.evaluate(*k_.asked.body, scope);
    compare(want, number, ir::evaluate(k_.value.from_stored, inputs), "stored numbers", inputs);
    if (!k_.value.for_pairs.results.empty())
      compare(want, number, ir::evaluate(k_.value.for_pairs, inputs), "stored values", inputs);
  }

  void made(const lang::kind &kind, const lower::blade_maker &maker) {
    const auto inputs = numbers(maker.inputs.size());
    const lang::expr *body = kind.blade.get();
    for (const lang::constructor &c : kind.from)
      if (c.name == maker.name)
        body = c.blade.get();
    dense_scope scope;
    std::size_t next = 0;
    for (const lang::field &f : maker.of)
      scope[f.name] = f.type == "real" ? dense_value{dense_.algebra().scalar(inputs.at(next++)), {}}
                                       : dense_.operand(*m_.spec().find_kind(f.type), inputs, next);
    compare(dense_.evaluate(*body, scope), blades_of(kind), ir::evaluate(maker.code, inputs),
            (kind.name + " " + maker.name).c_str(), inputs);
  }
};

} // namespace

report verify_formula(const lower::model &m, const lower::kernel &k, long cases, unsigned seed) {
  return checker(m, k, seed).run(cases);
}

report verify_sign(const lower::model &m, const lower::kernel &k, long cases, unsigned seed) {
  return checker(m, k, seed).run_sign(cases);
}

} // namespace meetc::verify
