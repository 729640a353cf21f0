#include "gen/zero_kernels.hpp"

#include "gen/support/output.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc {
namespace {

bool is_zero(const lower::kernel &k) {
  if (k.is_predicate)
    return k.is_sign && k.decision.value.unit == 0;
  const ir::program &stored = k.value.from_stored; // it may be zero where the one of general blades is not
  return (k.value.is_expanded() && k.value.polynomials.front().is_zero()) ||
         (k.value.is_number() && stored.nodes.is_constant(stored.results.front(), 0));
}

} // namespace

void tell_zero_kernels(const compilation &c) {
  std::vector<std::string> listed, asked;
  for (const lower::kernel &k : c.kernels)
    asked.push_back(k.asked.text);
  for (const lang::kernel_request &z : c.scene->zero) {
    const std::string text = lang::print(*z.what);
    const auto at = std::find(asked.begin(), asked.end(), text);
    if (at == asked.end())
      throw spec_error(
          z.where, fmt::format("scene.zero lists '{}', which scene.kernels does not{}", text, nearest(text, asked)));
    if (!is_zero(c.kernels[static_cast<std::size_t>(at - asked.begin())]))
      throw spec_error(z.where, fmt::format("scene.zero lists '{}', which is not zero", text));
    listed.push_back(text);
  }
  for (const lower::kernel &k : c.kernels)
    if (is_zero(k) && std::find(listed.begin(), listed.end(), k.asked.text) == listed.end())
      warn({k.asked.where,
            fmt::format("'{0}' is zero for all operands; if that is meant, say so: zero = ['{0}']", k.asked.text)});
}

} // namespace meetc
