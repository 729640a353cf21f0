#include "tests/gen/fuzz/compiler.hpp"

#include "gen/ir/count.hpp"
#include "gen/lower/kernel/compile.hpp"
#include "gen/lower/programs/compose.hpp"

#include <fmt/format.h>

namespace meetc::fuzz {
namespace {

// The operations of a formula as gen/lower/kernel/formula.cpp may compute it.
class ways {
public:
  ways(const lower::model &m, const lower::kernel &k) : model_(m), request_(k.asked), formula_(k.value) {
    for (std::size_t i = 0; i < request_.kinds.size(); ++i) {
      supports_.push_back(lower::support(m, *request_.kinds[i]));
      unmoved_.resize(unmoved_.size() + supports_.back().size(), {static_cast<int>(i), -1, 0, false});
    }
  }

  way chosen() const {
    const int have = ir::count(formula_.from_blades.nodes, formula_.from_blades.results).total();
    const std::optional<int> arguments = composed(lower::parts::arguments), parts = composed(lower::parts::all);
    const bool is_short =
        formula_.is_expanded() && std::all_of(formula_.polynomials.begin(), formula_.polynomials.end(),
                                              [](const poly::poly &p) { return p.length() <= 150; }); // as there
    const bool others = (arguments && *arguments <= have) || (parts && *parts <= have);
    if (is_short && (!others || expanded() <= have)) // the first among equals
      return way::expanded;
    return arguments && (!parts || *arguments <= *parts) ? way::arguments : way::parts;
  }

private:
  const lower::model &model_;
  const lower::request &request_;
  const lower::formula &formula_;
  std::vector<std::vector<lower::blade>> supports_;
  std::vector<poly::stored_number> unmoved_;

  int expanded() const {
    const poly::local_origin origin(*formula_.numbers, unmoved_);
    lower::builder code(origin, lower::prefer::operations);
    std::vector<ir::node_id> results;
    for (const poly::poly &p : formula_.polynomials)
      results.push_back(code.build(p));
    return ir::count(code.nodes(), results).total();
  }
  // Nothing where that is too long.
  std::optional<int> composed(lower::parts which) const {
    const poly::local_origin origin(*formula_.numbers, unmoved_);
    lower::builder code(origin, lower::prefer::operations);
    lower::composer::scope names;
    int first = 0;
    for (std::size_t i = 0; i < supports_.size(); ++i) {
      names.emplace_back(request_.names[i], lower::composer::inputs(code, supports_[i], first));
      first += static_cast<int>(supports_[i].size());
    }
    std::vector<ir::node_id> results;
    try {
      const lower::node_values v = lower::composer(model_, code, which).compose(*request_.body, names);
      for (const lower::blade b : formula_.result)
        if (const auto it = v.find(b); it != v.end())
          results.push_back(it->second);
    } catch (const spec_error &) {
      return std::nullopt;
    }
    return ir::count(code.nodes(), results).total();
  }
};

fs::path written(const space &s) {
  const fs::path spec = MEETC_FUZZ_SPECS;
  fs::create_directories(test_files::folder() / s.name());
  const auto put = [&](const std::string &name, const std::string &text) {
    return test_files::put(s.name() + '/' + name, text);
  };
  put("algebra.toml", test_files::get(spec / (s.name() + ".toml")));
  put("functions.toml", test_files::get(spec / "functions.toml"));
  put("general.toml", s.general_text());
  return put("scene.toml", fmt::format("[scene]\nalgebra = 'algebra.toml'\nnamespace = '{}'\n"
                                       "kernels = ['gp(g1, g1)']\nbackends = ['cpp', 'c']\n",
                                       s.name()));
}

} // namespace

compiler::compiler(const space &s) : c_(load(written(s).string())), functions_(c_.scene->in.functions.size()) {}

void compiler::define(const formula &f) {
  lang::algebra &a = c_.scene->in;
  a.functions.resize(functions_);
  std::vector<std::string> names{"A", "B", "C", "D"};
  names.resize(f.arguments.size());
  a.functions.push_back(
      {f.function(), names, lang::parse_expression(f.definition(), "a formula"), nullptr, {}, {}, {}});
}

compiled compiler::compile(const formula &f) {
  define(f);
  const lower::request r = lower::resolve(*c_.model, lang::parse_expression(f.kernel(), "a kernel"));
  compiled out{f, meetc::compile(c_, r).kernel, true};
  if (out.kernel.is_predicate)
    throw std::logic_error("a formula became a predicate");
  out.was_expanded = out.kernel.value.is_expanded();
  return out;
}

bool compiler::expands(const formula &f) {
  define(f);
  const lower::request r = lower::resolve(*c_.model, lang::parse_expression(f.kernel(), "a kernel"));
  std::vector<std::vector<std::string>> names;
  std::vector<std::string> all;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    names.emplace_back();
    for (const lower::blade b : lower::support(*c_.model, *r.kinds[i]))
      names.back().push_back(r.names[i] + '.' + c_.model->working().name(b));
    all.insert(all.end(), names.back().begin(), names.back().end());
  }
  const auto has_a_value = [&](const poly::ring &ring, const auto &operand) {
    lower::decision unused;
    lower::expander of(*c_.model, ring, unused);
    lower::environment env;
    for (std::size_t i = 0; i < names.size(); ++i)
      env.emplace_back(r.names[i], operand(of, i));
    try {
      of.evaluate_multivector(*r.body, env);
      return true;
    } catch (const spec_error &) {
      return false;
    }
  };
  // An argument may vanish for the stored numbers of a kind alone, as the square of a null point does.
  return has_a_value(poly::ring(all),
                     [&](lower::expander &of, std::size_t i) {
                       return lower::value{of.general(lower::support(*c_.model, *r.kinds[i]), names[i])};
                     }) &&
         has_a_value(*lower::stored_numbers(*c_.model, r.names, r.kinds).numbers,
                     [&](lower::expander &of, std::size_t i) { return of.operand(*r.kinds[i], r.names[i] + '.'); });
}

way compiler::way_of(const compiled &c) const {
  return ways(*c_.model, c.kernel).chosen();
}

std::vector<target::file> compiler::emit(const std::vector<const compiled *> &all) {
  c_.kernels.clear();
  for (const compiled *c : all)
    c_.kernels.push_back(c->kernel);
  c_.bounds.assign(all.size(), std::nullopt);
  return emit_all(c_);
}

lower::declared_formula compiler::in_declared_basis(const compiled &c) {
  define(c.from);
  return lower::in_declared_basis(*c_.model, c.kernel.asked);
}

} // namespace meetc::fuzz
