#include "gen/lower/kernel/contacts.hpp"

#include <fmt/format.h>

namespace meetc::lower {

const lang::function *function_of(const model &m, const request &r) {
  return r.body->kind == lang::op::call ? m.spec().find_function(r.body->text) : nullptr;
}

int points_of(const model &m, const lang::kind &k) {
  const kind_layout l = m.layout(k);
  return l.reals.size() == std::size_t{3} * static_cast<std::size_t>(l.points) ? l.points : 0;
}

namespace {

// Whether a row is a point and then the radius around it.
bool is_ball(const model &m, const lang::kind &k) {
  if (!k.pad || m.layout(k).reals.size() != 4)
    return false;
  const enclosure e = enclosing(m, k);
  return e.hull == std::vector<std::vector<int>>{{0, 1, 2}} && e.pad == 3;
}

const lang::kind &operand(const model &m, const lang::field &f) {
  return m.kind(f.type, f.where);
}

bool fit(const model &m, const lang::predicate &p) {
  const lang::kind &a = operand(m, p.of[0]), &b = operand(m, p.of[1]);
  const int first = points_of(m, a), second = points_of(m, b);
  if (p.contacts == lang::one_witness)
    return is_ball(m, a) && (second == 3 || is_ball(m, b));
  return ((first == 2 || first == 3) && second == 3) || (is_ball(m, a) && second == 2);
}

} // namespace

void check_contacts(const model &m, const lang::predicate &p) {
  if (p.contacts.empty())
    return;
  if (!fit(m, p))
    throw spec_error(
        p.contacts_where,
        fmt::format(
            "{}, and {} takes {} and {}",
            p.contacts == lang::one_witness
                ? "a witness is placed for a ball (a point, then its radius) and a ball or three points"
                : "contacts are found of two or three points and three, and of a ball (a point, then its radius) "
                  "and two points",
            p.name, p.of[0].type, p.of[1].type));
  if (is_ball(m, operand(m, p.of[0])) && p.mode.empty())
    throw spec_error(p.contacts_where,
                     fmt::format("{} must say whether a ball's inside belongs to it; write mode = 'solid' or mode = "
                                 "'surface'",
                                 p.name));
}

const lang::kind *sides_of(const model &m, const request &r, bool is_sign) {
  const lang::function *f = function_of(m, r);
  if (!f || r.kinds.size() != 2 || points_of(m, *r.kinds[1]) != 1)
    return nullptr;
  if (points_of(m, *r.kinds[0]) != 3 && !is_ball(m, *r.kinds[0]))
    return nullptr;
  for (const lang::predicate &p : m.spec().predicates)
    if (p.contacts == f->name && is_sign)
      return r.kinds[0];
    else if (p.contacts == f->name)
      throw spec_error(p.contacts_where,
                       fmt::format("'{}' tells the contacts of {} and must be a sign", f->name, p.name));
  return nullptr;
}

} // namespace meetc::lower
