#include "tests/decisions/round/emitted.hpp"

#include <cga/cga.hpp>
#include <cga/header_only.hpp>
#include <fmt/format.h>
#include <stdexcept>

namespace meetc::decisions_round {
namespace {

using symbol = exact<polynomial>;
using number = exact<rational>;

// The polynomials of the atoms for rows of the ring's variables.
template <class P> std::vector<symbol> variables(const poly::ring &numbers) {
  symbol::ring = &numbers;
  std::vector<symbol> out;
  for (int v = 0; v < P::inputs_a + P::inputs_b; ++v)
    out.emplace_back(polynomial::variable(numbers, v));
  return out;
}

template <class P> std::vector<polynomial> polynomials(const poly::ring &numbers) {
  const std::vector<symbol> row = variables<P>(numbers);
  std::vector<polynomial> out(static_cast<std::size_t>(P::atoms), polynomial(numbers));
  meetc::each_stage<P>([&]<class Stage>(Stage) {
    symbol v[Stage::atoms];
    meetc::stage_values<Stage>(row.data(), row.data() + P::inputs_a, v);
    for (int i = 0; i < Stage::atoms; ++i)
      out[static_cast<std::size_t>(Stage::first + i)] = v[i].value;
  });
  return out;
}

// An interpreter of bytecode on polynomials. The first registers hold the inputs, as in run_limbs().
template <class P> std::vector<polynomial> step_polynomials(const poly::ring &numbers) {
  const std::vector<symbol> row = variables<P>(numbers);
  std::vector<polynomial> out(static_cast<std::size_t>(P::atoms), polynomial(numbers));
  meetc::each_stage<P>([&]<class Stage>(Stage) {
    symbol place[Stage::bytecode::registers];
    for (std::size_t i = 0; i < row.size(); ++i)
      place[i] = row[i];
    for (int i = 0; i < Stage::bytecode::instruction_count; ++i) {
      const meetc::instruction t = Stage::bytecode::instruction_at(i);
      const symbol a = place[t.a];
      switch (t.code) {
        using enum meetc::opcode;
      case negate:
        place[t.r] = -a;
        break;
      case add:
        place[t.r] = a + place[t.b];
        break;
      case subtract:
        place[t.r] = a - place[t.b];
        break;
      case multiply:
        place[t.r] = a * place[t.b];
        break;
      case take_sign:
        out[static_cast<std::size_t>(Stage::first + t.r)] = a.value;
        break;
      default:
        throw std::logic_error("the ball predicates have no constants");
      }
    }
  });
  return out;
}

template <class P>
std::vector<meetc::sign> signs(const std::vector<rational> &row_a, const std::vector<rational> &row_b) {
  std::vector<number> a, b;
  for (const rational &q : row_a)
    a.emplace_back(q);
  for (const rational &q : row_b)
    b.emplace_back(q);
  std::vector<meetc::sign> out(static_cast<std::size_t>(P::atoms));
  meetc::each_stage<P>([&]<class Stage>(Stage) { meetc::stage_signs<Stage>(a.data(), b.data(), out.data()); });
  return out;
}

// A source of known signs.
struct given {
  const meetc::sign *known;
  template <class Stage> void get(meetc::sign *s) const {
    for (int i = Stage::first; i < Stage::first + Stage::atoms; ++i)
      s[i] = known[i];
  }
};

template <class P> emitted common(const char *name, other second, bool surface) {
  emitted e{};
  e.name = name;
  e.second = second;
  e.surface = surface;
  e.inputs_a = P::inputs_a;
  e.inputs_b = P::inputs_b;
  e.atoms = P::atoms;
  e.polynomials = polynomials<P>;
  e.step_polynomials = step_polynomials<P>;
  e.signs = signs<P>;
  return e;
}

template <class P> emitted predicate(const char *name, other second, bool surface) {
  emitted e = common<P>(name, second, surface);
  e.decide = [](const meetc::sign *s) { return meetc::decide<P>(given{s}); };
  e.rejected = [](const meetc::sign *s) { return bool{P::rejected(s)}; };
  e.needs_rare = [](const meetc::sign *s) { return bool{P::needs_rare(s)}; };
  e.usual = [](const meetc::sign *s) { return bool{P::usual(s)}; };
  e.whole = [](const meetc::sign *s) { return bool{P::whole(s)}; };
  return e;
}

template <class P> emitted lone_sign(const char *name, other second) {
  emitted e = common<P>(name, second, false);
  e.value = [](const meetc::sign *s) { return P::template value<meetc::sign>(s); };
  e.decide = [](const meetc::sign *s) { return meetc::decide_sign<P>(given{s}) >= meetc::sign::zero; };
  return e;
}

} // namespace

const std::vector<emitted> &emitted_predicates() {
  static const std::vector<emitted> all = {predicate<cga::ball_ball>("ball_ball", other::sphere, false),
                                           predicate<cga::sphere_sphere>("sphere_sphere", other::sphere, true),
                                           predicate<cga::ball_segment>("ball_segment", other::segment, false),
                                           predicate<cga::sphere_segment>("sphere_segment", other::segment, true),
                                           predicate<cga::ball_triangle>("ball_triangle", other::triangle, false),
                                           predicate<cga::sphere_triangle>("sphere_triangle", other::triangle, true),
                                           lone_sign<cga::side_sphere_point_sign>("side_sphere_point", other::point)};
  return all;
}

const emitted &emitted_predicate(const std::string &name) {
  for (const emitted &e : emitted_predicates())
    if (e.name == name)
      return e;
  throw std::invalid_argument(name);
}

std::vector<std::string> row_names(const emitted &e) {
  std::vector<std::string> out;
  for (int i = 0; i < e.inputs_a; ++i)
    out.push_back(fmt::format("a{}", i));
  for (int i = 0; i < e.inputs_b; ++i)
    out.push_back(fmt::format("b{}", i));
  return out;
}

} // namespace meetc::decisions_round
