#include "gen/bound/grading.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace meetc::bound {
namespace {

using poly::rational;
using matrix = std::vector<std::vector<rational>>;

constexpr std::size_t most_choices = 20000; // of numbers that may be groups, far above any reasonable sign

// Brings m to reduced row echelon form, and returns the columns of its pivots, by row.
std::vector<std::size_t> reduce(matrix &m) {
  std::vector<std::size_t> pivots;
  const std::size_t columns = m.empty() ? 0 : m.front().size();
  for (std::size_t c = 0; c < columns && pivots.size() < m.size(); ++c) {
    const std::size_t r = pivots.size();
    const auto at = std::find_if(m.begin() + static_cast<std::ptrdiff_t>(r), m.end(),
                                 [c](const std::vector<rational> &row) { return row[c] != 0; });
    if (at == m.end())
      continue;
    std::swap(m[r], *at);
    const rational by = m[r][c];
    for (rational &x : m[r])
      x /= by;
    for (std::size_t i = 0; i < m.size(); ++i)
      if (const rational k = m[i][c]; i != r && k != 0)
        for (std::size_t j = c; j < columns; ++j)
          m[i][j] -= k * m[r][j];
    pivots.push_back(c);
  }
  m.resize(pivots.size());
  return pivots;
}

// A basis of the vectors that all rows are orthogonal to.
matrix null_space(matrix m, std::size_t columns) {
  const std::vector<std::size_t> pivots = reduce(m);
  matrix out;
  for (std::size_t free = 0; free < columns; ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end())
      continue;
    std::vector<rational> v(columns);
    v[free] = 1;
    for (std::size_t r = 0; r < pivots.size(); ++r)
      v[pivots[r]] = -m[r][free];
    out.push_back(std::move(v));
  }
  return out;
}

// The equations of weights, over the inputs that signs read.
matrix equations(const std::vector<const poly::poly *> &signs, const poly::local_origin &local,
                 const std::vector<int> &used) {
  const auto column = [&](int v) {
    return static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  };
  matrix out;
  for (const poly::poly *p : signs) {
    std::vector<rational> first;
    for (const poly::term &t : p->terms()) {
      std::vector<rational> row(used.size());
      for (const poly::power &f : t.factors)
        row[column(f.variable)] = f.exponent;
      if (first.empty()) {
        first = std::move(row);
        continue;
      }
      for (std::size_t i = 0; i < row.size(); ++i)
        row[i] -= first[i];
      out.push_back(std::move(row));
      if (out.size() > 2 * used.size()) // most of them repeat each other
        reduce(out);
    }
  }
  int position = -1;
  for (const int v : used)
    if (local.stored(v).position) {
      if (position >= 0) {
        std::vector<rational> row(used.size());
        row[column(position)] = 1, row[column(v)] = -1;
        out.push_back(std::move(row));
      }
      position = v;
    }
  return out;
}

// The weights of classes of numbers, by class and group, where the classes in `pure` are the groups; empty if they are not.
std::vector<std::vector<int>> weights_by(const matrix &basis, const std::vector<std::size_t> &pure) {
  // Rows of the basis, with the columns of `pure` first: after the reduction these are a unit matrix.
  matrix m;
  for (const std::vector<rational> &v : basis) {
    std::vector<rational> row;
    for (const std::size_t c : pure)
      row.push_back(v[c]);
    row.insert(row.end(), v.begin(), v.end());
    m.push_back(std::move(row));
  }
  const std::vector<std::size_t> pivots = reduce(m);
  for (std::size_t i = 0; i < pure.size(); ++i)
    if (i >= pivots.size() || pivots[i] != i)
      return {};
  std::vector<std::vector<int>> out;
  for (std::size_t c = 0; c < basis.front().size(); ++c) {
    out.emplace_back();
    int sum = 0;
    for (std::size_t group = 0; group < pure.size(); ++group) {
      const rational &w = m[group][pure.size() + c];
      if (w < 0 || w.get_den() != 1 || w > most_weight)
        return {};
      out.back().push_back(static_cast<int>(w.get_num().get_si()));
      sum += out.back().back();
    }
    if (sum < 1 || sum > most_weight)
      return {};
  }
  return out;
}

int sum_of(const std::vector<std::vector<int>> &weights) {
  int out = 0;
  for (const std::vector<int> &w : weights)
    out = std::accumulate(w.begin(), w.end(), out);
  return out;
}

// The groups with the least sum of weights; of equal ones the first. Empty if there are none.
std::vector<std::vector<int>> by_choice(const matrix &basis, std::size_t classes) {
  std::vector<std::size_t> pure(basis.size());
  std::iota(pure.begin(), pure.end(), std::size_t{0});
  std::vector<std::vector<int>> best;
  for (std::size_t tried = 0; tried < most_choices; ++tried) {
    if (auto w = weights_by(basis, pure); !w.empty() && (best.empty() || sum_of(w) < sum_of(best)))
      best = std::move(w);
    std::size_t at = pure.size(); // the next choice in order
    while (at > 0 && pure[at - 1] == classes - pure.size() + at - 1)
      --at;
    if (at == 0)
      break;
    ++pure[at - 1];
    std::iota(pure.begin() + static_cast<std::ptrdiff_t>(at), pure.end(), pure[at - 1] + 1);
  }
  return best;
}

// One group: the first small positive weights that solve the equations.
std::vector<std::vector<int>> by_search(const matrix &basis, std::size_t classes) {
  std::vector<int> factors(basis.size(), 1);
  for (std::size_t tried = 0; tried < most_choices; ++tried) {
    std::vector<std::vector<int>> out;
    for (std::size_t c = 0; c < classes; ++c) {
      rational w = 0;
      for (std::size_t k = 0; k < basis.size(); ++k)
        w += factors[k] * basis[k][c];
      if (w < 1 || w > most_weight || w.get_den() != 1)
        break;
      out.push_back({static_cast<int>(w.get_num().get_si())});
    }
    if (out.size() == classes)
      return out;
    std::size_t k = 0;
    while (k < factors.size() && factors[k] == most_weight)
      factors[k++] = 1;
    if (k == factors.size())
      break;
    ++factors[k];
  }
  return {};
}

} // namespace

std::vector<int> grading::of_group(int group) const {
  std::vector<int> out;
  for (const std::vector<int> &w : weights)
    out.push_back(w[static_cast<std::size_t>(group)]);
  return out;
}

std::vector<int> grading::total() const {
  std::vector<int> out;
  for (const std::vector<int> &w : weights)
    out.push_back(std::accumulate(w.begin(), w.end(), 0));
  return out;
}

std::optional<grading> find_grading(const std::vector<const poly::poly *> &signs, const poly::local_origin &local) {
  std::vector<int> used;
  for (const poly::poly *p : signs) {
    const std::vector<int> here = p->variables();
    used.insert(used.end(), here.begin(), here.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const matrix rows = equations(signs, local, used);
  if (std::all_of(rows.begin(), rows.end(), [](const std::vector<rational> &row) {
        return std::accumulate(row.begin(), row.end(), rational(0)) == 0;
      }))
    return grading(); // the weight 1 for all
  const matrix basis = null_space(rows, used.size());
  if (basis.empty())
    return std::nullopt;
  // Numbers with equal weights in every solution are one class. That of the positions comes first.
  std::vector<std::size_t> first; // of each class, in `used`
  std::vector<std::size_t> class_of(used.size());
  const auto add = [&](std::size_t i) {
    const auto known = std::find_if(first.begin(), first.end(), [&](std::size_t j) {
      return std::all_of(basis.begin(), basis.end(), [&](const auto &v) { return v[i] == v[j]; });
    });
    class_of[i] = static_cast<std::size_t>(known - first.begin());
    if (known == first.end())
      first.push_back(i);
  };
  for (const bool positions : {true, false})
    for (std::size_t i = 0; i < used.size(); ++i)
      if (local.stored(used[i]).position == positions)
        add(i);
  matrix of_classes;
  for (const std::vector<rational> &v : basis) {
    of_classes.emplace_back();
    for (const std::size_t i : first)
      of_classes.back().push_back(v[i]);
  }
  std::vector<std::vector<int>> found = by_choice(of_classes, first.size());
  if (found.empty())
    found = by_search(of_classes, first.size());
  if (found.empty())
    return std::nullopt;
  grading out;
  out.weights.assign(static_cast<std::size_t>(local.base().size()), std::vector<int>(found.front().size()));
  for (std::size_t i = 0; i < used.size(); ++i)
    out.weights[static_cast<std::size_t>(used[i])] = found[class_of[i]];
  return out;
}

} // namespace meetc::bound
