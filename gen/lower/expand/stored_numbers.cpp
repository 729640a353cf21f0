#include "gen/lower/expand/stored_numbers.hpp"

#include <fmt/format.h>

namespace meetc::lower {

stored_ring stored_numbers(const model &m, const std::vector<std::string> &names,
                           const std::vector<const lang::kind *> &kinds) {
  std::vector<std::string> variables;
  stored_ring out;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    for (const stored_real &r : m.layout(*kinds[i]).reals) {
      variables.push_back(names[i] + '.' + r.path);
      out.moves.push_back({static_cast<int>(i), r.group, r.axis, r.position});
    }
  out.numbers = std::make_shared<poly::ring>(std::move(variables));
  return out;
}

int input_of(const value &v, const char *what, const location &where) {
  const auto *m = std::get_if<multivector>(&v.is);
  if (m && m->is_scalar() && !m->is_zero()) {
    const auto terms = m->terms().begin()->second.terms();
    if (terms.size() == 1 && terms[0].coefficient == 1 && terms[0].factors.size() == 1 &&
        terms[0].factors[0].exponent == 1)
      return terms[0].factors[0].variable;
  }
  throw spec_error(where, fmt::format("{} must be a stored number", what));
}

} // namespace meetc::lower
