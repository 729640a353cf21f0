#include "gen/operands.hpp"

#include "gen/lower/kernel/kernel.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace meetc {
namespace {

using lower::rational;

std::string trim(std::string s) {
  s.erase(0, s.find_first_not_of(" \t\n"));
  s.erase(s.find_last_not_of(" \t\n") + 1);
  return s;
}

std::vector<std::string> split(const std::string &text, const char *at) {
  std::vector<std::string> out;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(at, from), text.size());
    out.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  if (!out.empty() && trim(out.back()).empty()) // the last separator may end the list
    out.pop_back();
  return out;
}

// A whole number in decimals, with a sign perhaps. Empty: it is none.
bool is_whole(const std::string &s, bool sign) {
  const std::size_t from = sign && !s.empty() && (s[0] == '-' || s[0] == '+') ? 1 : 0;
  return s.size() > from && s.find_first_not_of("0123456789", from) == std::string::npos;
}

// 12, -0.5, 1e-3 or 2/3, exactly.
rational number(const std::string &text, const std::string &item) {
  const auto refuse = [&] {
    return spec_error({}, fmt::format("--with '{}': '{}' is not a number, such as 12, -0.5, 1e-3 or 2/3", item, text));
  };
  if (text.size() > 300)
    throw refuse();
  const std::size_t slash = text.find('/'), e = std::min(text.find_first_of("eE"), text.size());
  if (slash != std::string::npos) {
    const std::string above = text.substr(0, slash), below = text.substr(slash + 1);
    if (!is_whole(above, true) || !is_whole(below, false) || below.find_first_not_of('0') == std::string::npos)
      throw refuse();
    rational q(above[0] == '+' ? above.substr(1) + '/' + below : text, 10);
    q.canonicalize();
    return q;
  }
  std::string digits = text.substr(0, e), exponent = e < text.size() ? text.substr(e + 1) : "0";
  const std::size_t dot = digits.find('.');
  long decimals = 0;
  if (dot != std::string::npos) {
    decimals = static_cast<long>(digits.size() - dot - 1);
    digits.erase(dot, 1);
  }
  if (!is_whole(digits, true) || !is_whole(exponent, true) || exponent.size() > 5)
    throw refuse();
  const long power = std::stol(exponent) - decimals;
  if (std::abs(power) > 2000)
    throw refuse();
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(power)));
  const mpz_class whole(digits[0] == '+' ? digits.substr(1) : digits, 10);
  rational q = power < 0 ? rational(whole, scale) : rational(whole * scale);
  q.canonicalize();
  return q;
}

// 'S: sphere', with names that nothing else has.
class declared {
public:
  explicit declared(const lower::model &m) : model_(m) {}

  std::pair<std::string, std::string> add(const std::string &item) {
    const std::size_t colon = item.find(':');
    if (colon == std::string::npos)
      throw spec_error({}, fmt::format("--with '{}': expected 'name: kind'", item));
    const std::string name = trim(item.substr(0, colon));
    const lang::expr_ptr e = name.empty() ? nullptr : lang::parse_expression(name, "--with");
    if (!e || e->kind != lang::op::name)
      throw spec_error({}, fmt::format("--with '{}': '{}' is not a name", item, name));
    const lang::algebra &a = model_.spec();
    const bool taken = a.find_constant(name) || a.find_kind(name) ||
                       std::find(a.vectors.begin(), a.vectors.end(), name) != a.vectors.end() ||
                       std::find(names_.begin(), names_.end(), name) != names_.end();
    if (taken)
      throw spec_error({}, fmt::format("--with '{}': '{}' is taken", item, name));
    names_.push_back(name);
    return {name, trim(item.substr(colon + 1))};
  }

private:
  const lower::model &model_;
  std::vector<std::string> names_;
};

} // namespace

std::vector<std::pair<std::string, std::string>> named_kinds(const lower::model &m, const std::string &text) {
  declared names(m);
  std::vector<std::pair<std::string, std::string>> out;
  for (const std::string &item : split(text, ",;"))
    out.push_back(names.add(item));
  return out;
}

std::vector<given_operand> given_operands(const lower::model &m, const std::string &text) {
  declared names(m);
  std::vector<given_operand> out;
  for (const std::string &item : split(text, ";")) {
    const std::size_t equal = item.find('=');
    if (equal == std::string::npos)
      throw spec_error({}, fmt::format("--with '{}': expected 'name: kind = numbers', and ';' between operands", item));
    const auto [name, kind] = names.add(item.substr(0, equal));
    given_operand o{name, &m.kind(kind, {}), {}};
    for (const std::string &n : split(item.substr(equal + 1), ","))
      o.numbers.push_back(number(trim(n), item));
    const std::vector<lower::stored_real> reals = m.layout(*o.kind).reals;
    std::vector<std::string> paths;
    for (const lower::stored_real &r : reals)
      paths.push_back(r.path);
    if (o.numbers.size() != reals.size())
      throw spec_error({}, fmt::format("--with '{}': a {} stores {} numbers ({}), not {}", item, kind, reals.size(),
                                       join(paths, ", "), o.numbers.size()));
    if (!lower::obeys(lower::rule_of(m, *o.kind), o.numbers))
      throw spec_error({}, fmt::format("--with '{}': this is no valid {}: {}", item, kind, lang::print(*o.kind->rule)));
    out.push_back(std::move(o));
  }
  return out;
}

} // namespace meetc
