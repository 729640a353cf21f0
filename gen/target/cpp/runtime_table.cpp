// The table of kinds and predicates for a runtime, and the shapes of kinds.
#include "gen/target/cpp/bounds.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"
#include "gen/target/cpp/stored_values.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace meetc::target {

std::vector<const lower::kernel *> predicates_of(const unit &u) {
  std::vector<const lower::kernel *> out;
  for (const lower::kernel &k : u.kernels)
    if (lower::on_sets(k))
      out.push_back(&k);
  return out;
}

const lower::kernel *order_of(const unit &u, const lower::kernel &predicate) {
  const auto at = std::find_if(u.kernels.begin(), u.kernels.end(), [&](const lower::kernel &k) {
    return k.orders && k.orders == predicate.asked.asked && u.asks(lang::rung::certified);
  });
  return at == u.kernels.end() ? nullptr : &*at;
}

const lower::kernel *contacts_of(const unit &u, const lower::kernel &predicate) {
  const lang::predicate &p = *predicate.asked.asked;
  const lang::kind *const of =
      predicate.asked.kinds[predicate.decision.inputs_a == 4 ? 0 : 1]; // a ball's sign, if there is one
  const auto at = std::find_if(u.kernels.begin(), u.kernels.end(), [&](const lower::kernel &k) {
    return k.sides_of == of && k.asked.body->text == p.contacts && u.asks(lang::rung::certified);
  });
  return p.contacts.empty() || at == u.kernels.end() ? nullptr : &*at;
}

std::vector<const lower::lowered_kind *> element_kinds(const unit &u) {
  std::vector<const lower::lowered_kind *> out;
  for (const lower::lowered_kind &k : u.kinds)
    if (k.is_element)
      out.push_back(&k);
  std::sort(out.begin(), out.end(), [](const auto *x, const auto *y) { return x->declared < y->declared; });
  return out;
}

std::size_t element_place(const std::vector<const lower::lowered_kind *> &elements, const lower::kernel &k,
                          std::size_t operand) {
  const auto at = std::find_if(elements.begin(), elements.end(),
                               [&](const auto *e) { return e->name == k.asked.kinds[operand]->name; });
  return static_cast<std::size_t>(at - elements.begin());
}

// The CSV header: only the axes where there is one point, with numbers where there are more, or with their names where a
// hull mixes the points.
std::string csv_names(const lower::lowered_kind &k) {
  std::vector<std::string> names;
  for (const lower::stored_real &r : k.reals) {
    const std::string last = r.path.substr(r.path.find_last_of('.') + 1);
    if (r.position && !(k.enclosed && k.enclosed->mixes_points))
      names.push_back(k.points > 1 ? last + std::to_string(r.group) : last);
    else
      names.push_back(r.group < 0 ? last : r.path);
  }
  for (std::string &n : names)
    std::replace(n.begin(), n.end(), '.', '_');
  return join(names, ",");
}

namespace {

// The role of each stored number, by which it is moved.
std::vector<std::string> roles_of(const lower::lowered_kind &k) {
  std::vector<std::string> roles;
  int i = 0;
  for (const lower::stored_real &r : k.reals) {
    static const char *const axes[] = {"x", "y", "z"};
    roles.push_back(fmt::format("meetc::role::{}", r.position && r.axis < 3 ? axes[r.axis]
                                                   : i == k.enclosed->pad   ? "length"
                                                                            : "other"));
    ++i;
  }
  return roles;
}

// Where a row holds the coordinates of the hull's points, three for each point; -1: the coordinate is 0.
std::string hull_fields(const lower::enclosure &e) {
  std::vector<std::string> places;
  for (const std::vector<int> &point : e.hull)
    for (std::size_t axis = 0; axis < 3; ++axis)
      places.push_back(std::to_string(axis < point.size() ? point[axis] : -1));
  return join(places, ", ");
}

std::string shape_text(const lower::lowered_kind &k) {
  const lower::enclosure &e = *k.enclosed;
  std::string box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::string lo, hi;
    std::set<int> seen; // the corners of a box share their coordinates
    for (const std::vector<int> &point : e.hull) {
      if (!seen.insert(axis < point.size() ? point[axis] : -1).second)
        continue;
      const std::string value = axis < point.size() ? fmt::format("row[{}]", point[axis]) : "0.0f";
      lo = lo.empty() ? value : fmt::format("meetc::least_of({}, {})", lo, value);
      hi = hi.empty() ? value : fmt::format("meetc::most_of({}, {})", hi, value);
    }
    if (e.pad >= 0) {
      // One rounding and then one step outwards: the box is never too small.
      lo = fmt::format("meetc::step_down({} - row[{}])", lo, e.pad);
      hi = fmt::format("meetc::step_up({} + row[{}])", hi, e.pad);
    }
    box += fmt::format("    lo[{0}] = {1};\n    hi[{0}] = {2};\n", axis, lo, hi);
  }
  return fmt::format("struct {}_shape {{\n  static constexpr int fields = {}, hull = {}, pad = {};\n"
                     "  MEETC_HD static constexpr int coordinate(int point, int axis) {{\n"
                     "    constexpr int all[] = {{{}}};\n    return all[3 * point + axis];\n  }}\n"
                     "  MEETC_HD static constexpr meetc::role role_of(int field) {{\n"
                     "    constexpr meetc::role all[] = {{{}}};\n    return all[field];\n  }}\n"
                     "  MEETC_HD static void box(const float *row, float lo[3], float hi[3]) {{\n{}  }}\n"
                     "  MEETC_HD static bool obeys({}) {{ return {}; }}\n}};\n\n",
                     identifier(k.name), k.reals.size(), e.hull.size(), e.pad, hull_fields(e), join(roles_of(k), ", "),
                     box, e.rule ? "const float *row" : "const float *",
                     e.rule ? rule_test(*e.rule, [](int i) { return fmt::format("row[{}]", i); }) : "true");
}

std::string kind_entry(const lower::lowered_kind &k, int stored) {
  const lower::enclosure &e = *k.enclosed;
  const bool points_only =
      !e.mixes_points && std::all_of(k.reals.begin(), k.reals.end(), [](const auto &r) { return r.position; });
  const std::string name = identifier(k.name);
  return fmt::format("  {{\"{}\", \"{}\", {}, {}_roles, {}, meetc::boxes_of<{}_shape>, {}, meetc::stored_count({}), "
                     "{}, {}_hull, {}}},\n",
                     k.name, csv_names(k), k.reals.size(), name, points_only ? k.points : 0, name,
                     e.rule ? name + "_fault" : "nullptr", stored, e.hull.size(), name, e.pad);
}

std::string kind_functions(const lower::lowered_kind &k) {
  const lower::enclosure &e = *k.enclosed;
  const std::string name = identifier(k.name);
  std::string out = fmt::format("const meetc::role {}_roles[] = {{{}}};\n", name, join(roles_of(k), ", "));
  out += fmt::format("const int {}_hull[] = {{{}}};\n", name, hull_fields(e));
  if (e.rule)
    out +=
        fmt::format("const char *{0}_fault(const float *row) {{ return {0}_shape::obeys(row) ? nullptr : \"{1}\"; }}\n",
                    name, e.rule->text);
  return out + "\n";
}

} // namespace

std::string runtime_header(const unit &u) {
  return banner(u.scene, "The table by which a runtime knows this namespace.") + open_header(u.scene, "file_runtime") +
         "// The bounded kinds and the predicates on them, for the best instruction set that the library has and this\n"
         "// processor runs.\n"
         "const meetc::catalogue &catalogue();\n"
         "// The same for one instruction set; null if the library lacks it or this processor does not run it.\n"
         "const meetc::catalogue *catalogue_for(meetc::instruction_set set);\n" +
         close_header(u.scene);
}

std::string shapes_header(const unit &u) {
  std::string out =
      banner(u.scene, "Bounded kinds: where a row holds their points and radius, and their closed boxes.") +
      open_header(u.scene, "file_shapes") +
      "// coordinate(): the index in the row of a coordinate of a hull's point; -1: the coordinate is 0. pad: the "
      "index of "
      "the\n"
      "// radius around the hull; -1: there is none. box(): never too small, provided that subnormals are not "
      "flushed.\n"
      "// obeys(): whether a row of finite numbers is as the kind's `where` says.\n\n";
  for (const lower::lowered_kind *k : element_kinds(u))
    out += shape_text(*k);
  out.pop_back();
  return out + close_header(u.scene);
}

namespace {
// The box as the least float32 that is not below it.
std::string box_literal(double box) {
  return hex_literal(bound::rounded_up(ir::rational(box), 24), "f");
}
} // namespace

std::string runtime_source(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, "The table of kinds and predicates.");
  out += "#include <meetc/table/table_entry.hpp>\n\n";
  out += fmt::format("#include <{0}/{0}_runtime.hpp>\n#include <{0}/shapes.hpp>\n", space);
  out += fmt::format("\nMEETC_NAMESPACE({}) {{\n\n", space);
  std::string declared;
  for (const lower::kernel *k : predicates_of(u))
    declared +=
        fmt::format("meetc::predicate_info {}(const meetc::kind_info *a, const meetc::kind_info *b, int number_a,\n"
                    "    int number_b);\n",
                    info_function(*k));
  const std::size_t formulas = formulas_on_columns(u).size();
  if (formulas)
    declared += "const meetc::formula_info *formulas();\n";
  if (!declared.empty())
    out += "namespace detail { // each is defined in the source of its predicate, or in that of all formulas\n" +
           declared + "} // namespace detail\n\n";
  out += "namespace {\n\n";
  const auto kinds = element_kinds(u);
  const stored_numbers stored = number_stored(u);
  std::string entries, functions;
  for (const lower::lowered_kind *k : kinds) {
    functions += kind_functions(*k);
    const auto count = stored.count.find(k->name);
    entries += kind_entry(*k, count == stored.count.end() ? 0 : count->second);
  }
  if (!kinds.empty())
    out += functions + "const meetc::kind_info all_kinds[] = {\n" + entries + "};\n\n";
  std::string rows;
  for (const lower::kernel *k : predicates_of(u)) {
    const auto [a, b] = stored.of.at(k);
    rows += fmt::format("    detail::{}(&all_kinds[{}], &all_kinds[{}], {}, {}),\n", info_function(*k),
                        element_place(kinds, *k, 0), element_place(kinds, *k, 1), a, b);
  }
  if (!rows.empty())
    rows = "  static const meetc::predicate_info all_predicates[] = {\n" + rows + "  };\n";
  out +=
      fmt::format("}} // namespace\n\n// The table of the instruction set that this is compiled for.\n"
                  "const meetc::catalogue &compiled_catalogue() {{\n{}  static const meetc::catalogue c{{\"{}\", {}, "
                  "{}, {}, {}, {}, {}, {}, MEETC_COMPILED_FOR}};\n  return c;\n}}\n\n}} // namespace {}\n",
                  rows, u.scene.space, kinds.empty() ? "nullptr" : "all_kinds", kinds.size(),
                  rows.empty() ? "nullptr" : "all_predicates", predicates_of(u).size(),
                  formulas ? "detail::formulas()" : "nullptr", formulas, box_literal(u.scene.box), space);
  out += fmt::format("\n#if !defined(MEETC_INSTRUCTION_SET) // compiled once\nnamespace {} {{\n\n", space);
  std::string cases;
  for (const char *set : {"avx2", "avx512"}) {
    const std::string condition = fmt::format("#if defined(MEETC_WITH_{})\n", set);
    out +=
        fmt::format("{}namespace {} {{\nconst meetc::catalogue &compiled_catalogue();\n}}\n#endif\n", condition, set);
    cases += fmt::format("{}  case meetc::instruction_set::{}:\n    return &{}::compiled_catalogue();\n#endif\n",
                         condition, set, set);
  }
  out +=
      fmt::format("\nconst meetc::catalogue *catalogue_for(meetc::instruction_set set) {{\n"
                  "  if (!meetc::runs_here(set))\n    return nullptr;\n"
                  "  switch (set) {{\n  case meetc::instruction_set::baseline:\n    return &compiled_catalogue();\n{}"
                  "  default:\n    return nullptr;\n  }}\n}}\n\n"
                  "const meetc::catalogue &catalogue() {{\n"
                  "  for (int i = meetc::instruction_set_count; i-- > 1;)\n"
                  "    if (const meetc::catalogue *best = catalogue_for(static_cast<meetc::instruction_set>(i)))\n"
                  "      return *best;\n"
                  "  return compiled_catalogue();\n}}\n\n}} // namespace {}\n#endif\n",
                  cases, space);
  return out;
}

} // namespace meetc::target
