#include "gen/lang/hints.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <utility>

namespace meetc::lang {
namespace {

using row = std::pair<const char *, const char *>;

template <std::size_t N> std::string written(const std::array<row, N> &table, const std::string &name) {
  const auto at = std::find_if(table.begin(), table.end(), [&](const row &r) { return r.first == name; });
  return at == table.end() ? "" : fmt::format("; write {}", at->second);
}

constexpr const char *no_choice =
    "the comparisons that it stands for: a predicate is made of signs, 'and', 'or' and 'if'";

} // namespace

std::string hint_for_symbol(const std::string &symbol) {
  static constexpr std::array<row, 20> table{{
      {"∧", "'^' for the outer product"},
      {"∨", "'&' for the regressive product"},
      {"⌋", "'|' for the left contraction"},
      {"·", "'|' for the left contraction, or dot(A, B)"},
      {"⋅", "'|' for the left contraction, or dot(A, B)"},
      {"•", "'|' for the left contraction, or dot(A, B)"},
      {"×", "'*' for the geometric product, or commutator(A, B)"},
      {"−", "'-'"},
      {"²", "A*A for a square"},
      {"³", "A*A*A for a cube"},
      {"†", "rev(A) or ~A for the reverse"},
      {"√", "'sqrt(KIND)' as a kernel of its own"},
      {"=", "'==' to compare"},
      {"!", "'not', or '!=' to compare"},
      {"?", "'if c then a else b'"},
      {"**", "A*A for a square"},
      {"&&", "'and'"},
      {"||", "'or'"},
      {"≤", "'<='"},
      {"≥", "'>='"},
  }};
  return written(table, symbol);
}

std::string hint_for_function(const std::string &name) {
  static constexpr std::array<row, 26> table{{
      {"reverse", "rev(A) or ~A"},
      {"wedge", "A ^ B for the outer product"},
      {"outer", "A ^ B for the outer product"},
      {"op", "A ^ B for the outer product"},
      {"inner", "A | B for the left contraction, or dot(A, B)"},
      {"ip", "A | B for the left contraction, or dot(A, B)"},
      {"lcont", "A | B for the left contraction"},
      {"gp", "A * B for the geometric product"},
      {"geometric", "A * B for the geometric product"},
      {"vee", "A & B for the regressive product"},
      {"join", "A & B or A ^ B, whichever joins in this algebra"},
      {"normalize", "'normalise(KIND)' as a kernel of its own"},
      {"normalized", "'normalise(KIND)' as a kernel of its own"},
      {"conjugate", "conj(A)"},
      {"complement", "rc(A) or lc(A)"},
      {"inv", "inverse(A)"},
      {"pow", "A*A for a square"},
      {"square", "A*A"},
      {"reflection", "reflect(X, p)"},
      {"projection", "project(X, Y)"},
      {"grades", "grade(A, k)"},
      {"real", "scalar(A)"},
      {"abs", no_choice},
      {"min", no_choice},
      {"max", no_choice},
      {"clamp", no_choice},
  }};
  return written(table, name);
}

std::string hint_for_name(const algebra &a, const std::string &name) {
  if (name == "true" || name == "false")
    return "; a truth is a comparison, as in 's > 0'";
  // e14 where there is no e4: the letters of a declared vector, with digits that none has.
  const std::size_t digits = std::min(name.find_first_of("0123456789"), name.size());
  if (digits == 0 || digits + 1 >= name.size() || name.find_first_not_of("0123456789", digits) != std::string::npos)
    return "";
  const auto declared = [&](const std::string &v) {
    return std::find(a.vectors.begin(), a.vectors.end(), v) != a.vectors.end() ||
           std::any_of(a.null.begin(), a.null.end(), [&](const named_expr &n) { return n.name == v; });
  };
  std::string missing;
  bool any = false;
  for (std::size_t i = digits; i < name.size(); ++i) {
    const std::string v = name.substr(0, digits) + name[i];
    any = any || declared(v);
    if (!declared(v) && missing.empty())
      missing = v;
  }
  return any && !missing.empty()
             ? fmt::format("; as a basis blade it needs '{}', and the vectors are {}", missing, join(a.vectors, ", "))
             : "";
}

} // namespace meetc::lang
