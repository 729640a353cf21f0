// Lists of the kinds, the predicates and the formulas of a namespace, for code that does the same with each of them.
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string kind_text(const lower::lowered_kind &k) {
  return fmt::format("struct {0}_kind {{\n  using shape = {0}_shape;\n  static constexpr const char *name = \"{1}\";\n"
                     "  template <class T> MEETC_HD static constexpr {0}<T> in(const T *row) {{ return "
                     "detail::{0}_in(row); }}\n}};\n",
                     identifier(k.name), k.name);
}

// Calls with the kernels that are signs, or are none.
std::string calls(const unit &u, bool signs) {
  const auto elements = element_kinds(u);
  std::string out;
  for (std::size_t i = 0; i < u.kernels.size(); ++i) {
    const lower::kernel &k = u.kernels[i];
    if (!k.is_predicate || k.is_sign != signs || k.asked.kinds.size() != 2 ||
        element_place(elements, k, 0) == elements.size() || element_place(elements, k, 1) == elements.size())
      continue;
    out += fmt::format("  f(detail::on_kinds<{}, detail::{}_kind, detail::{}_kind>{{\"{}\"}});\n",
                       emitted_predicate(u, i).name, identifier(k.asked.kinds[0]->name),
                       identifier(k.asked.kinds[1]->name), k.asked.name());
  }
  return out;
}

} // namespace

std::string for_each_header(const unit &u) {
  const std::string space = identifier(u.scene.space);
  const std::vector<const lower::kernel *> all_formulas = formulas_on_columns(u);
  std::vector<std::string> headers{space + ".hpp", "shapes.hpp"};
  if (!all_formulas.empty())
    headers.emplace_back("detail/columns.hpp");
  std::string out =
      banner(u.scene, "The kinds of elements, the predicates on them and the formulas as lists, for code that does the "
                      "same with each.") +
      open_header(u.scene, "file_for_each", headers);
  out += "namespace detail {\n\n// A kind of element. in(): the element in a row.\n";
  for (const lower::lowered_kind *k : element_kinds(u))
    out += kind_text(*k);
  out +=
      "\n// A predicate, or a sign, with the kinds of its operands and its name in a scene.\n"
      "template <class P, class A, class B> struct on_kinds {\n  using type = P;\n  using a = A;\n  using b = B;\n"
      "  const char *name;\n};\n\n// A formula on the numbers of its operands (detail/columns.hpp), with its name in a "
      "scene.\n"
      "template <class F> struct on_columns {\n  using type = F;\n  const char *name;\n};\n\n} // namespace detail\n\n";
  std::string kinds, formulas;
  for (const lower::lowered_kind *k : element_kinds(u))
    kinds += fmt::format("  f(detail::{}_kind());\n", identifier(k->name));
  for (const lower::kernel *k : all_formulas)
    formulas += fmt::format("  f(detail::on_columns<detail::columns::{}>{{\"{}\"}});\n", identifier(k->asked.name()),
                            k->asked.text);
  const auto list = [&out](const char *what, const std::string &body) {
    out += fmt::format("template <class F> constexpr void for_each_{}({} &&f) {{\n{}}}\n", what,
                       body.empty() ? "[[maybe_unused]] F" : "F", body);
  };
  list("kind", kinds);
  list("predicate", calls(u, false));
  list("sign", calls(u, true));
  list("formula", formulas);
  return out + close_header(u.scene);
}

} // namespace meetc::target
