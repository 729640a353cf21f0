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

namespace {

bool is_wildcard(const expr &e) {
  return e.kind == op::name && e.text == "*";
}

// The kinds that gives(*) stands for.
std::vector<std::string> kinds_that_give(const scene &s, const expr &call) {
  std::vector<std::string> out, known;
  for (const reading &r : s.in.readings) {
    known.push_back(r.kind);
    if (s.kinds.empty() ||
        std::any_of(s.kinds.begin(), s.kinds.end(), [&](const field &f) { return f.type == r.kind; }))
      out.push_back(r.kind);
  }
  if (!out.empty())
    return out;
  const std::string kind = s.kinds.empty() ? s.in.kinds.front().name : s.kinds.front().type;
  throw spec_error(call.where,
                   fmt::format("'{}' stands for the kinds with a table [gives.KIND], and {}; write one in the algebra, "
                               "as [gives.{}] with a line for each thing that is read back",
                               print(call),
                               known.empty()
                                   ? "the algebra has no such table"
                                   : fmt::format("none of the scene's kinds has one, only {}", join(known, ", ")),
                               kind));
}

} // namespace

void take_analytic(scene &s) {
  std::vector<kernel_request> rest;
  for (kernel_request &k : s.kernels) {
    if (!called_analytic(s.in, *k.what)) {
      rest.push_back(std::move(k));
      continue;
    }
    const expr &call = *k.what;
    if (call.args.size() != 1 || !is_wildcard(*call.args[0])) {
      s.analytic.push_back(std::move(k));
      continue;
    }
    if (call.text != "gives")
      throw spec_error(call.args[0]->where,
                       fmt::format("'*' stands for kinds in 'gives(*)' and in formulas, and not in '{0}(*)'; name the "
                                   "kind, as in '{0}({1})'",
                                   call.text, s.in.kinds.front().name));
    for (const std::string &kind : kinds_that_give(s, call))
      s.analytic.push_back({parse_expression(fmt::format("{}({})", call.text, kind), call.where.text()), k.where});
  }
  s.kernels = std::move(rest);
}

} // namespace meetc::lang
