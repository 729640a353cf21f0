#include "meet/core/answers/answers.hpp"

#include <algorithm>

namespace meetc {

per_element<std::uint64_t> counts_of(std::span<const index_pair> pairs, std::size_t size_a, std::size_t size_b) {
  per_element<std::uint64_t> out{std::vector<std::uint64_t>(size_a), std::vector<std::uint64_t>(size_b)};
  for (const index_pair p : pairs) {
    ++out.a[p.a];
    ++out.b[p.b];
  }
  return out;
}

per_element<std::uint8_t> flags_of(std::span<const index_pair> pairs, std::size_t size_a, std::size_t size_b) {
  per_element<std::uint8_t> out{std::vector<std::uint8_t>(size_a), std::vector<std::uint8_t>(size_b)};
  for (const index_pair p : pairs)
    out.a[p.a] = out.b[p.b] = 1;
  return out;
}

void answer_from_list(answer_kind want, std::size_t size_a, std::size_t size_b, result &r) {
  r.count = r.pairs.size();
  if (want == answer_kind::flags)
    r.flags = flags_of(r.pairs, size_a, size_b);
  if (want == answer_kind::counts)
    r.counts = counts_of(r.pairs, size_a, size_b);
  if (want != answer_kind::pairs)
    std::vector<index_pair>().swap(r.pairs);
}

void name_items(std::span<const std::uint32_t> owners, std::vector<std::uint32_t> &elements) {
  for (std::uint32_t &e : elements)
    if (!owners.empty() && e != no_element)
      e = owners[e];
}

std::size_t items(std::span<const std::uint32_t> owners, std::size_t elements) {
  return owners.empty() ? elements : std::size_t{*std::max_element(owners.begin(), owners.end())} + 1;
}

} // namespace meetc
