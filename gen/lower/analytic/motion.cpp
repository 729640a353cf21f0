// Versors of motions: which coefficient of a blade is which number of a dual quaternion, and what kind a value has.
//
// Three vectors e1, e2, e3 that square to 1 and one e0 that squares to 0, orthogonal to each other, make the units i = -e2e3,
// j = -e3e1, k = -e1e2 of quaternions, and J = e1e2e3e0, which commutes with them and squares to 0. The vectors are those of
// the working basis, so that e0 may be the null vector at infinity of a conformal algebra. In the plane e3 is missing, and
// with it the units that hold it.
#include "gen/lower/analytic/analytic.hpp"
#include "gen/lower/kernel/compile.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::lower {
namespace {

using algebra::blade_term;
using units = std::array<std::optional<blade_term>, 8>; // 1, i, j, k, J, J i, J j, J k

[[noreturn]] void refuse(const analytic_kernel &k, const std::string &why) {
  throw spec_error(k.where,
                   fmt::format("'{}' is for motions of space, which are made of three vectors that square to 1 and "
                               "one that squares to 0: {}",
                               k.text, why));
}

// The vectors of the blades: those that square to 1, then the one that squares to 0; -1 where there is none.
std::array<int, 4> vectors_of(const model &m, const analytic_kernel &k, const std::vector<blade> &blades) {
  const metric &basis = m.working();
  blade all = 0;
  for (const blade b : blades)
    all |= b;
  std::array<int, 4> out{-1, -1, -1, -1};
  int ones = 0;
  for (int v = 0; v < basis.vectors(); ++v) {
    if (!(all >> v & 1))
      continue;
    const std::string &name = basis.names()[static_cast<std::size_t>(v)];
    for (int w = 0; w < v; ++w)
      if (all >> w & 1 && basis.product(v, w) != 0)
        refuse(k, fmt::format("the blade of '{}' has {} and {}, which are not orthogonal", k.kind->name,
                              basis.names()[static_cast<std::size_t>(w)], name));
    const rational &square = basis.product(v, v);
    if (square != 0 && square != 1)
      refuse(k, fmt::format("the blade of '{}' has {}, which squares to {}", k.kind->name, name, square.get_str()));
    int &place = square == 0 ? out[3] : out[static_cast<std::size_t>(std::min(ones, 2))];
    if (square == 0 ? place >= 0 : ones++ == 3)
      refuse(k, fmt::format("the blade of '{}' has {} as well", k.kind->name, name));
    place = v;
  }
  return out;
}

// The units as multiples of basis blades of the working basis.
units units_of(const metric &basis, const std::array<int, 4> &vectors) {
  const metric formal({"e1", "e2", "e3", "e0"}, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 0}});
  constexpr blade pseudoscalar = 15, planes[] = {0, 6, 5, 3}; // 1, e2e3, e1e3, e1e2
  constexpr int signs[] = {1, -1, 1, -1};                     // -e2e3, -e3e1, -e1e2
  units out;
  for (std::size_t n = 0; n < 8; ++n) {
    blade_term t{planes[n % 4], signs[n % 4]};
    if (n >= 4) {
      const blade_term &by = formal.geometric(pseudoscalar, t.at).front();
      t = {by.at, by.weight * t.weight};
    }
    blade at = 0;
    for (std::size_t v = 0; v < 4 && t.weight != 0; ++v)
      if (t.at >> v & 1) {
        if (vectors[v] < 0) {
          t.weight = 0;
          break;
        }
        const blade next = blade{1} << vectors[v];
        t.weight *= basis.outer_sign(at, next);
        at |= next;
      }
    if (t.weight != 0)
      out[n] = blade_term{at, t.weight};
  }
  return out;
}

dual_numbers numbers_on(const model &m, const units &all, const std::vector<blade> &blades) {
  dual_numbers out;
  for (std::size_t n = 0; n < 8; ++n)
    if (all[n] && std::find(blades.begin(), blades.end(), all[n]->at) != blades.end())
      out[n] = {named(m.working(), {all[n]->at}).front(), all[n]->weight > 0 ? 1 : -1};
  return out;
}

// The numbers of functions of a dual quaternion with these numbers: a shared axis brings J, and J the axes of the others.
std::array<bool, 8> closed(const std::array<bool, 8> &of) {
  std::array<bool, 8> out = of;
  bool shared = of[4];
  for (std::size_t i = 1; i < 4; ++i)
    shared = shared || (of[i] && of[4 + i]);
  for (std::size_t i = 0; shared && i < 4; ++i)
    out[4 + i] = i == 0 || of[i] || of[4 + i];
  return out;
}

} // namespace

void compile_motion(const model &m, analytic_kernel &k) {
  const std::vector<blade> blades = support(m, *k.kind);
  const std::array<int, 4> vectors = vectors_of(m, k, blades);
  const units all = units_of(m.working(), vectors);
  std::array<bool, 8> has{};
  for (const blade b : blades) {
    const auto n = std::find_if(all.begin(), all.end(), [&](const auto &u) { return u && u->at == b; }) - all.begin();
    if (n == 8)
      refuse(k, fmt::format("the blade of '{}' has a coefficient on {}, and is no versor of a motion", k.kind->name,
                            m.working().name(b)));
    has[static_cast<std::size_t>(n)] = true;
  }
  const bool bivector = !has[0] && !has[4];
  if (k.function == "exp" && !bivector)
    refuse(k, fmt::format("it takes bivectors, and the blade of '{}' has a coefficient on {}", k.kind->name,
                          m.working().name(has[0] ? 0 : all[4]->at)));
  if (k.function != "exp" && !has[0])
    refuse(k,
           fmt::format("it takes rotors, motors and translators, and the blade of '{}' has no scalar", k.kind->name));
  k.in = numbers_on(m, all, blades);
  if (k.function == "pose") {
    k.shift = pose_shift(m, *k.kind, all, k.where);
    return;
  }
  if (k.function == "norm")
    return;
  std::array<bool, 8> gives = closed(has);
  gives[0] = k.function != "log";
  gives[4] = gives[4] && k.function != "log";
  std::vector<blade> result;
  for (std::size_t n = 0; n < 8; ++n)
    if (gives[n] && all[n])
      result.push_back(all[n]->at);
  result = sorted_blades(m.working(), {result.begin(), result.end()});
  k.out = numbers_on(m, all, result);
  k.result_kind = result == blades ? k.kind : kind_of_value(m, result);
  if (!k.result_kind)
    k.result = named(m.working(), result);
}

} // namespace meetc::lower
