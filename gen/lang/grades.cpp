#include "gen/lang/grades.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace meetc::lang {
namespace {

expr_ptr node(op kind, const location &where, const std::string &text, std::vector<expr_ptr> args = {}) {
  return std::make_shared<const expr>(expr{kind, where, text, std::move(args), {}});
}

// The subsets of n vectors with this many members, in the order of the vectors.
std::vector<std::vector<int>> subsets(int n, int members) {
  std::vector<std::vector<int>> out;
  std::vector<int> chosen;
  const auto choose = [&](const auto &self, int from) -> void {
    if (static_cast<int>(chosen.size()) == members) {
      out.push_back(chosen);
      return;
    }
    for (int v = from; v < n; ++v) {
      chosen.push_back(v);
      self(self, v + 1);
      chosen.pop_back();
    }
  };
  choose(choose, 0);
  return out;
}

void add_blade(const algebra &a, const std::vector<int> &vectors, kind &k) {
  const location &at = k.grades_where;
  std::string name = vectors.empty() ? "c_1" : "c";
  expr_ptr blade;
  for (const int v : vectors) {
    const std::string &vector = a.vectors[static_cast<std::size_t>(v)];
    name += '_' + vector;
    const expr_ptr factor = node(op::name, at, vector);
    blade = blade ? node(op::outer, at, "^", {blade, factor}) : factor;
  }
  k.store.push_back({name, "real", at});
  const expr_ptr number = node(op::name, at, name);
  const expr_ptr term = blade ? node(op::multiply, at, "*", {number, blade}) : number;
  k.blade = k.blade ? node(op::add, at, "+", {k.blade, term}) : term;
}

} // namespace

void read_grades(const toml_reader &in, const toml::table &t, const std::string &what, kind &k) {
  const toml::node &list = *t.get("grades");
  k.grades_where = in.place(list);
  for (const toml::node &item : in.as_array(list, what + ".grades")) {
    const std::optional<std::int64_t> grade = item.value_exact<std::int64_t>();
    if (!grade || *grade < 0)
      throw spec_error(in.place(item), fmt::format("{}.grades are whole numbers, as in [0, 2]", what));
    if (!k.grades.empty() && *grade <= k.grades.back())
      throw spec_error(in.place(item), fmt::format("{}.grades ascend", what));
    k.grades.push_back(static_cast<int>(std::min<std::int64_t>(*grade, 1000)));
  }
  if (k.grades.empty())
    throw spec_error(k.grades_where, what + ".grades is empty");
}

void complete_grades(algebra &a) {
  const int n = static_cast<int>(a.vectors.size());
  for (kind &k : a.kinds) {
    if (k.grades.empty())
      continue;
    if (k.grades.back() > n)
      throw spec_error(k.grades_where, fmt::format("kind '{}' has grade {}, and the algebra has {} vectors", k.name,
                                                   k.grades.back(), n));
    for (const int grade : k.grades)
      for (const std::vector<int> &vectors : subsets(n, grade))
        add_blade(a, vectors, k);
  }
}

} // namespace meetc::lang
