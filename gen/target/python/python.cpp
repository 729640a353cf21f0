#include "gen/target/python/python.hpp"

#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <fmt/format.h>
#include <set>

namespace meetc::target {
namespace {

std::string constant(const ir::rational &q) {
  const std::string size = mpz_class(abs(q.get_num())).get_str();
  const std::string text = q.get_den() == 1 ? size + ".0" : fmt::format("({}.0 / {}.0)", size, q.get_den().get_str());
  return q < 0 ? fmt::format("(-{})", text) : text;
}

// t0, b1 and the like, which functions use for values.
bool numbered(const std::string &id) {
  return id.size() > 1 && (id[0] == 't' || id[0] == 'b') && id.find_first_not_of("0123456789", 1) == std::string::npos;
}

constexpr const char *opening = R"(
from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

# Numbers, or arrays of shapes that broadcast. A union would make a checker of types try all combinations in a sum.
Numbers = Any


def _columns(rows: NDArray[np.floating[Any]], numbers: int, kind: str) -> list[NDArray[np.floating[Any]]]:
    rows = np.asarray(rows)
    if rows.ndim == 0 or rows.shape[-1] != numbers:
        raise ValueError(f"a row of {kind} has {numbers} numbers, and the array has the shape {rows.shape}")
    return [rows[..., i] for i in range(numbers)]


def _rows(columns: list[Numbers]) -> NDArray[np.floating[Any]]:
    return np.stack(np.broadcast_arrays(*columns), axis=-1)
)";

} // namespace

std::string python_name(const std::string &name) {
  static const std::set<std::string> taken{
      "False", "None",   "True", "as",     "assert", "async", "await", "def",   "del",  "elif",     "except", "finally",
      "from",  "global", "is",   "lambda", "in",     "np",    "pass",  "raise", "with", "nonlocal", "yield",  "Any"};
  const std::string id = identifier(name);
  return taken.count(id) ? id + '_' : id[0] == '_' ? 'm' + id : id;
}

std::string python_operand(const unit &u, const std::string &name) {
  const std::string id = python_name(name);
  const bool is_kind = std::any_of(u.kinds.begin(), u.kinds.end(), [&](const lower::lowered_kind &k) {
    return id == python_name(k.name) || id == python_name(k.name + "_blade");
  });
  return is_kind || numbered(id) || id == "sign" || id == "Numbers" ? id + "_operand" : id;
}

std::string python_member(const std::string &name) {
  const std::string id = python_name(name);
  return id == "rows" || id == "from_rows" ? id + '_' : id;
}

std::string python_path(const std::string &path) {
  std::string out;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    out += (out.empty() ? "" : ".") + python_member(path.substr(from, dot - from));
    from = dot + 1;
  }
  return out;
}

statements::text python_body(const ir::program &p, const std::function<std::string(int)> &input) {
  syntax s{.type = "", .fma = "", .constant = constant, .input = input, .indent = "    "};
  s.keep = [](const std::string &name, const std::string &value) { return fmt::format("{} = {}", name, value); };
  s.local = python_name;
  return statements::of(p, s);
}

std::string python_text(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  return k.is_predicate ? python_decision(u, k) : python_formula(u, k);
}

std::vector<file> python_files(const unit &u) {
  std::string text = banner(u.scene, "Formulas, signs and plain predicates of NumPy arrays.", "#");
  text += opening + python_kinds(u);
  for (std::size_t i = 0; i < u.kernels.size(); ++i)
    text += python_text(u, i);
  const std::string space = identifier(u.scene.space);
  return {{space + '/' + space + ".py", text}};
}

} // namespace meetc::target
