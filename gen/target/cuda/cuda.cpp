// The predicates on a CUDA device: launchers that decide lists of pairs, and the catalogue through which a runtime runs
// all-pairs queries. The kernels themselves are templates in runtime/kernel/meetc/cuda_*.hpp.
#include "gen/target/cuda/cuda.hpp"

#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/gappa/gappa.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

// A rung and what runs it.
using rung_case = std::pair<const char *, const char *>;

std::vector<rung_case> plain_cases(const unit &u) {
  static const rung_case all[] = {{"fp32", "plain_step<P, float>"},
                                  {"fp64", "plain_step<P, double>"},
                                  {"fp64x2", "plain_step<P, ::meetc::double_double>"},
                                  {"exact", "exact_step<P>"},
                                  {"certified", "certified_step<P>"}};
  std::vector<rung_case> out;
  for (const rung_case &c : all)
    if (u.asks(c.first) || (c.first == std::string("exact") && u.asks("certified")))
      out.push_back(c);
  return out;
}

std::string rungs_function(const char *name, const std::vector<rung_case> &cases) {
  std::string out =
      fmt::format("template <class P>\ncudaError_t {}(::meetc::rung rung, const float *a, const float *b, const "
                  "::meetc::index_pair *pairs, std::size_t n,\n    ::meetc::answer *out, cudaStream_t stream) {{\n"
                  "  using namespace ::meetc::cuda;\n  switch (rung) {{\n",
                  name);
  for (const auto &[r, step] : cases)
    out += fmt::format("  case ::meetc::rung::{}:\n    return answer_list<P, {}>(a, b, pairs, n, out, stream);\n", r,
                       step);
  return out + "  default:\n    return cudaErrorInvalidValue;\n  }\n}\n";
}

constexpr const char *parameters =
    "(::meetc::rung rung, const float *a, const float *b, const ::meetc::index_pair *pairs,\n"
    "    std::size_t n, ::meetc::answer *out, cudaStream_t stream)";

std::string catalogue_text(const unit &u) {
  const auto kinds = element_kinds(u);
  std::string rungs,
      out = "namespace {\n\nusing form = ball_form;\n\nconst ::meetc::cuda::kind_launchers all_kinds[] = {\n";
  for (const lang::kind *k : kinds) {
    const std::string shape = identifier(k->name) + "_shape";
    out += fmt::format("  {{\"{0}\", {1}::fields, ::meetc::cuda::place<{1}>, ::meetc::cuda::enclose<{1}>, "
                       "::meetc::cuda::columns<{1}, form>}},\n",
                       k->name, shape);
  }
  for (const char *r : {"fp32", "fp64", "fp64x2", "exact", "certified"})
    if (u.asks(r))
      rungs += fmt::format("{}1U << static_cast<int>(::meetc::rung::{})", rungs.empty() ? "" : " | ", r);
  out += fmt::format(
      "}};\n\nconstexpr unsigned rungs = {};\n\nconst ::meetc::cuda::predicate_launchers all_predicates[] = {{\n",
      rungs);
  std::size_t count = 0;
  for (const lower::kernel *k : predicates_of(u)) {
    const auto place = [&](std::size_t i) {
      return std::find(kinds.begin(), kinds.end(), k->asked.kinds[i]) - kinds.begin();
    };
    const auto shape = [&](std::size_t i) { return identifier(k->asked.kinds[i]->name) + "_shape"; };
    out += fmt::format(
        "  {{\"{0}\", {1}, {2}, ::meetc::cuda::run<::{3}::{4}, {5}, {6}, rungs>, ::meetc::cuda::pairs<::{3}::{4}, "
        "{5}, {6}, form, rungs>, ::meetc::cuda::query_workspace<{5}, {6}>}},\n",
        k->asked.asked->name, place(0), place(1), identifier(u.scene.space), identifier(k->asked.asked->name), shape(0),
        shape(1));
    ++count;
  }
  return out + fmt::format("}};\n\n}} // namespace\n\nconst ::meetc::cuda::catalogue &catalogue() {{\n"
                           "  static const ::meetc::cuda::catalogue c{{\"{}\", all_kinds, {}, all_predicates, {}, "
                           "::meetc::cuda::clear_extent, ::meetc::cuda::candidates<form>, ::meetc::cuda::probe}};\n"
                           "  return c;\n}}\n\n",
                           u.scene.space, kinds.size(), count);
}

} // namespace

std::string cuda_header(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, "Launchers on a CUDA device.");
  out += fmt::format("#ifndef MEETC_{0}_cuda_HPP\n#define MEETC_{0}_cuda_HPP\n\n#include <meetc/cuda_table.hpp>\n"
                     "#include <meetc/support.hpp>\n\nnamespace {0} {{\nnamespace cuda {{\n\n",
                     space);
  out +=
      "// What a runtime needs for queries on sets: every kind and predicate, the filter and the start-up probe.\n"
      "const ::meetc::cuda::catalogue &catalogue();\n\n"
      "// Decides n pairs of rows on the device: a, b, pairs and out are device pointers, rows are packed floats in\n"
      "// the spec's store order. Enqueued on the stream: allocates nothing, waits for nothing, throws nothing.\n"
      "// Answers are the CPU's, bit for bit. certify() runs one bounded rung of `certified` (fp32, fp64, fp64x2), "
      "which may\n"
      "// answer unsure. An unknown rung gives cudaErrorInvalidValue.\n";
  if (u.asks("certified"))
    out += "// Bits of meetc::arithmetic_fault in *faults, device memory: whether the arithmetic here is as the bounds "
           "assume. Once a\n"
           "// process is enough, before the first certified answer is relied upon.\n"
           "cudaError_t self_test(unsigned *faults, cudaStream_t stream);\n";
  for (const lower::kernel *k : predicates_of(u)) {
    out += fmt::format("struct {} {{\n  static cudaError_t decide{};\n", identifier(k->asked.asked->name), parameters);
    if (u.asks("certified"))
      out += fmt::format("  static cudaError_t certify{};\n", parameters);
    out += "};\n";
  }
  return out + fmt::format("\n}} // namespace cuda\n}} // namespace {}\n\n#endif\n", space);
}

namespace {
std::string launchers_text(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, "Launchers on a CUDA device.");
  out += fmt::format("#include <{0}/{0}_cuda.hpp>\n#include <{0}/ball_form.hpp>\n#include <{0}/shapes.hpp>\n", space);
  for (const lower::kernel *k : predicates_of(u))
    out += fmt::format("#include <{}/{}.hpp>\n", space, k->asked.name());
  out += "#include <meetc/cuda_probe.hpp>\n#include <meetc/cuda_query.hpp>\n\nnamespace {\n\n";
  out += rungs_function("decide_by", plain_cases(u));
  if (u.asks("certified"))
    out += rungs_function("certify_by", {{"fp32", "certify_step<P, ::meetc::in_fp32>"},
                                         {"fp64", "certify_step<P, ::meetc::in_fp64>"},
                                         {"fp64x2", "certify_step<P, ::meetc::in_fp64x2>"}});
  out += fmt::format("\n}} // namespace\n\nnamespace {} {{\nnamespace cuda {{\n\n", space);
  out += catalogue_text(u);
  if (u.asks("certified"))
    out += "cudaError_t self_test(unsigned *faults, cudaStream_t stream) { return ::meetc::launch_self_test(faults, "
           "stream); "
           "}\n\n";
  for (const lower::kernel *k : predicates_of(u))
    for (const char *function : {"decide", "certify"})
      if (function == std::string("decide") || u.asks("certified"))
        out += fmt::format(
            "cudaError_t {0}::{2}{3} {{\n  return {2}_by<::{1}::{0}>(rung, a, b, pairs, n, out, stream);\n}}\n",
            identifier(k->asked.asked->name), space, function, parameters);
  return out + fmt::format("\n}} // namespace cuda\n}} // namespace {}\n", space);
}
} // namespace

std::string cuda_text(const unit &u, std::size_t kernel) {
  if (!u.kernels[kernel].is_predicate || u.kernels[kernel].is_sign)
    throw spec_error({},
                     "only predicates have CUDA launchers; a formula's header (--emit=cpp) is host and device code");
  return launchers_text(u);
}

std::vector<file> cuda_files(const unit &u) {
  const std::string space = identifier(u.scene.space);
  if (predicates_of(u).empty())
    return {}; // nothing to launch
  if (!u.balls)
    throw spec_error({},
                     "the backend 'cuda' filters pairs by the balls around them, and no predicate of the algebra says "
                     "when two balls touch by one sign that separates; import 'primitives/ball.toml', or ask for the "
                     "backend 'cpp' alone");
  std::vector<file> out{{space + "/ball_form.hpp", broken_lines(ball_form_header(u))}};
  out.push_back({space + '/' + space + "_cuda.hpp", broken_lines(cuda_header(u))});
  out.push_back({space + '/' + space + "_cuda.cu", broken_lines(launchers_text(u))});
  if (u.asks(lang::rung::certified))
    for (file &f : filter_proofs(u))
      out.push_back(std::move(f));
  return out;
}

} // namespace meetc::target
