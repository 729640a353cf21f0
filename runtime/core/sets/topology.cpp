#include "meet/core/sets/topology.hpp"

#include "meet/core/views/numbered.hpp"

#include <algorithm>
#include <numeric>

namespace meetc {
namespace {

// Numbers that are joined into parts; a part is named by its least number.
class joined_numbers {
public:
  explicit joined_numbers(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t part(std::uint32_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = part(i), j = part(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

private:
  std::vector<std::uint32_t> parent_;
};

// An edge of an element, of which the other end is known.
struct edge_end {
  std::uint32_t to, slot;
  int way;
};

// The least element with an edge of which the ways do not cancel out. Three corners for each slot.
std::optional<std::uint32_t> least_open(const element_set &set, const std::vector<std::uint32_t> &corners,
                                        std::size_t points, const execution &on) {
  const auto edge = [&](std::size_t i) { return std::pair(corners[i], corners[i % 3 == 2 ? i - 2 : i + 1]); };
  std::vector<std::size_t> begin(points + 1, 0); // of the edges at each point that is the lesser end
  for_strips(on, corners.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (const auto [from, to] = edge(i); from != to)
        ++begin[std::min(from, to) + std::size_t{1}];
  });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<edge_end> ends(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_strips(on, corners.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (const auto [from, to] = edge(i); from != to)
        ends[next[std::min(from, to)]++] = {std::max(from, to), static_cast<std::uint32_t>(i / 3), from < to ? 1 : -1};
  });

  std::optional<std::uint32_t> least;
  for (std::size_t p = 0; p < points; ++p) {
    if ((p & 0xfff) == 0)
      on.go_on();
    const auto first = ends.begin() + static_cast<std::ptrdiff_t>(begin[p]),
               last = ends.begin() + static_cast<std::ptrdiff_t>(begin[p + 1]);
    std::sort(first, last, [](const edge_end &x, const edge_end &y) { return x.to < y.to; });
    for (auto at = first; at != last;) {
      const auto stop = std::find_if(at, last, [&](const edge_end &e) { return e.to != at->to; });
      if (std::accumulate(at, stop, 0, [](int sum, const edge_end &e) { return sum + e.way; }) != 0)
        for (auto e = at; e != stop; ++e)
          least = std::min(least.value_or(set.order[e->slot]), set.order[e->slot]);
      at = stop;
    }
  }
  return least;
}

} // namespace

void hull_point(const kind_info &kind, const float *row, int point, float out[3]) {
  for (int k = 0; k < 3; ++k) {
    const int field = kind.hull_fields[3 * point + k];
    out[k] = field < 0 ? 0.0F : row[field];
  }
}

set_topology topology_of(const element_set &set, const execution &on) {
  const kind_info &kind = *set.kind;
  const auto hull = static_cast<std::size_t>(kind.hull);
  set_topology out;
  if (hull == 0)
    return out;
  numbered<std::uint32_t, 3> points(set.elements, on);
  std::vector<std::uint32_t> corners(set.elements * hull);
  std::vector<set_topology::corner> first; // the corner that gave each point its number
  for_strips(on, corners.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t slot = i / hull;
      const auto point = static_cast<int>(i % hull);
      float at[3];
      hull_point(kind, set.rows + slot * static_cast<std::size_t>(kind.fields), point, at);
      corners[i] = points.number(key_of_point(at));
      if (corners[i] == first.size())
        first.push_back({static_cast<std::uint32_t>(slot), point});
    }
  });
  joined_numbers parts(first.size());
  for_strips(on, corners.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      parts.join(corners[i], corners[i - i % hull]);
  });

  const auto place = [&](std::uint32_t number) {
    std::array<float, 3> at;
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = std::bit_cast<float>(points.keys()[number][k]);
    return at;
  };
  std::vector<std::uint32_t> least(first.size()); // of each part, at its name
  for_strips(on, first.size(), [&](std::size_t begin, std::size_t end) {
    for (auto n = static_cast<std::uint32_t>(begin); n < end; ++n)
      if (std::uint32_t &l = least[parts.part(n)]; parts.part(n) == n || place(n) < place(l))
        l = n;
  });
  for (std::uint32_t n = 0; n < first.size(); ++n)
    if (parts.part(n) == n)
      out.parts.push_back(first[least[n]]);
  if (hull == 3 && kind.pad < 0)
    out.open = least_open(set, corners, first.size(), on);
  return out;
}

} // namespace meetc
