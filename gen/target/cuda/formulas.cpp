// The launchers of formulas on columns.
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/cuda/cuda.hpp"

#include <fmt/format.h>

namespace meetc::target {

std::string cuda_formulas(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string entries;
  for (const lower::kernel *k : formulas_on_columns(u))
    entries += fmt::format("    meetc::cuda::launchers_of<::{}::detail::columns::{}>(\"{}\"),\n", space,
                           identifier(k->asked.name()), k->asked.text);
  return banner(u.scene, "Launchers of formulas on a CUDA device.") +
         fmt::format(
             "#include <{0}/{0}_cuda.hpp>\n#include <{0}/detail/columns.hpp>\n#include <meetc/cuda/formula.hpp>\n\n"
             "namespace {0} {{\nnamespace cuda {{\nnamespace detail {{\n\n"
             "const meetc::cuda::formula_launchers *formulas() {{\n"
             "  static const meetc::cuda::formula_launchers all[] = {{\n{1}  }};\n  return all;\n}}\n\n"
             "}} // namespace detail\n}} // namespace cuda\n}} // namespace {0}\n",
             space, entries);
}

} // namespace meetc::target
