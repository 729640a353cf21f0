#include "gen/driver.hpp"
#include "gen/ir/print.hpp"
#include "gen/lower/predicate/settled.hpp"
#include "gen/lower/separated.hpp"
#include "gen/passes/passes.hpp"
#include "gen/support/output.hpp"
#include "gen/target/text/text.hpp"
#include "gen/verify/verify.hpp"
#include "gen/zero_kernels.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace meetc {

compilation load(const std::string &scene_path) {
  compilation c;
  c.scene = std::make_unique<lang::scene>(lang::load_scene(scene_path, target::backends()));
  c.model = std::make_unique<lower::model>(c.scene->in);
  return c;
}

namespace {
// Whether signs need bounds: certified answers may need the exact rung, which picks integers by their growth.
bool asks_bounds(const lang::scene &s) {
  return s.asks(lang::rung::exact) || s.asks(lang::rung::certified) || s.asks(lang::rung::tolerant);
}

target::unit unit_of(const compilation &c, std::vector<lower::kernel> kernels,
                     std::vector<std::optional<bound::kernel_bounds>> bounds) {
  target::unit u{*c.scene, std::move(kernels), std::move(bounds), {}, {}, {}, {}};
  u.kinds = lower::kinds_of(*c.model, u.kernels);
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
  if (!out.kernel.is_predicate || !asks_bounds(*c.scene))
    return out;
  out.bounds = bound::analyse(lower::subject_of(out.kernel.decision));
  if (!out.bounds)
    throw spec_error(r.where, fmt::format("a sign of '{}' is not homogeneous in the stored numbers, which the exact "
                                          "rung needs",
                                          r.text));
  if (!out.kernel.is_sign) {
    lower::find_settled(out.kernel.decision, *out.bounds);
    passes::run(*out.bounds);
  }
  return out;
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

void compile_all(compilation &c) {
  std::vector<std::string> names;
  for (const lang::kernel_request &r : c.scene->kernels) {
    const lower::request request = lower::resolve(*c.model, r.what);
    if (std::find(names.begin(), names.end(), request.name()) != names.end())
      throw spec_error(r.where, fmt::format("'{}' is asked for twice", request.text));
    names.push_back(request.name());
    try {
      compiled_kernel k = compile(c, request);
      for (const lower::kernel &other : c.kernels)
        if (k.kernel.orders && other.orders == k.kernel.orders)
          throw spec_error(r.where, fmt::format("'{}' orders {} as '{}' does, and a predicate has one order",
                                                request.text, k.kernel.orders->name, other.asked.text));
      c.kernels.push_back(std::move(k.kernel));
      c.bounds.push_back(std::move(k.bounds));
    } catch (spec_error &e) {
      throw e.add_step("kernel " + request.text, r.where);
    }
  }
  tell_zero_kernels(c);
}

std::vector<target::file> emit_all(compilation &c) {
  target::unit u = unit_of(c, std::move(c.kernels), std::move(c.bounds));
  plan_tolerance(c, u);
  lower::enclose(*c.model, u.kinds);
  return target::files_of(u);
}

int plan_scene(const std::string &scene) {
  compilation c = load(scene);
  compile_all(c);
  target::unit u = unit_of(c, std::move(c.kernels), std::move(c.bounds));
  plan_tolerance(c, u);
  say(target::plan_text(u));
  return 0;
}

namespace {

// Reads 'S: sphere, L: line' as pairs.
std::vector<std::pair<std::string, std::string>> parse_operands(const lower::model &m, const std::string &text) {
  std::vector<std::pair<std::string, std::string>> out;
  const auto trim = [](std::string s) {
    s.erase(0, s.find_first_not_of(" \t"));
    s.erase(s.find_last_not_of(" \t") + 1);
    return s;
  };
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::string item = text.substr(from, comma - from);
    const std::size_t colon = item.find(':');
    if (colon == std::string::npos)
      throw spec_error({}, fmt::format("--with '{}': expected 'name: kind'", item));
    const std::string name = trim(item.substr(0, colon));
    const lang::expr_ptr e = name.empty() ? nullptr : lang::parse_expression(name, "--with");
    if (!e || e->kind != lang::op::name)
      throw spec_error({}, fmt::format("--with '{}': '{}' is not a name", item, name));
    const auto &vectors = m.spec().vectors;
    const bool taken = m.spec().find_constant(name) || m.spec().find_kind(name) ||
                       std::find(vectors.begin(), vectors.end(), name) != vectors.end() ||
                       std::any_of(out.begin(), out.end(), [&](const auto &o) { return o.first == name; });
    if (taken)
      throw spec_error({}, fmt::format("--with '{}': '{}' is taken", item, name));
    out.emplace_back(name, trim(item.substr(colon + 1)));
    from = comma + 1;
  }
  return out;
}

lower::request requested(const compilation &c, const show_options &o) {
  if (!o.expression.empty())
    return lower::resolve(*c.model, lang::parse_expression(o.expression, "-e"), parse_operands(*c.model, o.with));
  if (o.words.empty())
    throw spec_error({}, "nothing to show: name a kernel of the scene, as in 'meet sphere line', or give -e "
                         "'expression' --with 'X: sphere'");
  std::string text = o.words[0];
  if (o.words.size() > 1)
    text += '(' + join({o.words.begin() + 1, o.words.end()}, ", ") + ')';
  return lower::resolve(*c.model, lang::parse_expression(text, "the command line"));
}

std::string spec_text(const lower::model &m, const lower::request &r) {
  std::string out;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    std::vector<std::string> fields;
    for (const lang::field &f : r.kinds[i]->store)
      fields.push_back(f.name + ": " + f.type);
    out += fmt::format("{}: {} stores [{}], blade {}\n", r.names[i], r.kinds[i]->name, join(fields, ", "),
                       lang::print(*r.kinds[i]->blade));
  }
  if (r.asked) {
    for (const lang::named_expr &l : r.asked->lets)
      out += fmt::format("{} = {}\n", l.name, lang::print(*l.body));
    for (const auto &e : r.asked->reject)
      out += fmt::format("reject {}\n", lang::print(*e));
    return out + fmt::format("hit {}\n", lang::print(*r.asked->hit));
  }
  out += fmt::format("{}\n", r.text);
  for (const lang::function &f : m.spec().functions)
    if (r.text.find(f.name + "(") != std::string::npos)
      out += fmt::format("{}({}) = {}\n", f.name, join(f.params, ", "), lang::print(*f.body));
  return out;
}

// Shows a kernel's programs after one pass.
std::string after_pass(const lower::model &m, const lower::request &r, const std::string &pass) {
  const std::vector<std::string> known = passes::names();
  if (std::find(known.begin(), known.end(), pass) == known.end())
    throw spec_error(
        {}, fmt::format("--emit=after:{}: no such pass; known: {}{}", pass, join(known, ", "), nearest(pass, known)));
  lower::kernel k = lower::compile(m, r);
  passes::run(k, pass);
  std::string out;
  for (const lower::kernel_program &p : lower::programs(k))
    out += p.title + '\n' + ir::print(*p.code, *p.inputs);
  return out;
}

} // namespace

int show(const show_options &o) {
  compilation c = load(o.scene);
  const target::target *whole = target::find(o.emit);
  if (whole && whole->show_all && o.words.empty() && o.expression.empty()) {
    compile_all(c);
    target::unit u = unit_of(c, std::move(c.kernels), std::move(c.bounds));
    add_forms(*c.model, u, *whole);
    say(whole->show_all(u));
    return 0;
  }
  const lower::request r = requested(c, o);
  const std::string after = "after:";
  if (o.emit == "spec") {
    say(spec_text(*c.model, r));
  } else if (o.emit.starts_with(after)) {
    say(after_pass(*c.model, r, o.emit.substr(after.size())));
  } else {
    say(shown(c, compile(c, r), o.emit));
  }
  return 0;
}

std::vector<std::string> stages() {
  std::vector<std::string> out{"spec"};
  for (const target::target &t : target::all())
    if (t.show)
      out.emplace_back(t.name);
  for (const std::string &pass : passes::names())
    out.push_back("after:" + pass);
  return out;
}

} // namespace meetc
