#include "gen/search/value_system.hpp"

#include "gen/poly/change.hpp"

#include <fmt/format.h>
#include <numeric>

namespace meetc::search {
namespace {

using poly::rational;

std::shared_ptr<poly::ring> ring_of(const poly::ring &leaves, int count, std::size_t values) {
  std::vector<std::string> names(leaves.names().begin(), leaves.names().begin() + count);
  for (std::size_t i = 0; i < values; ++i)
    names.push_back(fmt::format("#{}", i));
  return std::make_shared<poly::ring>(std::move(names));
}

std::vector<poly::poly> mapped(const std::vector<poly::poly> &of, const std::vector<poly::poly> &images,
                               const poly::ring &to) {
  std::vector<poly::poly> out;
  for (const poly::poly &p : of)
    out.push_back(p.substitute(images, to));
  return out;
}

} // namespace

value_system system_of(const poly::ring &leaves, const std::vector<poly::poly> &outputs,
                       const std::vector<poly::poly> &relations) {
  value_system out{ring_of(leaves, leaves.size(), 0), {}, {}, {}};
  std::vector<int> same(static_cast<std::size_t>(leaves.size()));
  std::iota(same.begin(), same.end(), 0);
  for (const poly::poly &p : outputs)
    out.outputs.push_back(p.renamed(same, *out.numbers));
  for (const poly::poly &p : relations)
    out.relations.push_back(p.renamed(same, *out.numbers));
  return out;
}

value_system with_values(const value_system &s, std::size_t more) {
  value_system out{ring_of(*s.numbers, s.leaves(), s.values.size() + more), {}, {}, {}};
  std::vector<int> same(static_cast<std::size_t>(s.numbers->size()));
  std::iota(same.begin(), same.end(), 0);
  for (const auto &[from, to] : {std::pair(&s.values, &out.values), std::pair(&s.outputs, &out.outputs),
                                 std::pair(&s.relations, &out.relations)})
    for (const poly::poly &p : *from)
      to->push_back(p.renamed(same, *out.numbers));
  for (std::size_t i = 0; i < more; ++i)
    out.values.emplace_back(*out.numbers);
  return out;
}

value_system simplified(const value_system &s) {
  const int leaves = s.leaves();
  // The values that stay, as they are in s.
  std::vector<poly::poly> images;
  for (int v = 0; v < s.numbers->size(); ++v)
    images.push_back(poly::poly::variable(*s.numbers, v));
  std::vector<poly::poly> kept;
  std::vector<int> to(static_cast<std::size_t>(s.numbers->size()));
  std::iota(to.begin(), to.end(), 0);
  for (std::size_t i = 0; i < s.values.size(); ++i) {
    const auto at = static_cast<std::size_t>(leaves) + i;
    const poly::poly value = s.values[i].substitute(images, *s.numbers);
    if (value.length() < 2) {
      images[at] = value;
      to[at] = 0; // no longer read
      continue;
    }
    auto [content, primitive] = value.primitive();
    images[at] = images[at].scaled(content);
    to[at] = leaves + static_cast<int>(kept.size());
    kept.push_back(std::move(primitive));
  }
  value_system out{ring_of(*s.numbers, leaves, kept.size()), {}, {}, {}};
  for (const poly::poly &p : kept)
    out.values.push_back(p.renamed(to, *out.numbers));
  for (const poly::poly &p : s.outputs)
    out.outputs.push_back(p.substitute(images, *s.numbers).renamed(to, *out.numbers));
  for (const poly::poly &p : s.relations)
    out.relations.push_back(p.substitute(images, *s.numbers).renamed(to, *out.numbers));
  return out;
}

std::vector<poly::poly> in_leaves(const value_system &s, const std::vector<poly::poly> &of, const poly::ring &leaves) {
  std::vector<poly::poly> images;
  for (int v = 0; v < s.numbers->size(); ++v)
    images.push_back(v < s.leaves() ? poly::poly::variable(leaves, v) : poly::poly(leaves));
  for (std::size_t i = 0; i < s.values.size(); ++i)
    images[static_cast<std::size_t>(s.leaves()) + i] = s.values[i].substitute(images, leaves);
  return mapped(of, images, leaves);
}

std::optional<value_system> with_pairs(const value_system &s, const std::vector<int> &group) {
  std::vector<poly::packed> all;
  for (const poly::poly &p : s.outputs) {
    auto packed = poly::pack(p);
    if (!packed)
      return std::nullopt;
    all.push_back(std::move(packed->of));
  }
  const auto pairs = poly::shortening_pairs(std::move(all), group, s.numbers->size());
  if (pairs.empty())
    return std::nullopt;
  value_system out{ring_of(*s.numbers, s.leaves(), s.values.size() + 2 * pairs.size()), {}, {}, {}};
  const auto variable = [&](int v) { return poly::poly::variable(*out.numbers, v); };
  std::vector<poly::poly> images;
  for (int v = 0; v < s.numbers->size(); ++v)
    images.push_back(variable(v < s.leaves() ? v : v + 2 * static_cast<int>(pairs.size())));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const int plus = s.leaves() + 2 * static_cast<int>(i);
    out.values.push_back(variable(pairs[i].v) + variable(pairs[i].w));
    out.values.push_back(variable(pairs[i].v) - variable(pairs[i].w));
    images[static_cast<std::size_t>(pairs[i].v)] = (variable(plus) + variable(plus + 1)).scaled(rational(1, 2));
    images[static_cast<std::size_t>(pairs[i].w)] = (variable(plus) - variable(plus + 1)).scaled(rational(1, 2));
  }
  for (poly::poly &p : mapped(s.values, images, *out.numbers))
    out.values.push_back(std::move(p));
  out.outputs = mapped(s.outputs, images, *out.numbers);
  out.relations = mapped(s.relations, images, *out.numbers);
  return out;
}

} // namespace meetc::search
