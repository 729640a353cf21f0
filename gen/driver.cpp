#include "gen/driver.hpp"
#include "gen/target/gappa/gappa.hpp"
#include "gen/verify/verify.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <iterator>

namespace meetc {

compilation load(const std::string &scene_path) {
  compilation c;
  c.scene = std::make_unique<lang::scene>(lang::load_scene(scene_path));
  c.model = std::make_unique<lower::model>(c.scene->in);
  return c;
}

namespace {
// Certified answers end in exact ones.
bool asks_exact(const lang::scene &s) {
  return std::any_of(s.rungs.begin(), s.rungs.end(),
                     [](const std::string &r) { return r == "exact" || r == "certified"; });
}

target::unit unit_of(const compilation &c, std::vector<lower::kernel> kernels) {
  target::unit u{*c.scene, *c.model, std::move(kernels), {}};
  for (const lower::kernel &k : u.kernels) {
    u.bounds.emplace_back();
    if (k.is_predicate && asks_exact(*c.scene))
      u.bounds.back() = bound::analyse(k.decision);
  }
  return u;
}
} // namespace

void compile_all(compilation &c) {
  std::vector<std::string> names;
  for (const lang::kernel_request &r : c.scene->kernels) {
    const lower::request request = lower::resolve(*c.model, r.what);
    if (std::find(names.begin(), names.end(), request.name()) != names.end())
      throw spec_error(r.where, fmt::format("'{}' is asked for twice", request.text));
    names.push_back(request.name());
    try {
      c.kernels.push_back(lower::compile(*c.model, request, asks_exact(*c.scene)));
    } catch (spec_error &e) {
      throw e.add_step("kernel " + request.text, r.where);
    }
  }
}

std::vector<target::file> emit_all(compilation &c) {
  const target::unit u = unit_of(c, std::move(c.kernels));
  std::vector<target::file> files = target::cpp_files(u);
  if (u.asks("certified")) {
    std::vector<target::file> proofs = target::proof_files(u);
    std::move(proofs.begin(), proofs.end(), std::back_inserter(files));
    if (u.has_backend("cuda")) {
      std::vector<target::file> filter = target::filter_proofs(u);
      std::move(filter.begin(), filter.end(), std::back_inserter(files));
    }
    std::sort(files.begin(), files.end(), [](const auto &a, const auto &b) { return a.path < b.path; });
  }
  for (std::size_t i = 1; i < files.size(); ++i) // sorted by path
    if (files[i].path == files[i - 1].path)
      throw spec_error({},
                       fmt::format("'{}' would be written twice: a kernel has the name of the namespace or of a file "
                                   "that every namespace has; rename one",
                                   files[i].path));
  return files;
}

int verify_scene(const verify_options &o) {
  compilation c = load(o.scene);
  compile_all(c);
  long wrong = 0, cases = 0;
  for (const lower::kernel &k : c.kernels) {
    const verify::report r = k.is_sign        ? verify::verify_sign(*c.model, k, std::max(1L, o.cases / 10), o.seed)
                             : k.is_predicate ? verify::verify_predicate(*c.model, k, o.cases, o.seed)
                                              : verify::verify_formula(*c.model, k, std::max(1L, o.cases / 50), o.seed);
    wrong += r.wrong;
    cases += r.cases;
    if (!r.note.empty())
      fmt::print("{:<36} {}\n", k.asked.text, r.note);
    else if (k.is_predicate && !k.is_sign)
      fmt::print("{:<36} {} wrong of {} ({} hits, {} degenerate)\n", k.asked.text, r.wrong, r.cases, r.hits,
                 r.degenerate);
    else
      fmt::print("{:<36} {} wrong of {}\n", k.asked.text, r.wrong, r.cases);
    if (r.wrong)
      fmt::print("  first: {}\n", r.first_wrong);
  }
  fmt::print("{}: {} wrong of {} cases in {} kernels\n", c.scene->name, wrong, cases, c.kernels.size());
  return wrong ? 1 : 0;
}

namespace {

// 'S: sphere, L: line' to pairs.
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
    throw spec_error(
        {}, "show what? A kernel of the scene, as in 'meet sphere line', or -e 'expression' --with 'X: sphere'");
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

// The bounds of the unit's one kernel.
std::string bounds_text(const target::unit &u, bool as_proofs) {
  if (!u.kernels.front().is_predicate)
    throw spec_error({}, "only predicates and signs have error bounds; this is a formula");
  if (!u.bounds.front())
    throw spec_error({}, "the scene asks for neither 'exact' nor 'certified', so nothing bounds its errors");
  if (!as_proofs)
    return target::bounds_table(u, 0);
  std::string out;
  for (const target::file &f : target::proof_files(u))
    out += fmt::format("{}# {}\n{}", out.empty() ? "" : "\n", f.path, f.text);
  return out;
}

} // namespace

int show(const show_options &o) {
  compilation c = load(o.scene);
  if (o.emit == "separate" && o.words.empty() && o.expression.empty()) {
    compile_all(c);
    fmt::print("{}", target::separate_table(*c.model, c.kernels));
    return 0;
  }
  const lower::request r = requested(c, o);
  if (o.emit == "spec") {
    fmt::print("{}", spec_text(*c.model, r));
    return 0;
  }
  std::vector<lower::kernel> one;
  one.push_back(lower::compile(*c.model, r, asks_exact(*c.scene)));
  const target::unit u = unit_of(c, std::move(one));
  const lower::kernel &k = u.kernels.front();
  if (o.emit == "json")
    fmt::print("{}", target::json(*c.model, k));
  else if (o.emit == "latex")
    fmt::print("{}", target::latex(*c.model, k));
  else if (o.emit == "poly")
    fmt::print("{}", target::poly_text(*c.model, k));
  else if (o.emit == "separate")
    fmt::print("{}", target::separate_text(*c.model, k));
  else if (o.emit == "dag" || o.emit == "schedule")
    fmt::print("{}", target::dag_text(k, o.emit == "schedule"));
  else if (o.emit == "cuda" && k.is_predicate && !k.is_sign)
    fmt::print("{}", target::cuda_text(u));
  else if (o.emit == "cuda")
    throw spec_error({},
                     "only predicates have CUDA launchers; a formula's header (--emit=cpp) is host and device code");
  else if (o.emit == "gappa" || o.emit == "bounds")
    fmt::print("{}", bounds_text(u, o.emit == "gappa"));
  else
    fmt::print("{}", target::cpp_text(u, 0));
  return 0;
}

} // namespace meetc
