#include "gen/lang/analytic.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::lang {

const std::vector<analytic> &analytics() {
  static const std::vector<analytic> all{
      {"gives", "`gives(X)`", "the geometry of a blade of this kind, as `[gives.X]` says"},
      {"exp", "`exp(B)`", "Σ Bᵏ / k!, for a bivector B"},
      {"log", "`log(V)`", "the bivector B with exp(B) = V / \\|V\\| and the least angle, at most π"},
      {"sqrt", "`sqrt(V)`", "the versor R with R R = V / \\|V\\| and ⟨R⟩₀ ≥ 0"},
      {"norm", "`norm(V)`", "√⟨V ~V⟩₀"},
      {"normalise", "`normalise(V)`", "V / \\|V\\|, where \\|V\\|² = V ~V"},
      {"pose", "`pose(V)`", "the motion V X ~V of points as a 3×4 matrix, row by row, in double"},
  };
  return all;
}

const analytic *called_analytic(const algebra &a, const expr &e) {
  if (e.kind != op::call || a.find_function(e.text) || a.find_predicate(e.text) || a.find_kind(e.text))
    return nullptr;
  const auto at =
      std::find_if(analytics().begin(), analytics().end(), [&](const analytic &f) { return e.text == f.name; });
  return at == analytics().end() ? nullptr : &*at;
}

void refuse_analytic(const expr &call) {
  throw spec_error(
      call.where, fmt::format("'{0}' is no polynomial, and so stands in no formula and no sign; ask for it as a kernel "
                              "of its own, '{0}(KIND)', and pass its value on",
                              call.text));
}

std::vector<kernel_request> take_analytic(const algebra &a, std::vector<kernel_request> &kernels) {
  std::vector<kernel_request> out;
  std::vector<kernel_request> rest;
  for (kernel_request &k : kernels)
    (called_analytic(a, *k.what) ? out : rest).push_back(std::move(k));
  kernels = std::move(rest);
  return out;
}

} // namespace meetc::lang
