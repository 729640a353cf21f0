#include "gen/poly/kernels.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace meetc::poly {
namespace {

constexpr std::size_t most_quotients = 400;
constexpr int most_layers = 64;

// Replaces each c m kernel in p by c m v. Returns the number of replacements.
int replace(packed &p, const packed &kernel, int v) {
  std::vector<char> used(p.size());
  std::vector<packed_term> made;
  const auto find = [&](product_of f) -> std::ptrdiff_t {
    const auto it =
        std::lower_bound(p.begin(), p.end(), f, [](const packed_term &t, product_of x) { return t.of < x; });
    return it == p.end() || it->of != f ? -1 : it - p.begin();
  };
  int count = 0;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (used[i] || !divides(kernel[0].of, p[i].of) || p[i].coefficient % kernel[0].coefficient != 0)
      continue;
    const product_of m = divided(p[i].of, kernel[0].of);
    const std::int64_t c = p[i].coefficient / kernel[0].coefficient;
    places.assign(1, i);
    for (std::size_t k = 1; k < kernel.size(); ++k) {
      const bool fits = degree(m) + degree(kernel[k].of) <= most_factors;
      const std::ptrdiff_t at = fits ? find(times(m, kernel[k].of)) : -1;
      if (at < 0 || used[static_cast<std::size_t>(at)] ||
          p[static_cast<std::size_t>(at)].coefficient != c * kernel[k].coefficient)
        break;
      places.push_back(static_cast<std::size_t>(at));
    }
    if (places.size() != kernel.size())
      continue;
    for (const std::size_t at : places)
      used[at] = 1;
    made.push_back({times(m, factor(v)), c});
    ++count;
  }
  if (count == 0)
    return 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!used[i])
      made.push_back(p[i]);
  p = joined(std::move(made));
  return count;
}

// A system with the estimated cost of each of its sums: the outputs, then the values.
struct priced {
  packed_system system;
  std::vector<long> costs;
  long cost = 0;
};

// All replacements in one system, powers of a product included.
int replace_everywhere(priced &s, const packed &kernel, int v, const scheme_table &in) {
  int count = 0;
  const auto within = [&](packed &p, long &cost) {
    if (p.size() < kernel.size())
      return;
    const int before = count;
    for (int n = replace(p, kernel, v); n > 0; n = kernel.size() == 1 ? replace(p, kernel, v) : 0)
      count += n;
    if (count > before)
      cost = in.estimate(p);
  };
  auto cost = s.costs.begin();
  for (packed &p : s.system.outputs)
    within(p, *cost++);
  for (auto &[variable, p] : s.system.values)
    within(p, *cost++);
  return count;
}

// The kernel that all terms have after division by common factors: coprime, positive at first.
packed normalised(packed k) {
  product_of g = k[0].of;
  for (const packed_term &t : k)
    g = common(g, t.of);
  if (g != 0)
    k = quotient(k, g);
  return divided(k, content(k));
}

using kernel_counts = std::unordered_map<packed, long, packed_hash>;

// The kernels of two quotients: common terms, by ratio.
void intersect(const packed &a, const packed &b, kernel_counts &out) {
  struct group {
    std::int64_t x, y;
    packed terms;
  };
  std::vector<group> groups;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (i->of < j->of) {
      ++i;
    } else if (j->of < i->of) {
      ++j;
    } else {
      std::int64_t g = std::gcd(i->coefficient, j->coefficient);
      if (i->coefficient < 0)
        g = -g;
      const std::int64_t x = i->coefficient / g, y = j->coefficient / g;
      const auto same =
          std::find_if(groups.begin(), groups.end(), [&](const group &q) { return q.x == x && q.y == y; });
      if (same == groups.end())
        groups.push_back({x, y, {*i}});
      else
        same->terms.push_back(*i);
      ++i, ++j;
    }
  }
  for (group &g : groups)
    if (g.terms.size() > 1)
      ++out[normalised(std::move(g.terms))];
}

// Quotients by the product of none, by one variable, and in long products by two.
void quotients(const packed &p, std::vector<packed> &out) {
  if (p.size() < 2)
    return;
  out.push_back(p);
  const std::vector<int> all = variables(p);
  const bool by_two = degree(p) > 3 && p.size() <= 24;
  for (std::size_t i = 0; i < all.size(); ++i) {
    packed q = quotient(p, factor(all[i]));
    if (q.size() < 2)
      continue;
    for (std::size_t j = i; by_two && j < all.size(); ++j)
      if (packed r = quotient(q, factor(all[j])); r.size() > 1)
        out.push_back(std::move(r));
    out.push_back(std::move(q));
  }
}

struct candidate {
  packed kernel;
  long gain; // estimated
};

std::vector<candidate> candidates(const packed_system &s, int most) {
  std::vector<packed> all;
  std::map<product_of, long> products;
  const auto add = [&](const packed &p) {
    quotients(p, all);
    for (const packed_term &t : p) {
      std::vector<product_of> seen;
      for (product_of f = t.of; f != 0; f = rest_of(f))
        for (product_of g = rest_of(f); g != 0; g = rest_of(g))
          if (const product_of two = times(factor(first_factor(f)), factor(first_factor(g)));
              std::find(seen.begin(), seen.end(), two) == seen.end())
            seen.push_back(two);
      for (const product_of two : seen)
        ++products[two];
    }
  };
  for (const packed &p : s.outputs)
    add(p);
  for (const auto &[v, p] : s.values)
    add(p);
  if (all.size() > most_quotients)
    return {};
  kernel_counts counts;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j)
      intersect(all[i], all[j], counts);
  std::vector<candidate> out;
  for (const auto &[kernel, pairs] : counts) {
    long uses = 2; // of `uses` quotients each pair agrees
    while (uses * (uses - 1) / 2 < pairs)
      ++uses;
    out.push_back({kernel, (uses - 1) * (2 * static_cast<long>(kernel.size()) - 1)});
  }
  for (const auto &[two, uses] : products)
    if (uses > 1)
      out.push_back({{{two, 1}}, uses - 1});
  const auto before = [](const candidate &x, const candidate &y) {
    return x.gain != y.gain ? x.gain > y.gain : x.kernel < y.kernel;
  };
  const auto kept = std::min(out.size(), static_cast<std::size_t>(most));
  std::partial_sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(kept), out.end(), before);
  out.resize(kept);
  return out;
}

// The sum of the costs of the sums that the outputs need.
template <class Cost> long needed_cost(const packed_system &s, const Cost &cost_of) {
  long out = 0;
  std::vector<char> needed(s.values.size()), done(s.values.size());
  const auto read = [&](const packed &p, std::size_t place) {
    out += cost_of(p, place);
    for (const packed_term &t : p)
      for (product_of f = t.of; f != 0; f = rest_of(f))
        for (std::size_t i = 0; i < s.values.size(); ++i)
          if (s.values[i].first == first_factor(f))
            needed[i] = 1;
  };
  for (std::size_t i = 0; i < s.outputs.size(); ++i)
    read(s.outputs[i], i);
  for (bool again = true; again;) { // a value may be read by one that stands before it
    again = false;
    for (std::size_t i = 0; i < s.values.size(); ++i)
      if (needed[i] && !done[i]) {
        done[i] = again = true;
        read(s.values[i].second, s.outputs.size() + i);
      }
  }
  return out;
}

} // namespace

const packed *packed_system::definition(int variable) const {
  const auto it = std::find_if(values.begin(), values.end(), [&](const auto &v) { return v.first == variable; });
  return it == values.end() ? nullptr : &it->second;
}

long cost(const packed_system &s, scheme_table &in) {
  return needed_cost(s, [&](const packed &p, std::size_t) { return in.cost(p); });
}
long estimated_cost(const packed_system &s, const scheme_table &in) {
  return needed_cost(s, [&](const packed &p, std::size_t) { return in.estimate(p); });
}

packed_system extract_kernels(const packed_system &s, scheme_table &in, const extraction_effort &effort) {
  const auto total = [](const priced &p) {
    return needed_cost(p.system, [&](const packed &, std::size_t place) { return p.costs[place]; });
  };
  priced best{s, {}, 0};
  for (const packed &p : s.outputs)
    best.costs.push_back(in.estimate(p));
  for (const auto &[v, p] : s.values)
    best.costs.push_back(in.estimate(p));
  best.cost = total(best);
  std::vector<priced> beam{best};
  for (int layer = 0, idle = 0; layer < most_layers && idle < effort.patience && !beam.empty(); ++layer) {
    std::vector<priced> next;
    for (const priced &from : beam)
      for (const candidate &c : candidates(from.system, effort.tried)) {
        if (!in.has_room())
          return best.system;
        const int v = in.value(c.kernel);
        if (from.system.definition(v))
          continue;
        priced made = from;
        if (replace_everywhere(made, c.kernel, v, in) < 2)
          continue;
        made.system.values.emplace_back(v, c.kernel);
        made.costs.push_back(in.estimate(c.kernel));
        made.cost = total(made);
        next.push_back(std::move(made));
      }
    std::stable_sort(next.begin(), next.end(), [](const priced &x, const priced &y) { return x.cost < y.cost; });
    beam.clear();
    for (priced &p : next) {
      const bool known = std::any_of(beam.begin(), beam.end(), [&](const priced &q) {
        return q.cost == p.cost && q.system.outputs == p.system.outputs &&
               q.system.values.size() == p.system.values.size();
      });
      if (!known)
        beam.push_back(std::move(p));
      if (beam.size() == static_cast<std::size_t>(effort.width))
        break;
    }
    ++idle;
    if (!beam.empty() && beam.front().cost < best.cost) {
      best = beam.front();
      idle = 0;
    }
  }
  return best.system;
}

} // namespace meetc::poly
