#include "gen/lower/ball_form.hpp"

#include "gen/bound/matrix.hpp"
#include "gen/lower/kernel/compile.hpp"

#include <algorithm>

namespace meetc::lower {
namespace {

constexpr int radius = ball_form::inputs - 1;

// The place of each stored number of a ball among x, y, z, r. Nothing where the kind is not a ball in space.
std::optional<std::vector<int>> places_of(const model &m, const lang::kind &k) {
  const enclosure e = enclosing(m, k);
  if (e.hull.size() != 1 || e.hull[0].size() != radius || e.pad < 0)
    return std::nullopt;
  std::vector<int> out(m.layout(k).reals.size(), -1);
  for (int axis = 0; axis < radius; ++axis)
    out[static_cast<std::size_t>(e.hull[0][static_cast<std::size_t>(axis)])] = axis;
  out[static_cast<std::size_t>(e.pad)] = radius;
  if (std::find(out.begin(), out.end(), -1) != out.end())
    return std::nullopt; // it stores more than its centre and its radius
  return out;
}

// The polynomial that is <= 0 where a predicate consisting of one test hits.
std::optional<poly::poly> tested(const predicate &p) {
  constexpr sign_mask not_positive = 3, not_negative = 6; // bit 0 negative, bit 1 zero, bit 2 positive
  const truth_node &hit = p.signs.at(p.truths.hit);
  if (!p.truths.reject.empty() || hit.kind != truth_node::type::test || hit.sign.atoms.size() != 1 ||
      hit.sign.atoms[0].second != 1 || hit.sign.unit == 0)
    return std::nullopt;
  const poly::poly signed_atom =
      p.signs.atoms()[static_cast<std::size_t>(hit.sign.atoms[0].first)].scaled(hit.sign.unit);
  if (hit.flag == not_positive)
    return signed_atom;
  if (hit.flag == not_negative)
    return signed_atom.scaled(-1);
  return std::nullopt;
}

bool is_stored_number(const poly::poly &p) {
  return p.length() == 1 && abs(p.terms()[0].coefficient) == 1 && p.terms()[0].factors.size() == 1 &&
         p.terms()[0].factors[0].exponent == 1;
}

// Whether the filter's margins are proved for this form (gen/bound/matrix.hpp).
bool is_covered(const poly::separation &s) {
  const rational largest = bound::matrix_input.value(), most = bound::matrix_additive.value();
  const auto fits = [&](const poly::poly &additive) {
    rational sum = 0;
    for (const poly::term &t : additive.terms()) {
      rational size = abs(t.coefficient);
      bool even = true;
      for (const poly::power &f : t.factors) {
        even = even && f.exponent % 2 == 0;
        for (int i = 0; i < f.exponent; ++i)
          size *= largest;
      }
      if (t.coefficient > 0 || !even) // an even term has the sign of its coefficient
        sum += size;
    }
    return sum <= most;
  };
  return s.additive() == 2 && fits(s.of_x) && fits(s.of_x.scaled(-1)) && fits(s.of_y) && fits(s.of_y.scaled(-1)) &&
         std::all_of(s.products.begin(), s.products.end(),
                     [](const poly::product &k) { return is_stored_number(k.f) && is_stored_number(k.g); });
}

// f is the primitive factor of each product and g has its coefficient. If all have one size, this makes them 1 or -1.
std::optional<rational> scale_of(const poly::separation &s) {
  std::optional<rational> size;
  for (const poly::product &k : s.products) {
    if (k.g.length() != 1)
      return std::nullopt;
    const rational c = abs(k.g.terms()[0].coefficient);
    if (size && *size != c)
      return std::nullopt;
    size = c;
  }
  return size ? std::optional<rational>(1 / *size) : std::nullopt;
}

std::optional<ball_form> form_of(const model &m, const lang::predicate &asked) {
  if (asked.of.size() != 2 || asked.of[0].type != asked.of[1].type || asked.mode == "surface")
    return std::nullopt;
  const lang::kind &kind = m.kind(asked.of[0].type, asked.of[0].where);
  const auto places = places_of(m, kind);
  if (!places)
    return std::nullopt;
  lang::expr name;
  name.kind = lang::op::name;
  name.text = asked.name;
  name.where = asked.hit->where;
  const predicate p = compile_predicate(m, resolve(m, std::make_shared<lang::expr>(name)));
  const auto sign = tested(p);
  if (!sign)
    return std::nullopt;
  std::vector<std::string> names;
  std::vector<poly::stored_number> numbers;
  for (const int operand : {0, 1})
    for (const std::string &n : ball_form::names) {
      names.push_back((operand ? "Y." : "X.") + n);
      numbers.push_back({operand, -1, 0, false}); // the parts of a product are not differences
    }
  auto ring = std::make_shared<poly::ring>(names);
  std::vector<poly::poly> images;
  for (const int operand : {0, 1})
    for (const int at : *places)
      images.push_back(poly::poly::variable(*ring, operand * ball_form::inputs + at));
  poly::poly whole = sign->substitute(images, *ring);
  const auto scale = scale_of(poly::separate(whole, ball_form::inputs));
  if (!scale)
    return std::nullopt;
  whole = whole.scaled(*scale);
  const poly::separation parts = poly::separate(whole, ball_form::inputs);
  if (!is_covered(parts))
    return std::nullopt;
  const poly::local_origin local(*ring, numbers);
  builder code(local, prefer::operations);
  std::vector<node_id> a, b;
  for (const poly::product &k : parts.products) {
    a.push_back(code.build(k.f));
    b.push_back(code.build(k.g));
  }
  a.push_back(code.build(parts.of_x));
  b.push_back(code.build(parts.of_y));
  return ball_form{&asked, ring, whole, parts, code.finish(a), code.finish(b)};
}

} // namespace

std::optional<ball_form> find_ball_form(const model &m) {
  for (const lang::predicate &p : m.spec().predicates)
    if (auto form = form_of(m, p))
      return form;
  return std::nullopt;
}

} // namespace meetc::lower
