// The table of kinds and predicates for a runtime, and the same predicates as CUDA kernels.
#include "gen/emit/bounds.hpp"
#include "gen/emit/cpp.hpp"
#include "gen/emit/names.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace meetc::emit {
namespace {

std::vector<const dag::kernel *> predicates_of(const unit &u) {
  std::vector<const dag::kernel *> out;
  for (const dag::kernel &k : u.kernels)
    if (k.is_predicate && !k.is_sign)
      out.push_back(&k);
  return out;
}

std::vector<const spec::kind *> element_kinds(const unit &u) {
  std::vector<const spec::kind *> out;
  for (const spec::kind &k : u.model.spec().kinds)
    for (const dag::kernel *p : predicates_of(u))
      if (std::find(p->asked.kinds.begin(), p->asked.kinds.end(), &k) != p->asked.kinds.end()) {
        out.push_back(&k);
        break;
      }
  return out;
}

// The CSV header: axes alone where there is one point, numbered where there are more.
std::string csv_names(const decide::kind_layout &layout) {
  std::vector<std::string> names;
  for (const decide::stored_real &r : layout.reals) {
    const std::string last = r.path.substr(r.path.find_last_of('.') + 1);
    if (r.position)
      names.push_back(layout.points > 1 ? last + std::to_string(r.group) : last);
    else
      names.push_back(r.group < 0 ? last : r.path);
  }
  for (std::string &n : names)
    std::replace(n.begin(), n.end(), '.', '_');
  return join(names, ",");
}

std::string box_text(const dag::enclosure &e, const std::string &kind) {
  std::string out = fmt::format("void {}_box(const float *row, float lo[3], float hi[3]) {{\n", kind);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::string lo, hi;
    for (const std::vector<int> &point : e.hull) {
      const std::string value = axis < point.size() ? fmt::format("row[{}]", point[axis]) : "0.0f";
      lo = lo.empty() ? value : fmt::format("least({}, {})", lo, value);
      hi = hi.empty() ? value : fmt::format("most({}, {})", hi, value);
    }
    if (e.pad >= 0) {
      // One rounding, then one step outwards: never too small.
      lo = fmt::format("::meet::step_down({} - row[{}])", lo, e.pad);
      hi = fmt::format("::meet::step_up({} + row[{}])", hi, e.pad);
    }
    out += fmt::format("  lo[{0}] = {1};\n  hi[{0}] = {2};\n", axis, lo, hi);
  }
  return out + "}\n";
}

std::string kind_entry(const unit &u, const spec::kind &k, const dag::enclosure &e) {
  const decide::kind_layout layout = u.model.layout(k);
  const bool points_only = std::all_of(layout.reals.begin(), layout.reals.end(), [](const auto &r) { return r.position; });
  return fmt::format("  {{\"{}\", \"{}\", {}, {}_roles, {}, {}_box, {}}},\n", k.name, csv_names(layout),
                     layout.reals.size(), identifier(k.name), points_only ? layout.points : 0, identifier(k.name),
                     e.rule_input >= 0 ? identifier(k.name) + "_fault" : "nullptr");
}

std::string kind_functions(const unit &u, const spec::kind &k, const dag::enclosure &e) {
  const std::string name = identifier(k.name);
  std::vector<std::string> roles;
  int i = 0;
  for (const decide::stored_real &r : u.model.layout(k).reals) {
    static const char *const axes[] = {"x", "y", "z"};
    roles.push_back(fmt::format("::meet::role::{}", r.position && r.axis < 3 ? axes[r.axis] : i == e.pad ? "length" : "other"));
    ++i;
  }
  std::string out = fmt::format("const ::meet::role {}_roles[] = {{{}}};\n", name, join(roles, ", "));
  out += box_text(e, name);
  if (e.rule_input >= 0)
    out += fmt::format("const char *{}_fault(const float *row) {{ return row[{}] {} ? nullptr : \"{}\"; }}\n", name,
                       e.rule_input, e.rule, e.rule_text);
  return out + "\n";
}

} // namespace

std::string runtime_header(const unit &u) {
  return banner(u.scene, "What a runtime needs to know of this namespace.") + open_header(u.scene, "file_runtime") +
         "// The bounded kinds and the predicates on them.\nconst ::meet::catalogue &catalogue();\n" + close_header(u.scene);
}

namespace {
// The box as the least float32 that is not below it.
std::string box_literal(double box) { return hex_literal(bound::rounded_up(dag::rational(box), 24), "f"); }
} // namespace

std::string runtime_source(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, "The table of kinds and predicates.");
  out += fmt::format("#include <{0}/{0}_runtime.hpp>\n", space);
  for (const dag::kernel *k : predicates_of(u))
    out += fmt::format("#include <{}/{}.hpp>\n", space, k->asked.name());
  out += fmt::format("\nnamespace {} {{\nnamespace {{\n\n", space);
  const auto kinds = element_kinds(u);
  std::string entries, functions;
  for (const spec::kind *k : kinds) {
    const dag::enclosure e = dag::enclosing(u.model, *k);
    if (e.hull.empty())
      throw spec_error(k->where, fmt::format("kind '{}' stands in a predicate and so needs a 'hull'", k->name));
    functions += kind_functions(u, *k, e);
    entries += kind_entry(u, *k, e);
  }
  if (!kinds.empty())
    out += "[[maybe_unused]] float least(float a, float b) { return b < a ? b : a; }\n"
           "[[maybe_unused]] float most(float a, float b) { return a < b ? b : a; }\n\n" +
           functions + "const ::meet::kind_info all_kinds[] = {\n" + entries + "};\n\n";
  std::string rows;
  for (const dag::kernel *k : predicates_of(u)) {
    const auto place = [&](std::size_t i) {
      return std::find(kinds.begin(), kinds.end(), k->asked.kinds[i]) - kinds.begin();
    };
    const std::string name = identifier(k->asked.asked->name);
    const auto rung = [&](const char *r, const std::string &function) { return u.asks(r) ? function : "nullptr"; };
    const auto bounded = [&](const char *a) {
      return rung("certified", fmt::format("::meet::certify_pairs<{}, ::meet::in_{}>", name, a));
    };
    rows += fmt::format("  {{\"{}\", \"{}\", &all_kinds[{}], &all_kinds[{}],\n   {{{}, {}, {}, {}, {}}},\n", k->asked.asked->name,
                        k->asked.asked->mode, place(0), place(1),
                        rung("fp32", fmt::format("::meet::decide_plain<{}, float>", name)),
                        rung("fp64", fmt::format("::meet::decide_plain<{}, double>", name)),
                        rung("fp64x2", fmt::format("::meet::decide_plain<{}, ::meet::double_double>", name)),
                        u.asks("certified") || u.asks("exact") ? fmt::format("::meet::decide_exact<{}>", name) : "nullptr",
                        rung("certified", fmt::format("::meet::decide_certified<{}>", name)));
    rows += fmt::format("   {{{}, {}, {}}},\n   {}, {}, {}}},\n", bounded("fp32"), bounded("fp64"), bounded("fp64x2"),
                        rung("certified", fmt::format("::meet::certify_pairs_in_box<{}>", name)),
                        u.asks("certified") ? fmt::format("::meet::least_box<{}>()", name) : "0",
                        u.asks("certified") ? fmt::format("::meet::most_box<{}>()", name) : "0");
  }
  if (!rows.empty())
    out += "const ::meet::predicate_info all_predicates[] = {\n" + rows + "};\n\n";
  out += fmt::format("}} // namespace\n\nconst ::meet::catalogue &catalogue() {{\n  static const ::meet::catalogue c{{\"{}\", {}, "
                     "{}, {}, {}, {}}};\n  return c;\n}}\n\n}} // namespace {}\n",
                     u.scene.space, kinds.empty() ? "nullptr" : "all_kinds", kinds.size(),
                     rows.empty() ? "nullptr" : "all_predicates", predicates_of(u).size(), box_literal(u.scene.box), space);
  return out;
}

std::string cuda_header(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, "Launchers on a CUDA device.");
  out += fmt::format("#ifndef MEETC_{0}_cuda_HPP\n#define MEETC_{0}_cuda_HPP\n\n#include <cuda_runtime_api.h>\n"
                     "#include <meet/support.hpp>\n\nnamespace {0} {{\nnamespace cuda {{\n\n",
                     space);
  out += "// Decides n pairs of rows on the device: a, b, pairs and out are device pointers, rows are packed floats in\n"
         "// the spec's store order. Enqueued on the stream: allocates nothing, waits for nothing, throws nothing.\n"
         "// Answers are the CPU's, bit for bit. certify() runs one bounded rung of `certified` (fp32, fp64, fp64x2), which may\n"
         "// answer unsure. An unknown rung gives cudaErrorInvalidValue.\n";
  if (u.asks("certified"))
    out += "// Bits of meet::arithmetic_fault in *faults, device memory: whether the arithmetic here is as the bounds assume. Once a\n"
           "// process is enough, before the first certified answer is relied upon.\n"
           "cudaError_t self_test(unsigned *faults, cudaStream_t stream);\n";
  for (const dag::kernel *k : predicates_of(u))
    out += fmt::format("struct {} {{\n  static cudaError_t decide(::meet::rung rung, const float *a, const float *b, const "
                       "::meet::index_pair *pairs,\n                            std::size_t n, ::meet::answer *out, "
                       "cudaStream_t stream);\n{}}};\n",
                       identifier(k->asked.asked->name),
                       u.asks("certified") ? "  static cudaError_t certify(::meet::rung rung, const float *a, const float *b, const "
                                             "::meet::index_pair *pairs,\n                             std::size_t n, "
                                             "::meet::answer *out, cudaStream_t stream);\n"
                                           : "");
  return out + fmt::format("\n}} // namespace cuda\n}} // namespace {}\n\n#endif\n", space);
}

std::string cuda_text(const unit &u) { return cuda_source(u); }

std::string cuda_source(const unit &u) {
  const std::string space = identifier(u.scene.space);
  const bool asks_exact = u.asks("exact") || u.asks("certified");
  std::string out = banner(u.scene, "Launchers on a CUDA device.");
  out += fmt::format("#include <{0}/{0}_cuda.hpp>\n", space);
  for (const dag::kernel *k : predicates_of(u))
    out += fmt::format("#include <{}/{}.hpp>\n", space, k->asked.name());
  out += R"(
namespace {

constexpr int block = 128;

template <class P, class Decide>
__global__ void __launch_bounds__(block) decide_kernel(const float *a, const float *b, const ::meet::index_pair *pairs,
                                                       std::size_t n, ::meet::answer *out) {
  const std::size_t i = std::size_t{blockIdx.x} * block + threadIdx.x;
  if (i < n)
    out[i] = Decide::of(a + std::size_t{pairs[i].a} * P::inputs_a, b + std::size_t{pairs[i].b} * P::inputs_b);
}

template <class P, class T> struct plain {
  __device__ static ::meet::answer of(const float *a, const float *b) {
    return ::meet::to_answer(::meet::decide<P>(::meet::plain_signs<P, T>(a, b)));
  }
};
)";
  if (asks_exact)
    out += R"(template <class P> struct exact {
  __device__ static ::meet::answer of(const float *a, const float *b) {
    return ::meet::to_answer(::meet::decide<P>(::meet::exact_signs<P>(a, b)));
  }
};
)";
  if (u.asks("certified"))
    out += R"(template <class P, class A> struct bounded {
  __device__ static ::meet::answer of(const float *a, const float *b) { return ::meet::certify<P, A>(a, b); }
};
template <class P> struct certified {
  __device__ static ::meet::answer of(const float *a, const float *b) {
    return ::meet::to_answer(::meet::decide_certified<P>(a, b));
  }
};
)";
  out += R"(
template <class P, class Decide>
cudaError_t launch(const float *a, const float *b, const ::meet::index_pair *pairs, std::size_t n, ::meet::answer *out,
                   cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const std::size_t blocks = (n + block - 1) / block;
  if (blocks > 0x7fffffff)
    return cudaErrorInvalidValue;
  decide_kernel<P, Decide><<<static_cast<unsigned>(blocks), block, 0, stream>>>(a, b, pairs, n, out);
  return cudaGetLastError();
}

)";
  const auto rungs_function = [&](const char *name, const std::vector<std::pair<const char *, const char *>> &cases) {
    out += fmt::format("template <class P>\ncudaError_t {}(::meet::rung rung, const float *a, const float *b, const "
                       "::meet::index_pair *pairs, std::size_t n,\n    ::meet::answer *out, cudaStream_t stream) {{\n  "
                       "switch (rung) {{\n",
                       name);
    for (const auto &[r, decide] : cases)
      out += fmt::format("  case ::meet::rung::{}:\n    return launch<P, {}>(a, b, pairs, n, out, stream);\n", r, decide);
    out += "  default:\n    return cudaErrorInvalidValue;\n  }\n}\n";
  };
  std::vector<std::pair<const char *, const char *>> cases;
  if (u.asks("fp32"))
    cases.emplace_back("fp32", "plain<P, float>");
  if (u.asks("fp64"))
    cases.emplace_back("fp64", "plain<P, double>");
  if (u.asks("fp64x2"))
    cases.emplace_back("fp64x2", "plain<P, ::meet::double_double>");
  if (asks_exact)
    cases.emplace_back("exact", "exact<P>");
  if (u.asks("certified"))
    cases.emplace_back("certified", "certified<P>");
  rungs_function("decide_by", cases);
  if (u.asks("certified"))
    rungs_function("certify_by", {{"fp32", "bounded<P, ::meet::in_fp32>"},
                                  {"fp64", "bounded<P, ::meet::in_fp64>"},
                                  {"fp64x2", "bounded<P, ::meet::in_fp64x2>"}});
  out += fmt::format("\n}} // namespace\n\nnamespace {} {{\nnamespace cuda {{\n\n", space);
  if (u.asks("certified"))
    out += "cudaError_t self_test(unsigned *faults, cudaStream_t stream) { return ::meet::launch_self_test(faults, stream); "
           "}\n\n";
  for (const dag::kernel *k : predicates_of(u))
    for (const char *function : {"decide", "certify"})
      if (function == std::string("decide") || u.asks("certified"))
        out += fmt::format("cudaError_t {0}::{2}(::meet::rung rung, const float *a, const float *b, const ::meet::index_pair "
                           "*pairs,\n    std::size_t n, ::meet::answer *out, cudaStream_t stream) {{\n"
                           "  return {2}_by<::{1}::{0}>(rung, a, b, pairs, n, out, stream);\n}}\n",
                           identifier(k->asked.asked->name), space, function);
  return out + fmt::format("\n}} // namespace cuda\n}} // namespace {}\n", space);
}

} // namespace meetc::emit
