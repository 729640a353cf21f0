#include "tests/decisions/flat/classes.hpp"
#include "tests/decisions/flat/necessary.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace meetc::decisions_test {
namespace {

// Points on a line: any weak order of n labels is the order of n numbers below n.
witnesses weak_orders(int n) {
  witnesses out;
  points x(static_cast<std::size_t>(n), place{});
  const auto choose = [&](auto &&self, std::size_t i) -> void {
    if (i == x.size()) {
      const key k = chirotope_of(x, 1);
      if (spans(k, n, 1))
        out.emplace(k, x);
      return;
    }
    for (x[i][0] = 0; x[i][0] < n; ++x[i][0])
      self(self, i + 1);
  };
  choose(choose, 0);
  return out;
}

// n points of the grid of `side` by `side`, repetitions allowed, in every order.
void add_grid(witnesses &all, int n, int side) {
  points x(static_cast<std::size_t>(n), place{});
  const auto choose = [&](auto &&self, std::size_t i, int from) -> void {
    if (i == x.size()) {
      if (const key k = chirotope_of(x, 2); spans(k, n, 2) && !all.contains(k))
        add_relabelled(all, x, 2);
      return;
    }
    for (int p = from; p < side * side; ++p) {
      x[i] = {p % side, p / side, 0};
      self(self, i + 1, p);
    }
  };
  choose(choose, 0, 0);
}

// Six points in the plane. The last list represents the only class, up to labels, that does not fit on a grid of
// 6 by 6.
witnesses six_in_the_plane() {
  witnesses out;
  for (const int side : {3, 4, 5, 6})
    add_grid(out, 6, side);
  add_relabelled(out, {{6, 0, 0}, {6, 6, 0}, {0, 1, 0}, {3, 2, 0}, {2, 1, 0}, {5, 3, 0}}, 2);
  const std::vector<key> possible = possible_keys(6, 2);
  if (out.size() != possible.size() || !std::ranges::all_of(possible, [&](key k) { return out.contains(k); }))
    throw std::logic_error("some possible sign vector of six points in the plane has no points");
  return out;
}

witnesses make(int n, int d) {
  if (d == 0) {
    const points x(static_cast<std::size_t>(n), place{});
    return {{chirotope_of(x, 0), x}};
  }
  if (n - d - 1 > 2)
    return d == 1 ? weak_orders(n) : six_in_the_plane();
  return witnesses_by_duality(n, d);
}

} // namespace

const witnesses &classes_of(int n, int d) {
  static std::map<std::pair<int, int>, witnesses> made;
  const auto at = made.find({n, d});
  return at != made.end() ? at->second : made.emplace(std::pair(n, d), make(n, d)).first->second;
}

void add_relabelled(witnesses &all, const points &x, int d) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), 0);
  do {
    points y;
    for (const std::size_t i : order)
      y.push_back(x[i]);
    all.emplace(chirotope_of(y, d), y);
  } while (std::ranges::next_permutation(order).found);
}

} // namespace meetc::decisions_test
