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

using named_blade = std::vector<std::string>;

bool are_same(const named_blade &a, const named_blade &b) {
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end());
}

// The blades of these grades by the names of their vectors, in the algebra's order: among the places that the blades of
// `order` have together, they take that order.
std::vector<named_blade> blades_of(const algebra &a, const std::vector<int> &grades) {
  std::vector<named_blade> out, listed;
  const int n = static_cast<int>(a.vectors.size());
  for (int grade = 0; grade <= n; ++grade)
    for (const std::vector<int> &vectors : subsets(n, grade)) {
      named_blade b;
      for (const int v : vectors)
        b.push_back(a.vectors[static_cast<std::size_t>(v)]);
      out.push_back(std::move(b));
    }
  const auto is_in = [](const std::vector<named_blade> &all, const named_blade &b) {
    return std::any_of(all.begin(), all.end(), [&](const named_blade &other) { return are_same(other, b); });
  };
  for (const ordered_blade &b : a.order)
    if (is_in(out, b.vectors))
      listed.push_back(b.vectors);
  auto next = listed.begin();
  for (named_blade &b : out)
    if (is_in(listed, b))
      b = *next++;
  std::erase_if(out, [&](const named_blade &b) {
    return std::find(grades.begin(), grades.end(), static_cast<int>(b.size())) == grades.end();
  });
  return out;
}

void add_blade(const named_blade &vectors, kind &k) {
  const location &at = k.grades_where;
  std::string name = vectors.empty() ? "c_1" : "c";
  expr_ptr blade;
  for (const std::string &vector : vectors) {
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
    for (const named_blade &b : blades_of(a, k.grades))
      add_blade(b, k);
  }
}

} // namespace meetc::lang
