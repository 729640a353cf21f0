// The table of targets.
#include "gen/target/c/c.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cuda/cuda.hpp"
#include "gen/target/every_pair/every_pair.hpp"
#include "gen/target/gappa/gappa.hpp"
#include "gen/target/json/json.hpp"
#include "gen/target/latex/latex.hpp"
#include "gen/target/python/python.hpp"
#include "gen/target/shader/shader.hpp"
#include "gen/target/text/text.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>
#include <string_view>

namespace meetc::target {
namespace {

constexpr carries everything{true, true, true, true, true, true, true};
constexpr carries on_the_host{true, true, true, true, true, false, true};
constexpr carries in_c{true, true, true, true, false, false, true};
constexpr carries plain_ones{true, true, true, false, false, false, false};
constexpr carries decided{false, true, true, true, true, false, false};
constexpr carries to_read{true, true, false, false, false, false, false};

// The code, the headers that it includes, and the proofs of the bounds that it assumes.
std::vector<file> proved_cpp_files(const unit &u) {
  std::vector<file> out = cpp_files(u);
  for (file &f : kernel_headers())
    out.push_back(std::move(f));
  if (u.asks(lang::rung::certified))
    for (file &f : proof_files(u))
      out.push_back(std::move(f));
  return out;
}

constexpr target table[] = {
    {.name = "poly", .what = "the polynomials, expanded", .can = to_read, .reads_polynomials = true, .show = poly_text},
    {.name = "separate",
     .what = "sums of products f(X) g(Y)",
     .can = to_read,
     .reads_polynomials = true,
     .show = separate_text,
     .show_all = separate_table},
    {.name = "dag", .what = "the programs as graphs, one node a line", .can = to_read, .show = graph_text},
    {.name = "schedule",
     .what = "the programs as statements, in the order in which they are emitted",
     .can = to_read,
     .show = schedule_text},
    {.name = "counts",
     .what = "multiplications/additions of the programs: all, those on one object alone, and those for the pair",
     .can = to_read,
     .show = counts_text,
     .show_all = counts_table},
    {.name = "bounds", .what = "the error bounds of signs as a table", .can = decided, .show = bounds_table},
    {.name = "gappa", .what = "scripts that Gappa proves the bounds with", .can = decided, .show = show_proofs},
    {.name = "json", .what = "polynomials for other programs", .can = to_read, .reads_polynomials = true, .show = json},
    {.name = "latex", .what = "polynomials for papers", .can = to_read, .reads_polynomials = true, .show = latex},
    {.name = "cpp",
     .what = "C++20 headers for host and device, and the generated library",
     .can = on_the_host,
     .numbers = "any",
     .bits = "with FMA, without",
     .is_default = true,
     .files = proved_cpp_files,
     .source = "_runtime.cpp",
     .show = cpp_text,
     .show_analytic = analytic_text},
    {.name = "c",
     .what = "C99 formulas, signs and plain predicates, and certified ones with C linkage",
     .can = in_c,
     .numbers = "float, double",
     .bits = "as cpp",
     .files = c_files,
     .over = "cpp",
     .source = "_c.cpp",
     .show = c_text,
     .show_analytic = c_analytic_text},
    {.name = "python",
     .what = "formulas, signs and plain predicates of NumPy arrays",
     .can = plain_ones,
     .numbers = "of the arrays",
     .bits = "as cpp without FMA",
     .files = python_files,
     .source = ".py",
     .show = python_text},
    {.name = "glsl",
     .what = "formulas, signs and plain predicates for shaders of GLSL, in float32",
     .can = plain_ones,
     .numbers = "float32",
     .bits = "as cpp without FMA",
     .files = glsl_files,
     .source = ".glsl",
     .show = glsl_text},
    {.name = "wgsl",
     .what = "the same for shaders of WGSL",
     .can = plain_ones,
     .numbers = "float32",
     .bits = "none",
     .files = wgsl_files,
     .source = ".wgsl",
     .show = wgsl_text},
    {.name = "cuda",
     .what = "launchers on a CUDA device",
     .can = everything,
     .numbers = "as cpp",
     .bits = "as cpp with FMA",
     .is_default = true,
     .files = cuda_files,
     .over = "cpp",
     .source = "_cuda.cu",
     .show = cuda_text},
    {.name = "every_pair",
     .what = "every pair of two sets as a product of matrices, on a CUDA device",
     .can = everything,
     .numbers = "as cpp",
     .bits = "as cpp with FMA",
     .files = every_pair_files,
     .over = "cuda",
     .source = "_every_pair.cu"},
};

} // namespace

std::span<const target> all() {
  return table;
}

std::string list_of_targets() {
  const auto row = [](const std::array<std::string, 9> &cells) {
    static constexpr std::array widths{10, 13, 8, 9, 5, 9, 8, 9, 0};
    std::string out;
    for (std::size_t i = 0; i < cells.size(); ++i)
      out += fmt::format("{:<{}}{}", cells[i], widths[i], i + 1 < cells.size() ? "  " : "\n");
    return out;
  };
  std::string out = row({"target", "numbers", "formulas", "gives,exp", "plain", "certified", "tolerant", "launchers",
                         "bits of formulas"});
  for (const target &t : table)
    if (t.files) {
      const auto yes = [](bool can) { return std::string(can ? "yes" : "-"); };
      out += row({t.name, t.numbers, yes(t.can.formulas), yes(t.can.analytic), yes(t.can.plain), yes(t.can.certified),
                  yes(t.can.tolerant), yes(t.can.launchers), t.bits});
    }
  return out;
}

const target *find(const std::string &name) {
  const auto at = std::find_if(std::begin(table), std::end(table), [&](const target &t) { return name == t.name; });
  return at == std::end(table) ? nullptr : at;
}

lang::backend_choice backends() {
  lang::backend_choice out;
  for (const target &t : table) {
    if (t.files)
      out.known.emplace_back(t.name);
    if (t.is_default)
      out.unless_said.emplace_back(t.name);
  }
  return out;
}

const lower::lowered_kind &unit::kind(const std::string &name) const {
  const auto at =
      std::find_if(kinds.begin(), kinds.end(), [&](const lower::lowered_kind &k) { return k.name == name; });
  if (at == kinds.end())
    throw std::logic_error("a target reads a kind that no kernel needs");
  return *at;
}

namespace {
// Whether a target is the one of this name, or one whose files that one includes.
bool is_under(const target &t, const std::string &name) {
  for (const target *at = find(name); at; at = at->over ? find(at->over) : nullptr)
    if (at == &t)
      return true;
  return false;
}

// Throws an error if the scene asks for something that the target cannot carry.
void check_carried(const target &t, const unit &u) {
  const auto refuse = [&](const lower::kernel &k, const char *what) {
    throw spec_error(k.asked.where, fmt::format("the backend '{}' carries no {}, and the scene asks for '{}'", t.name,
                                                what, k.asked.text));
  };
  for (const lower::analytic_kernel &k : u.analytic)
    if (!t.can.analytic)
      throw spec_error(k.where,
                       fmt::format("the backend '{}' carries no functions but polynomials, and the scene asks for "
                                   "'{}'",
                                   t.name, k.text));
  for (const lower::kernel &k : u.kernels) {
    if (!k.is_predicate && !t.can.formulas)
      refuse(k, "formulas");
    if (k.is_sign && !t.can.signs)
      refuse(k, "signs");
    if (k.is_predicate && !k.is_sign && !t.can.plain)
      refuse(k, "predicates");
    if (k.is_predicate && u.asks(lang::rung::certified) && !t.can.certified)
      refuse(k, "certified answers");
    if (k.is_predicate && u.asks(lang::rung::exact) && !t.can.certified)
      refuse(k, "exact answers");
    if (k.is_predicate && u.asks(lang::rung::tolerant) && !t.can.tolerant)
      refuse(k, "answers within a tolerance");
  }
}
} // namespace

namespace {
// The place of the kernel after which a file is named, or of the first one.
location place_of(const unit &u, const std::string &path) {
  for (const lower::kernel &k : u.kernels)
    if (path == fmt::format("{0}/{0}.hpp", k.asked.name()) || path.ends_with('/' + k.asked.name() + ".hpp"))
      return k.asked.where;
  return u.kernels.empty() ? location{} : u.kernels.front().asked.where;
}
} // namespace

std::vector<file> files_of(const unit &u) {
  const auto is_asked = [&](const target &t) {
    return t.files && std::any_of(u.scene.backends.begin(), u.scene.backends.end(),
                                  [&](const std::string &name) { return is_under(t, name); });
  };
  std::vector<file> out;
  for (const target &t : table)
    if (is_asked(t)) {
      check_carried(t, u);
      for (file &f : t.files(u))
        out.push_back(std::move(f));
    }
  std::sort(out.begin(), out.end(), [](const file &a, const file &b) { return a.path < b.path; });
  for (std::size_t i = 1; i < out.size(); ++i)
    if (out[i].path == out[i - 1].path)
      throw spec_error(place_of(u, out[i].path),
                       fmt::format("'{}' would be written twice: a kernel has the name of the namespace or of a file "
                                   "that every namespace has; rename one",
                                   out[i].path));
  return out;
}

} // namespace meetc::target
