// The command that prints one kernel at a stage of the compiler, or what a scene has.
#include "gen/driver.hpp"
#include "gen/ir/print.hpp"
#include "gen/lang/analytic.hpp"
#include "gen/operands.hpp"
#include "gen/passes/passes.hpp"
#include "gen/support/output.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc {
namespace {

lang::expr_ptr requested(const show_options &o) {
  if (!o.expression.empty())
    return lang::parse_expression(o.expression, "-e");
  if (o.words.empty())
    throw spec_error({}, "nothing to show: name a kernel of the scene, as in 'meet sphere line', or give -e "
                         "'expression' --with 'X: sphere'");
  std::string text = o.words[0];
  if (o.words.size() > 1)
    text += '(' + join({o.words.begin() + 1, o.words.end()}, ", ") + ')';
  return lang::parse_expression(text, "the command line");
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
    return out + fmt::format("hit {}\nmeans {}\n", lang::print(*r.asked->hit), lang::text_of(*r.asked));
  }
  out += fmt::format("{}\n", r.text);
  for (const lang::function &f : m.spec().functions)
    if (r.text.find(f.name + "(") != std::string::npos)
      out += fmt::format("{}({}) = {}\n", f.name, join(f.params, ", "), lang::print(*f.body));
  return out;
}

// The kernels of a scene with their operands, a line each.
std::string list_of_kernels(const compilation &c) {
  std::string out;
  for (const lang::kernel_request &k : c.scene->kernels) {
    const lower::request r = lower::resolve(*c.model, k.what);
    std::vector<std::string> operands;
    for (std::size_t i = 0; i < r.kinds.size(); ++i)
      operands.push_back(fmt::format("{}: {}", r.names[i], r.kinds[i]->name));
    out += fmt::format("{:<48} {}\n", r.text, join(operands, ", "));
  }
  for (const lang::kernel_request &k : c.scene->analytic)
    out += fmt::format("{:<48} no polynomial\n", lang::print(*k.what));
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

int list_targets() {
  say(target::list_of_targets());
  return 0;
}

int show(const show_options &o) {
  compilation c = load(o.scene, o.algebra_path);
  const target::target *whole = target::find(o.emit);
  if (o.words.empty() && o.expression.empty() && o.emit.empty()) {
    say(list_of_kernels(c));
    return 0;
  }
  if (whole && whole->show_all && o.words.empty() && o.expression.empty()) {
    say(shown_all(c, o.emit));
    return 0;
  }
  const lang::expr_ptr what = requested(o);
  const std::string emit = o.emit.empty() ? target::backends().unless_said.front() : o.emit, after = "after:";
  if (o.expression.empty() && lang::called_analytic(c.scene->in, *what)) {
    if (!whole && !o.emit.empty())
      throw spec_error(what->where, fmt::format("'{}' has no stage {}; --emit=cpp shows it", lang::print(*what), emit));
    say(shown(c, compile_analytic(c, *what), emit));
    return 0;
  }
  const lower::request r = o.expression.empty() ? lower::resolve(*c.model, what)
                                                : lower::resolve(*c.model, what, named_kinds(*c.model, o.with));
  if (emit == "spec") {
    say(spec_text(*c.model, r));
  } else if (emit.starts_with(after)) {
    say(after_pass(*c.model, r, emit.substr(after.size())));
  } else {
    say(shown(c, compile(c, r), emit));
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
