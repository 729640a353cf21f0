// The files of the target: those of each kernel, and those that a namespace has once.
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {

std::string cpp_text(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  const std::string head = banner(u.scene, k.asked.text);
  if (k.is_predicate)
    return broken_lines(head + kernel_header(u, kernel));
  return broken_lines(head + open_header(u.scene, "kernel_" + k.asked.name(), {"kinds.hpp"}, {}, formula_support) +
                      formula_header(u, k) + close_header(u.scene));
}

namespace {
// The files of a kernel of signs besides its own header.
void add_parts(const unit &u, std::size_t kernel, std::vector<file> &out) {
  const std::string space = identifier(u.scene.space), name = u.kernels[kernel].asked.name();
  const emitted_predicate p(u, kernel);
  if (p.bounds)
    out.push_back({fmt::format("{}/detail/{}_bounds.hpp", space, name), bounds_header(p)});
  out.push_back({fmt::format("{}/detail/{}_later.hpp", space, name), later_header(p)});
  if (u.asks(lang::rung::certified) || u.asks(lang::rung::exact))
    out.push_back({fmt::format("{}/alone/{}.hpp", space, name), alone_header(p)});
  out.push_back({fmt::format("{}/src/{}.cpp", space, name), predicate_source(p)});
}
} // namespace

std::vector<file> cpp_files(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::vector<file> out{{space + "/kinds.hpp", kinds_header(u)}};
  std::vector<std::string> headers{"kinds.hpp"};
  for (std::size_t i = 0; i < u.kernels.size(); ++i) {
    headers.push_back(u.kernels[i].asked.name() + ".hpp");
    out.push_back({space + '/' + headers.back(), cpp_text(u, i)});
    if (u.kernels[i].is_predicate)
      add_parts(u, i, out);
  }
  for (std::size_t i = 0; i < u.analytic.size(); ++i) {
    headers.push_back(u.analytic[i].name + ".hpp");
    out.push_back({space + '/' + headers.back(), analytic_text(u, i)});
  }
  if (!formulas_on_columns(u).empty()) {
    out.push_back({space + "/detail/columns.hpp", columns_header(u)});
    out.push_back({space + "/src/formulas.cpp", formulas_source(u)});
  }
  std::sort(headers.begin() + 1, headers.end());
  out.push_back({space + '/' + space + ".hpp", banner(u.scene, "Everything that the scene asks for.") +
                                                   open_header(u.scene, "file_all", headers) + close_header(u.scene)});
  out.push_back({space + "/header_only.hpp", header_only(u)});
  out.push_back({space + "/shapes.hpp", shapes_header(u)});
  if (std::any_of(u.kinds.begin(), u.kinds.end(), [](const lower::lowered_kind &k) { return k.has_blade(); }))
    out.push_back({space + "/operators.hpp", operators_header(u)});
  if (!predicates_of(u).empty() || !formulas_on_columns(u).empty())
    out.push_back({space + "/for_each.hpp", for_each_header(u)});
  out.push_back({space + '/' + space + "_runtime.hpp", runtime_header(u)});
  out.push_back({space + '/' + space + "_runtime.cpp", runtime_source(u)});
  for (file &f : out)
    f.text = broken_lines(f.text);
  return out;
}

} // namespace meetc::target
