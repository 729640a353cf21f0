#include "tests/gen/fuzz/expression.hpp"

#include <numeric>

namespace meetc::fuzz {
namespace {

// As gen/lang/syntax.hpp orders them.
enum strength { sum, product, wedge, unary, postfix };

strength of(const expression &e) {
  switch (e.is) {
  case form::add:
  case form::subtract:
    return sum;
  case form::multiply:
  case form::divide:
    return product;
  case form::outer:
  case form::inner:
  case form::regressive:
    return wedge;
  case form::blade:
    return e.vectors.size() > 1 && e.text.empty() ? wedge : postfix;
  case form::negate:
  case form::reverse:
    return unary;
  default:
    return postfix;
  }
}

bool is_outer(const expression &e) {
  return e.is == form::outer || e.is == form::blade;
}

// e1, e3: e13.
std::string one_name(const std::vector<std::string> &vectors) {
  std::string out = vectors.front();
  for (auto v = vectors.begin() + 1; v != vectors.end(); ++v)
    out += v->back();
  return out;
}

std::string joined(const std::vector<std::string> &parts, const char *between) {
  std::string out;
  for (const std::string &p : parts)
    out += (out.empty() ? "" : between) + p;
  return out;
}

std::string at_least(strength least, const expression &e, const std::vector<std::string> &names) {
  const std::string text = print(e, names);
  return of(e) < least || e.brackets ? '(' + text + ')' : text;
}

} // namespace

expression_ptr parameter(int index) {
  return std::make_shared<expression>(expression{.is = form::parameter, .index = index});
}

expression_ptr call(const std::string &function, std::vector<expression_ptr> arguments) {
  return std::make_shared<expression>(expression{.is = form::call, .parts = std::move(arguments), .text = function});
}

std::string print(const expression &e, const std::vector<std::string> &names) {
  const auto binary = [&](const char *sign, strength left, strength right) {
    return at_least(left, *e.parts[0], names) + sign + at_least(right, *e.parts[1], names);
  };
  switch (e.is) {
  case form::parameter:
    return names.at(static_cast<std::size_t>(e.index));
  case form::number:
    return e.text;
  case form::blade:
    return e.text.empty() ? joined(e.vectors, "^") : one_name(e.vectors);
  case form::reverse:
    return '~' + at_least(unary, *e.parts[0], names);
  case form::negate:
    return '-' + at_least(unary, *e.parts[0], names);
  case form::add:
    return binary(" + ", sum, product);
  case form::subtract:
    return binary(" - ", sum, product);
  case form::multiply:
    return binary("*", product, wedge);
  case form::divide:
    return binary("/", product, wedge);
  case form::outer: // a chain of one kind of wedge needs no parentheses on its left
    return binary(" ^ ", is_outer(*e.parts[0]) ? wedge : unary, unary);
  case form::inner:
    return binary(" | ", e.parts[0]->is == form::inner ? wedge : unary, unary);
  case form::regressive:
    return binary(" & ", e.parts[0]->is == form::regressive ? wedge : unary, unary);
  case form::coefficient:
    return at_least(postfix, *e.parts[0], names) + '[' + print(*e.parts[1], names) + ']';
  case form::call:
    break;
  }
  std::vector<std::string> arguments;
  for (const expression_ptr &p : e.parts)
    arguments.push_back(print(*p, names));
  return e.text + '(' + joined(arguments, ", ") + ')';
}

std::size_t size(const expression &e) {
  return std::accumulate(e.parts.begin(), e.parts.end(), std::size_t{1},
                         [](std::size_t n, const expression_ptr &p) { return n + size(*p); });
}

bool for_each_smaller(const expression_ptr &e, const std::function<bool(const expression_ptr &)> &visit) {
  const bool first_alone =
      e->is == form::coefficient || e->is == form::divide || (e->is == form::call && e->text == "grade");
  const std::size_t parts = first_alone ? 1 : e->parts.size();
  for (std::size_t i = 0; i < parts; ++i)
    if (visit(e->parts[i]))
      return true;
  for (std::size_t i = 0; i < parts; ++i)
    if (for_each_smaller(e->parts[i], [&](const expression_ptr &smaller) {
          expression changed = *e;
          changed.parts[i] = smaller;
          return visit(std::make_shared<expression>(std::move(changed)));
        }))
      return true;
  return false;
}

} // namespace meetc::fuzz
