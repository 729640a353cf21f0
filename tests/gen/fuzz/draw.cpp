#include "tests/gen/fuzz/draw.hpp"

#include "tests/gen/fuzz/evaluate.hpp"
#include "tests/gen/oracle/random.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::fuzz {
namespace {

using oracle_test::random_numbers;

const std::vector<std::string> parameter_names{"A", "B", "C", "D"};

class drawer {
public:
  drawer(const space &s, random_numbers &r, int parameters) : in_(s), random_(r), parameters_(parameters) {}

  expression_ptr tree(int depth) {
    if (depth == 0)
      return leaf();
    expression e{.is = form::multiply};
    e.brackets = random_.integer(1, 8) == 1;
    const int which = random_.integer(1, 100);
    if (which <= 24)
      return call_of(depth);
    if (which <= 46)
      e.is = form::multiply;
    else if (which <= 57)
      e.is = form::outer;
    else if (which <= 68)
      e.is = form::inner;
    else if (which <= 78)
      e.is = form::add;
    else if (which <= 88)
      e.is = form::subtract;
    else if (which <= 90)
      e.is = form::negate;
    else if (which <= 92)
      e.is = form::reverse;
    else if (which <= 93)
      e.is = form::regressive;
    else if (which <= 95)
      e.is = form::divide;
    else
      e.is = form::coefficient;
    e.parts.push_back(tree(random_.integer(0, depth - 1)));
    if (e.is == form::divide)
      e.parts.push_back(random_.integer(1, 3) == 1 ? basis_blade() : number());
    else if (e.is == form::coefficient)
      e.parts.push_back(index());
    else if (e.is != form::negate && e.is != form::reverse)
      e.parts.push_back(tree(depth - 1));
    if (e.parts.size() == 2 && e.is != form::divide && e.is != form::coefficient && random_.integer(0, 1) == 1)
      std::swap(e.parts[0], e.parts[1]);
    // A number has no wedge and no inner product (but once in a while that is tried).
    for (expression_ptr &p : e.parts)
      if ((e.is == form::outer || e.is == form::inner) && p->is == form::number && random_.integer(1, 10) > 1)
        p = parameter(random_.integer(0, parameters_ - 1));
    return std::make_shared<expression>(std::move(e));
  }

private:
  const space &in_;
  random_numbers &random_;
  int parameters_;

  expression_ptr leaf() {
    const int which = random_.integer(1, 20);
    return which == 1 ? number() : which <= 3 ? basis_blade() : parameter(random_.integer(0, parameters_ - 1));
  }
  expression_ptr number() {
    static const std::vector<std::string> texts{"2", "3", "0.5", "1", "7", "1.25", "0.1", "12", "1000003"};
    return std::make_shared<expression>(
        expression{.is = form::number,
                   .text = texts[static_cast<std::size_t>(random_.integer(0, static_cast<int>(texts.size()) - 1))]});
  }
  // The vectors are declared ones, or where there are null vectors of these in place of the last two; in any order.
  expression_ptr basis_blade() {
    if (random_.integer(1, 6) == 1)
      return std::make_shared<expression>(expression{.is = form::blade, .vectors = {"I"}});
    std::vector<std::string> from = in_.vectors();
    if (!in_.null_vectors().empty() && random_.integer(0, 1) == 1)
      std::copy(in_.null_vectors().begin(), in_.null_vectors().end(), from.end() - 2);
    std::vector<std::string> vectors;
    for (const std::string &v : from)
      if (random_.integer(0, 2) == 0)
        vectors.push_back(v);
    if (vectors.empty())
      vectors.push_back(from[static_cast<std::size_t>(random_.integer(0, static_cast<int>(from.size()) - 1))]);
    if (random_.integer(0, 1) == 1)
      std::swap(vectors.front(), vectors.back());
    const bool numbered = std::all_of(vectors.begin(), vectors.end(), [&](const std::string &v) {
      return v.size() == 2 && v[0] == vectors[0][0] && v[1] >= '0' && v[1] <= '9';
    });
    const bool one_name = vectors.size() > 1 && numbered && random_.integer(0, 1) == 1;
    return std::make_shared<expression>(
        expression{.is = form::blade, .text = one_name ? "one name" : "", .vectors = vectors});
  }
  // [1], [e1^n], [-e2^e1], [2*e1], and where vectors are orthogonal [e1*e2].
  expression_ptr index() {
    const int which = random_.integer(1, 10);
    if (which <= 3)
      return std::make_shared<expression>(expression{.is = form::number, .text = "1"});
    expression_ptr b = basis_blade();
    if (which == 4)
      return std::make_shared<expression>(expression{.is = form::negate, .parts = {b}, .brackets = true});
    if (which == 5)
      return std::make_shared<expression>(expression{.is = form::multiply, .parts = {number(), b}});
    if (which == 6 && in_.is_orthogonal())
      return std::make_shared<expression>(expression{
          .is = form::multiply,
          .parts = {std::make_shared<expression>(expression{.is = form::blade, .vectors = {in_.vectors()[0]}}),
                    std::make_shared<expression>(expression{.is = form::blade, .vectors = {in_.vectors()[2]}})}});
    return b;
  }
  expression_ptr call_of(int depth) {
    const int special = random_.integer(1, 20);
    if (special == 1)
      return call("inverse", {random_.integer(0, 1) == 1 ? basis_blade() : number()});
    if (special == 2) {
      const int k = random_.integer(0, static_cast<int>(in_.vectors().size()));
      return call("grade", {tree(depth - 1),
                            std::make_shared<expression>(expression{.is = form::number, .text = std::to_string(k)})});
    }
    const int last = static_cast<int>(functions.size()) - 1;
    const function &f =
        functions[static_cast<std::size_t>(std::min(random_.integer(0, last), random_.integer(0, last)))];
    std::vector<expression_ptr> arguments;
    const bool plain =
        std::string(f.name) == "meet" && random_.integer(1, 4) > 1; // of single grades it is more often defined
    for (int i = 0; i < f.arguments; ++i)
      arguments.push_back(plain ? parameter(random_.integer(0, parameters_ - 1))
                                : tree(i == 0 ? depth - 1 : random_.integer(0, depth - 1)));
    return call(f.name, std::move(arguments));
  }
};

std::string drawn_kind(const space &s, random_numbers &random) {
  while (true) {
    const kind &k = s.kinds()[static_cast<std::size_t>(random.integer(0, static_cast<int>(s.kinds().size()) - 1))];
    const auto blades = std::count(k.support.begin(), k.support.end(), true);
    if (blades <= 16 || random.integer(1, 4) == 1)
      return k.name;
  }
}

// The arguments of the kernel: kinds, or calls of functions on kinds.
void draw_arguments(formula &f, random_numbers &random, int parameters) {
  for (int i = 0; i < parameters; ++i) {
    const int left = 4 - static_cast<int>(f.kinds.size()) - (parameters - i - 1);
    const auto operand = [&] {
      f.kinds.push_back(drawn_kind(*f.in, random));
      return parameter(static_cast<int>(f.kinds.size()) - 1);
    };
    if (random.integer(1, 3) > 1) {
      f.arguments.push_back(operand());
      continue;
    }
    const function *g = nullptr;
    while (!g || g->arguments > left)
      g = &functions[static_cast<std::size_t>(random.integer(0, static_cast<int>(functions.size()) - 1))];
    std::vector<expression_ptr> of;
    for (int k = 0; k < g->arguments; ++k)
      of.push_back(operand());
    f.arguments.push_back(call(g->name, std::move(of)));
  }
}

void collect(const expression &e, std::vector<int> &parameters) {
  if (e.is == form::parameter)
    parameters.push_back(e.index);
  for (const expression_ptr &p : e.parts)
    collect(*p, parameters);
}

expression_ptr renumbered(const expression_ptr &e, const std::vector<int> &to) {
  expression out = *e;
  if (e->is == form::parameter)
    out.index = to[static_cast<std::size_t>(e->index)];
  for (expression_ptr &p : out.parts)
    p = renumbered(p, to);
  return std::make_shared<expression>(std::move(out));
}

// With these arguments, and only the operands that they have.
formula with_arguments(const formula &f, const std::vector<expression_ptr> &arguments) {
  formula out{f.in, f.number, f.body, {}, {}};
  std::vector<int> used, to(f.kinds.size(), -1);
  for (const expression_ptr &a : arguments)
    collect(*a, used);
  for (const int operand : used) {
    to[static_cast<std::size_t>(operand)] = static_cast<int>(out.kinds.size());
    out.kinds.push_back(f.kinds[static_cast<std::size_t>(operand)]);
  }
  for (const expression_ptr &a : arguments)
    out.arguments.push_back(renumbered(a, to));
  return out;
}

} // namespace

bool for_each_smaller(const formula &f, const std::function<bool(const formula &)> &visit) {
  const auto of_body = [&](const expression_ptr &body) {
    formula smaller = f;
    smaller.body = body;
    return visit(smaller);
  };
  if (for_each_smaller(f.body, of_body))
    return true;
  std::vector<int> used;
  collect(*f.body, used);
  for (std::size_t i = 0; i < f.arguments.size(); ++i) {
    std::vector<expression_ptr> arguments = f.arguments;
    for (const expression_ptr &part : f.arguments[i]->parts) {
      arguments[i] = part;
      if (visit(with_arguments(f, arguments)))
        return true;
    }
    if (f.arguments.size() == 1 || std::find(used.begin(), used.end(), static_cast<int>(i)) != used.end())
      continue;
    arguments = f.arguments; // nothing reads this one
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    std::vector<int> to;
    for (std::size_t k = 0; k < f.arguments.size(); ++k)
      to.push_back(static_cast<int>(k) - (k > i));
    formula smaller = with_arguments(f, arguments);
    smaller.body = renumbered(f.body, to);
    if (visit(smaller))
      return true;
  }
  return false;
}

std::string formula::function() const {
  return fmt::format("f{}", number);
}

std::string formula::definition() const {
  return print(*body, parameter_names);
}

std::string formula::kernel() const {
  std::string out = function() + '(';
  for (std::size_t i = 0; i < arguments.size(); ++i)
    out += (i ? ", " : "") + print(*arguments[i], kinds);
  return out + ')';
}

std::string formula::text() const {
  std::string parameters;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    parameters += (i ? ", " : "") + parameter_names[i];
  return fmt::format("in {}: {} where {}({}) = {}", in->name(), kernel(), function(), parameters, definition());
}

formula draw(std::uint64_t seed, long number) {
  random_numbers random(seed * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(number) * 0xbf58476d1ce4e5b9U);
  while (true) {
    const space &s = spaces()[static_cast<std::size_t>(random.integer(0, static_cast<int>(spaces().size()) - 1))];
    formula f{&s, number, nullptr, {}, {}};
    const int parameters = std::min(random.integer(1, 5), random.integer(1, 4));
    draw_arguments(f, random, parameters);
    f.body = drawer(s, random, parameters).tree(random.integer(1, 4));
    const effort e = effort_of(f);
    // Longer programs take a compiler seconds; those that expand to little are more often drawn than the others.
    if (e.products <= 3000 && (e.terms < 1e6 || random.integer(1, 3) == 1))
      return f;
  }
}

} // namespace meetc::fuzz
