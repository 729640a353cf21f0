#include "gen/lower/kernel/wildcard.hpp"

#include "gen/lower/expand/expand.hpp"
#include "gen/lower/kernel/kernel.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <optional>

namespace meetc::lower {
namespace {

constexpr std::size_t most_kernels = 2000; // of one wildcard
constexpr long most_steps_tried = 50'000;  // for one choice of kinds

bool is_wildcard(const lang::expr &e) {
  return e.kind == lang::op::name && e.text == "*";
}

void collect(const lang::expr &e, std::vector<const lang::expr *> &out) {
  if (is_wildcard(e))
    out.push_back(&e);
  for (const lang::expr_ptr &arg : e.args)
    collect(*arg, out);
}

// The blades of segments, triangles and boxes are those of other kinds, and so are those of pairs of such.
bool has_own_blade(const lang::algebra &a, const lang::kind &k) {
  if (k.hull && !k.pad)
    return false;
  return std::all_of(k.store.begin(), k.store.end(), [&](const lang::field &f) {
    const lang::kind *part = a.find_kind(f.type);
    return !part || has_own_blade(a, *part);
  });
}

std::vector<const lang::kind *> chosen(const model &m, const lang::scene &s) {
  std::vector<const lang::kind *> out;
  for (const lang::field &f : s.kinds)
    out.push_back(&m.kind(f.type, f.where));
  if (s.kinds.empty())
    for (const lang::kind &k : m.spec().kinds)
      if (has_own_blade(m.spec(), k))
        out.push_back(&k);
  return out;
}

const char *const always_zero = "it is always zero";

// The fault of the kernel on operands of these kinds, if there is one.
std::optional<std::string> refusal_of_stored(const model &m, const request &r, bool &is_sign) {
  const stored_ring stored = stored_numbers(m, r.names, r.kinds);
  decision signs;
  expander of(m, *stored.numbers, signs);
  of.limit(most_steps_tried);
  environment operands;
  for (std::size_t i = 0; i < r.kinds.size(); ++i)
    operands.emplace_back(r.names[i], of.operand(*r.kinds[i], r.names[i] + '.'));
  const value v = of.evaluate(*r.body, operands);
  const auto *sign = std::get_if<sign_value>(&v.is);
  is_sign = sign && r.kinds.size() == 2;
  if (is_sign)
    return sign->unit == 0 ? std::optional<std::string>(always_zero) : std::nullopt;
  return of.blade_of(v, r.where).is_zero() ? std::optional<std::string>(always_zero) : std::nullopt;
}

// And on general blades, with numbers as coefficients. Signs are taken of stored operands alone.
std::optional<std::string> refusal_of_blades(const model &m, const request &r) {
  const poly::ring none({});
  decision unused;
  expander of(m, none, unused);
  environment blades;
  int next = 0;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    multivector operand;
    for (const blade b : support(m, *r.kinds[i]))
      operand.add(b, {none, rational(7 + 3 * next * next + 11 * next)}), ++next;
    blades.emplace_back(r.names[i], value{operand});
  }
  of.evaluate(*r.body, blades);
  return std::nullopt;
}

std::optional<std::string> refusal(const model &m, const lang::expr_ptr &e) {
  try {
    const request r = resolve(m, e);
    bool is_sign = false;
    try {
      if (auto why = refusal_of_stored(m, r, is_sign))
        return why;
    } catch (const too_long &) { // it is composed of its parts later
    }
    return is_sign ? std::nullopt : refusal_of_blades(m, r);
  } catch (const spec_error &error) {
    return error.message();
  }
}

// The source text with the wildcards replaced by the names of kinds.
lang::expr_ptr with_kinds(const lang::expr &e, const std::vector<const lang::expr *> &wildcards,
                          const std::vector<const lang::kind *> &kinds) {
  std::string text = lang::print(e);
  for (std::size_t i = wildcards.size(); i-- > 0;)
    text.replace(wildcards[i]->where.offset - e.where.offset, 1, kinds[i]->name);
  return lang::parse_expression(text, e.where.text());
}

} // namespace

std::vector<lang::kernel_request> without_wildcards(const model &m, const lang::scene &s) {
  std::vector<lang::kernel_request> out;
  for (const lang::kernel_request &r : s.kernels) {
    std::vector<const lang::expr *> wildcards;
    collect(*r.what, wildcards);
    if (wildcards.empty()) {
      out.push_back(r);
      continue;
    }
    const std::vector<const lang::kind *> kinds = chosen(m, s);
    double choices = 1;
    for (std::size_t i = 0; i < wildcards.size(); ++i)
      choices *= static_cast<double>(kinds.size());
    if (choices > most_kernels)
      throw spec_error(r.where,
                       fmt::format("'{}' stands for more than {} kernels; name some of its kinds, or those that "
                                   "the scene wants: kinds = ['{}', …]",
                                   lang::print(*r.what), most_kernels, kinds.front()->name));
    const std::size_t before = out.size();
    std::string first_refusal;
    std::vector<const lang::kind *> of(wildcards.size());
    const std::function<void(std::size_t)> choose = [&](std::size_t i) {
      if (i < of.size()) {
        for (const lang::kind *k : kinds) {
          of[i] = k;
          choose(i + 1);
        }
        return;
      }
      const lang::expr_ptr e = with_kinds(*r.what, wildcards, of);
      if (const auto why = refusal(m, e); !why)
        out.push_back({e, r.where});
      else if (first_refusal.empty())
        first_refusal = fmt::format("{}: {}", lang::print(*e), *why);
    };
    choose(0);
    if (out.size() == before)
      throw spec_error(r.where,
                       fmt::format("'{}' has no value for any kinds; {}", lang::print(*r.what), first_refusal));
  }
  return out;
}

} // namespace meetc::lower
