// Sparse multivectors over any exact coefficient type C with +, -, *, scaled(rational) and is_zero().
#pragma once
#include "gen/algebra/metric.hpp"

#include <map>

namespace meetc::algebra {

template <class C> class multivector {
public:
  multivector() = default;
  multivector(blade at, C c) { add(at, std::move(c)); }

  const std::map<blade, C> &terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  bool is_scalar() const { return terms_.empty() || (terms_.size() == 1 && terms_.begin()->first == 0); }
  const C *find(blade at) const {
    const auto it = terms_.find(at);
    return it == terms_.end() ? nullptr : &it->second;
  }
  // The only grade with terms; -1 where there are several, or none.
  int homogeneous_grade() const {
    int g = -1;
    for (const auto &[at, c] : terms_) {
      if (g >= 0 && grade(at) != g)
        return -1;
      g = grade(at);
    }
    return g;
  }

  void add(blade at, C c) {
    if (c.is_zero())
      return;
    const auto [it, fresh] = terms_.try_emplace(at, c);
    if (fresh)
      return;
    it->second = it->second + c;
    if (it->second.is_zero())
      terms_.erase(it);
  }

  multivector scaled(const rational &q) const {
    multivector out;
    for (const auto &[at, c] : terms_)
      out.add(at, c.scaled(q));
    return out;
  }
  friend multivector operator+(const multivector &a, const multivector &b) {
    multivector out = a;
    for (const auto &[at, c] : b.terms_)
      out.add(at, c);
    return out;
  }
  friend multivector operator-(const multivector &a, const multivector &b) { return a + b.scaled(-1); }

private:
  std::map<blade, C> terms_;
};

// Geometric product. With keep(a, b, result), only the wanted blades of each product of basis blades are computed.
template <class C, class Keep>
multivector<C> product(const metric &m, const multivector<C> &a, const multivector<C> &b, Keep &&keep) {
  multivector<C> out;
  for (const auto &[ba, ca] : a.terms())
    for (const auto &[bb, cb] : b.terms()) {
      const blade_sum &sum = m.geometric(ba, bb);
      bool wanted = false;
      for (const blade_term &t : sum)
        wanted = wanted || keep(ba, bb, t.at);
      if (!wanted)
        continue;
      const C c = ca * cb;
      for (const blade_term &t : sum)
        if (keep(ba, bb, t.at))
          out.add(t.at, c.scaled(t.weight));
    }
  return out;
}

template <class C> multivector<C> geometric(const metric &m, const multivector<C> &a, const multivector<C> &b) {
  return product(m, a, b, [](blade, blade, blade) { return true; });
}

// Left contraction: the part of grade (grade b - grade a). For the meets that are defined it agrees with the fat dot
// product and with Hestenes' inner product.
template <class C> multivector<C> inner(const metric &m, const multivector<C> &a, const multivector<C> &b) {
  return product(m, a, b, [](blade x, blade y, blade z) { return grade(z) == grade(y) - grade(x); });
}

template <class C> multivector<C> outer(const metric &m, const multivector<C> &a, const multivector<C> &b) {
  multivector<C> out;
  for (const auto &[ba, ca] : a.terms())
    for (const auto &[bb, cb] : b.terms())
      if (const int s = m.outer_sign(ba, bb))
        out.add(ba | bb, (ca * cb).scaled(s));
  return out;
}

// A linear change of basis, extended to blades as an outermorphism: image[i] is the image of basis vector i.
template <class C>
multivector<C> outermorphism(const metric &from, const multivector<C> &x, const metric &to,
                             const std::vector<std::vector<rational>> &image) {
  multivector<C> out;
  for (const auto &[at, c] : x.terms()) {
    std::map<blade, rational> sum{{0, 1}};
    for (const int v : from.factors(at)) {
      const std::vector<rational> &row = image[static_cast<std::size_t>(v)];
      std::map<blade, rational> next;
      for (const auto &[b, w] : sum)
        for (std::size_t j = 0; j < row.size(); ++j)
          if (const int s = to.outer_sign(b, blade{1} << j); s && row[j] != 0)
            next[b | blade{1} << j] += s * w * row[j];
      sum = std::move(next);
    }
    for (const auto &[b, w] : sum)
      if (w != 0)
        out.add(b, c.scaled(w));
  }
  return out;
}

} // namespace meetc::algebra
