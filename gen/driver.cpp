#include "gen/driver.hpp"
#include "gen/lower/kernel/value_names.hpp"
#include "gen/lower/kernel/wildcard.hpp"
#include "gen/lower/predicate/degrees.hpp"
#include "gen/lower/predicate/settled.hpp"
#include "gen/lower/separated.hpp"
#include "gen/passes/passes.hpp"
#include "gen/support/output.hpp"
#include "gen/target/text/text.hpp"
#include "gen/verify/verify.hpp"
#include "gen/zero_kernels.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <fmt/format.h>

namespace meetc {

compilation load(const std::string &scene_path, const std::vector<std::string> &algebra_path) {
  compilation c;
  c.scene = std::make_unique<lang::scene>(lang::load_scene(scene_path, target::backends(), algebra_path));
  c.model = std::make_unique<lower::model>(c.scene->in);
  c.scene->kernels = lower::without_wildcards(*c.model, *c.scene);
  return c;
}

namespace {
// Whether signs need bounds: certified answers may need the exact rung, which picks integers by their growth.
bool asks_bounds(const lang::scene &s) {
  return s.asks(lang::rung::exact) || s.asks(lang::rung::certified) || s.asks(lang::rung::tolerant);
}

target::unit unit_of(const compilation &c, std::vector<lower::kernel> kernels,
                     std::vector<std::optional<bound::kernel_bounds>> bounds,
                     std::vector<lower::analytic_kernel> analytic = {}) {
  target::unit u{*c.scene, std::move(kernels), std::move(bounds), {}, {}, {}, {}, std::move(analytic)};
  u.kinds = lower::kinds_of(*c.model, u.kernels, u.analytic);
  for (lower::lowered_kind &k : u.kinds)
    passes::run(k.makers);
  u.balls = lower::find_ball_form(*c.model);
  if (u.balls)
    for (ir::program *p : {&u.balls->a, &u.balls->b})
      *p = passes::run(*p, *u.balls->numbers);
  return u;
}

// Plans the scene's tolerance. A kernel that compares a distance in plain fp32, and nothing else, needs no bounds.
void plan_tolerance(const compilation &c, target::unit &u) {
  if (!c.scene->asks(lang::rung::tolerant))
    return;
  u.tolerance = lower::plan_tolerance(*c.model, *c.scene, u.kernels, u.bounds);
  // The proof presumes that the predicate says whether its operands touch. Some hundred cases tell most others.
  for (std::size_t i = 0; i < u.kernels.size(); ++i) {
    const lower::request &asked = u.kernels[i].asked;
    if (!u.tolerance.ways[i])
      continue;
    const verify::report r = verify::verify_predicate(*c.model, u.kernels[i], 400, 1);
    if (r.cases == 0)
      throw spec_error(asked.where, fmt::format("'{}' keeps no tolerance, since nothing shows that it says whether its "
                                                "operands touch: none of its cases could be compared",
                                                asked.text));
    if (r.wrong > 0)
      throw spec_error(asked.where,
                       fmt::format("'{}' keeps no tolerance, since it does not say whether its operands touch: "
                                   "{} of {} cases are wrong (meetc verify)",
                                   asked.text, r.wrong, r.cases));
  }
  for (std::size_t i = 0; i < u.kernels.size(); ++i)
    if (c.scene->rungs.size() == 1 && u.tolerance.ways[i] && u.tolerance.ways[i]->by_distance)
      u.bounds[i].reset();
}

void add_forms(const lower::model &m, target::unit &u, const target::target &t) {
  if (!t.reads_polynomials)
    return;
  for (const lower::kernel &k : u.kernels) {
    if (!k.is_predicate && !k.value.is_expanded())
      throw spec_error(k.asked.where, fmt::format("the polynomials of '{}' are too long for --emit={}; --emit=schedule "
                                                  "shows its program",
                                                  k.asked.text, t.name));
    target::forms f;
    f.separated = lower::separate(m, k);
    if (!k.is_predicate) {
      f.declared = lower::in_declared_basis(m, k.asked);
      f.declared_separated = lower::separate(*f.declared);
    }
    u.shown.push_back(std::move(f));
  }
}
} // namespace

// The stages of the compiler, one line each.
compiled_kernel compile(const compilation &c, const lower::request &r) {
  compiled_kernel out{lower::compile(*c.model, r), std::nullopt};
  passes::run(out.kernel);
  lower::name_values(*c.model, out.kernel);
  if (!out.kernel.is_predicate || !asks_bounds(*c.scene))
    return out;
  out.bounds = bound::analyse(lower::subject_of(out.kernel.decision));
  if (!out.bounds)
    lower::refuse_degrees(r, out.kernel.decision);
  if (!out.bounds->groups.weights.empty())
    lower::check_versors(*c.model, r, out.kernel.decision);
  if (!out.kernel.is_sign) {
    lower::find_settled(out.kernel.decision, *out.bounds);
    passes::run(*out.bounds);
  }
  return out;
}

lower::analytic_kernel compile_analytic(const compilation &c, const lang::expr &call) {
  lower::analytic_kernel k = lower::compile_analytic(*c.model, call);
  passes::run(k);
  return k;
}

std::string shown(const compilation &c, const lower::analytic_kernel &k, const std::string &target) {
  if (!target::find(target)->show_analytic)
    throw spec_error(k.where,
                     fmt::format("--emit={} shows polynomials and signs, and '{}' is neither", target, k.text));
  return target::find(target)->show_analytic(unit_of(c, {}, {}, {k}), 0);
}

std::string shown(const compilation &c, const compiled_kernel &k, const std::string &target) {
  std::vector<lower::kernel> kernels{k.kernel};
  std::vector<std::optional<bound::kernel_bounds>> bounds{k.bounds};
  if (c.scene->asks(lang::rung::tolerant)) // the grid is one for all kernels of the scene
    for (const lang::kernel_request &r : c.scene->kernels) {
      compiled_kernel other = compile(c, lower::resolve(*c.model, r.what));
      kernels.push_back(std::move(other.kernel)), bounds.push_back(std::move(other.bounds));
    }
  target::unit u = unit_of(c, std::move(kernels), std::move(bounds));
  plan_tolerance(c, u);
  add_forms(*c.model, u, *target::find(target));
  return target::find(target)->show(u, 0);
}

namespace {
std::string without_spaces(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
  return text;
}
} // namespace

void compile_all(compilation &c) {
  std::map<std::string, std::string> texts; // by name
  for (const lang::kernel_request &r : c.scene->kernels) {
    const lower::request request = lower::resolve(*c.model, r.what);
    const auto [it, fresh] = texts.try_emplace(request.name(), request.text);
    if (!fresh && without_spaces(it->second) == without_spaces(request.text))
      throw spec_error(r.where, fmt::format("'{}' is asked for twice", request.text));
    if (!fresh)
      throw spec_error(r.where,
                       fmt::format("'{}' would have the name {} as '{}' has; give one of them a name by a function of "
                                   "the algebra, '{}_2(A, B)' = '…', and ask for that",
                                   request.text, request.name(), it->second, request.function));
    try {
      compiled_kernel k = compile(c, request);
      for (const lower::kernel &other : c.kernels)
        if (k.kernel.orders && other.orders == k.kernel.orders)
          throw spec_error(r.where, fmt::format("'{}' orders {} as '{}' does, and a predicate has one order",
                                                request.text, k.kernel.orders->name, other.asked.text));
      c.kernels.push_back(std::move(k.kernel));
      c.bounds.push_back(std::move(k.bounds));
    } catch (spec_error &e) {
      if (e.where().file && e.where().file == r.what->where.file && r.what->where.file != r.where.file) // of a wildcard
        throw spec_error(r.where, fmt::format("{}, for {}", e.message(), request.text));
      throw e.add_step("kernel " + request.text, r.where);
    }
  }
  for (const lang::kernel_request &r : c.scene->analytic) {
    lower::analytic_kernel k = compile_analytic(c, *r.what);
    if (const auto [it, fresh] = texts.try_emplace(k.name, k.text); !fresh)
      throw spec_error(r.where, it->second == k.text ? fmt::format("'{}' is asked for twice", k.text)
                                                     : fmt::format("'{}' would have the name {} as '{}' has", k.text,
                                                                   k.name, it->second));
    c.analytic.push_back(std::move(k));
  }
  tell_zero_kernels(c);
}

std::string shown_all(compilation &c, const std::string &target) {
  compile_all(c);
  target::unit u = unit_of(c, std::move(c.kernels), std::move(c.bounds));
  add_forms(*c.model, u, *target::find(target));
  return target::find(target)->show_all(u);
}

std::vector<target::file> emit_all(compilation &c) {
  target::unit u = unit_of(c, std::move(c.kernels), std::move(c.bounds), std::move(c.analytic));
  plan_tolerance(c, u);
  lower::enclose(*c.model, u.kinds);
  return target::files_of(u);
}

int plan_scene(const plan_options &o) {
  compilation c = load(o.scene, o.algebra_path);
  compile_all(c);
  target::unit u = unit_of(c, std::move(c.kernels), std::move(c.bounds));
  plan_tolerance(c, u);
  say(target::plan_text(u));
  return 0;
}

} // namespace meetc
