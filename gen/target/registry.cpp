// The one table of targets.
#include "gen/target/c/c.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cuda/cuda.hpp"
#include "gen/target/gappa/gappa.hpp"
#include "gen/target/json/json.hpp"
#include "gen/target/latex/latex.hpp"
#include "gen/target/text/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

namespace meetc::target {
namespace {

constexpr carries everything{true, true, true, true, true};
constexpr carries on_the_host{true, true, true, true, false};
constexpr carries decided{false, true, true, true, false};
constexpr carries to_read{true, true, false, false, false};

constexpr target table[] = {
    {"poly", "the polynomials, expanded", to_read, nullptr, false, nullptr, poly_text},
    {"separate", "sums of products f(X) g(Y)", to_read, nullptr, false, nullptr, separate_text},
    {"dag", "the programs as graphs, one node a line", to_read, nullptr, false, nullptr, graph_text},
    {"schedule", "the programs as statements, in the order in which they are emitted", to_read, nullptr, false, nullptr,
     schedule_text},
    {"bounds", "the error bounds of signs as a table", decided, nullptr, false, nullptr, bounds_table},
    {"gappa", "scripts that Gappa proves the bounds with", decided, nullptr, false, nullptr, show_proofs},
    {"json", "polynomials for other programs", to_read, nullptr, false, nullptr, json},
    {"latex", "polynomials for papers", to_read, nullptr, false, nullptr, latex},
    {"cpp", "C++20 headers for host and device, and the generated library", on_the_host, cpp_files, true, nullptr,
     cpp_text},
    {"c", "C99 formulas, signs and plain predicates, and certified ones with C linkage", on_the_host, c_files, false,
     "cpp", c_text},
    {"cuda", "launchers on a CUDA device", everything, cuda_files, true, "cpp", cuda_text},
};

} // namespace

std::span<const target> all() {
  return table;
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

namespace {
// What a target cannot carry is an error that says so.
void check_carried(const target &t, const unit &u) {
  const auto refuse = [&](const lower::kernel &k, const char *what) {
    throw spec_error(k.asked.where, fmt::format("the backend '{}' carries no {}, and the scene asks for '{}'", t.name,
                                                what, k.asked.text));
  };
  for (const lower::kernel &k : u.kernels) {
    if (!k.is_predicate && !t.can.formulas)
      refuse(k, "formulas");
    if (k.is_sign && !t.can.signs)
      refuse(k, "signs");
    if (k.is_predicate && !k.is_sign && !t.can.plain)
      refuse(k, "predicates");
    if (k.is_predicate && u.asks(lang::rung::certified) && !t.can.certified)
      refuse(k, "certified answers");
  }
}
} // namespace

std::vector<file> files_of(const unit &u) {
  const auto is_asked = [&](const target &t) {
    return t.files && std::any_of(u.scene.backends.begin(), u.scene.backends.end(), [&](const std::string &name) {
             return name == t.name || (find(name)->over && find(name)->over == std::string_view(t.name));
           });
  };
  std::vector<file> out = kernel_headers();
  for (const target &t : table)
    if (is_asked(t)) {
      check_carried(t, u);
      for (file &f : t.files(u))
        out.push_back(std::move(f));
    }
  std::sort(out.begin(), out.end(), [](const file &a, const file &b) { return a.path < b.path; });
  for (std::size_t i = 1; i < out.size(); ++i)
    if (out[i].path == out[i - 1].path)
      throw spec_error({},
                       fmt::format("'{}' would be written twice: a kernel has the name of the namespace or of a file "
                                   "that every namespace has; rename one",
                                   out[i].path));
  return out;
}

bool unit::asks(const char *rung) const {
  return std::any_of(scene.rungs.begin(), scene.rungs.end(), [&](lang::rung r) {
    return std::string_view(lang::rungs[static_cast<std::size_t>(r)].name) == rung;
  });
}

bool unit::has_backend(const char *backend) const {
  return std::find(scene.backends.begin(), scene.backends.end(), backend) != scene.backends.end();
}

} // namespace meetc::target
