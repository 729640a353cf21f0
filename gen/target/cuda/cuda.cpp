// Predicates and formulas on a CUDA device: a source with launchers for each predicate, one for each kind and one for all
// formulas, and the catalogue through which a runtime runs queries on sets. The kernels themselves are templates in
// runtime/kernel/meetc/cuda.
#include "gen/target/cuda/cuda.hpp"

#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

// The rungs that the scene asks for, as a constant for the launchers' templates.
std::string rungs_constant(const unit &u) {
  std::string bits;
  for (const lang::rung_info &r : lang::rungs)
    if (u.asks(r.id))
      bits += fmt::format("{}1U << static_cast<int>(meetc::rung::{})", bits.empty() ? "" : " |\n    ", r.name);
  return fmt::format("inline constexpr unsigned rungs = {};\n", bits.empty() ? "0" : bits);
}

constexpr const char *parameters = "(meetc::rung rung, const float *a, const float *b, const meetc::index_pair *pairs, "
                                   "std::size_t n, meetc::answer *out, cudaStream_t stream)";

constexpr const char *run_parameters =
    "(meetc::cuda::step which, const float *a, const float *b, meetc::cuda::pair_list in, meetc::cuda::pair_list yes, "
    "meetc::cuda::pair_list left, cudaStream_t stream)";

constexpr const char *first_met_parameters = "(const meetc::cuda::first_met_job &job, cudaStream_t stream)";
constexpr const char *walk_first_parameters = "(const meetc::cuda::first_walk_job &job, cudaStream_t stream)";
constexpr const char *contacts_parameters = "(const meetc::cuda::contact_job &job, cudaStream_t stream)";

std::string shape_of(const std::string &kind) {
  return identifier(kind) + "_shape";
}

// The sign by which a device tells contacts, which are those of triangles and of segments with triangles. Null: it does not.
const lower::kernel *device_contacts_of(const unit &u, const lower::kernel &k) {
  const bool of_ball = k.decision.inputs_a == 4;
  return of_ball ? nullptr : contacts_of(u, k);
}

// Whether there is a walk to what is met first, which decides in fp32 with bounds on the way.
bool walks_first(const unit &u, const lower::kernel &k) {
  return order_of(u, k) && u.asks(lang::rung::certified);
}

std::string catalogue_text(const unit &u) {
  const auto kinds = element_kinds(u);
  const std::size_t formulas = formulas_on_columns(u).size();
  std::string predicates;
  int count = 0;
  for (const lower::kernel *k : predicates_of(u)) {
    const std::string name = identifier(k->asked.asked->name);
    predicates += fmt::format("  {{.name = \"{0}\",\n   .kind_a = {1},\n   .kind_b = {2},\n"
                              "   .pairs = {{.run = {3}::run, .first_met = {4},\n"
                              "             .walk_first = {5}, .contacts = {6}}},\n   .rejects = {7},\n"
                              "   .by_boxes = {8},\n   .by_balls = {9}}},\n",
                              k->asked.asked->name, element_place(kinds, *k, 0), element_place(kinds, *k, 1), name,
                              order_of(u, *k) ? fmt::format("{}::first_met", name) : "nullptr",
                              walks_first(u, *k) ? fmt::format("{}::walk_first", name) : "nullptr",
                              device_contacts_of(u, *k) ? fmt::format("{}::contacts", name) : "nullptr",
                              !k->decision.reject.atoms.empty(), k->decision.by_boxes, k->decision.by_balls);
    ++count;
  }
  std::string out;
  if (count)
    out += "namespace {\n\nconst meetc::cuda::predicate_launchers all_predicates[] = {\n" + predicates +
           "};\n\n} // namespace\n\n";
  out += "const meetc::cuda::catalogue &catalogue() {\n";
  if (!kinds.empty())
    out += "  static const meetc::cuda::set_launchers all_kinds[] = {\n";
  for (const lower::lowered_kind *k : kinds)
    out += fmt::format("    kinds::{}(),\n", identifier(k->name));
  if (!kinds.empty())
    out += "  };\n";
  return out + fmt::format("  static const meetc::cuda::catalogue c{{.kinds = {},\n"
                           "                                        .kind_count = {},\n"
                           "                                        .predicates = {},\n"
                           "                                        .predicate_count = {},\n"
                           "                                        .formulas = {},\n"
                           "                                        .formula_count = {},\n"
                           "                                        .self_test = meetc::launch_self_test}};\n"
                           "  return c;\n}}\n\n",
                           kinds.empty() ? "nullptr" : "all_kinds", kinds.size(), count ? "all_predicates" : "nullptr",
                           count, formulas ? "detail::formulas()" : "nullptr", formulas);
}

} // namespace

std::string cuda_header(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, "Launchers on a CUDA device.");
  out += fmt::format("#ifndef MEETC_{0}_cuda_HPP\n#define MEETC_{0}_cuda_HPP\n\n#include <meetc/cuda/table.hpp>\n"
                     "#include <meetc/support.hpp>\n\nnamespace {0} {{\nnamespace cuda {{\n\n",
                     space);
  out += "// Every kind and predicate, as a runtime needs them for queries on sets.\n"
         "const meetc::cuda::catalogue &catalogue();\n\n";
  if (u.asks(lang::rung::certified))
    out += "// Writes bits of meetc::arithmetic_fault to *faults (device memory): 0 if the arithmetic is as the bounds "
           "assume.\n"
           "// One call in a process is enough, before its first certified answer is used.\n"
           "cudaError_t self_test(unsigned *faults, cudaStream_t stream);\n";
  out += "\n// The rungs that the scene asks for: bit r stands for the rung of value r.\n" + rungs_constant(u);
  out +=
      "\n// One struct for each predicate. decide() decides n pairs of rows: a, b, pairs and out are device pointers, "
      "and\n"
      "// rows are packed floats in the spec's store order. ";
  out += u.asks(lang::rung::certified)
             ? "certify() runs one bounded rung of `certified` (fp32, fp64,\n"
               "// fp64x2), which may answer unsure. The answers equal those of the CPU, bit for bit. An unknown rung "
               "gives\n"
               "// cudaErrorInvalidValue. run() is a step of a query on sets: see\n"
             : "The answers equal those of the CPU, bit for bit. An unknown rung\n"
               "// gives cudaErrorInvalidValue. run() is a step of a query on sets: see\n";
  out += "// meetc::cuda::pair_launchers. They compute anew what sets on a CPU store beside their rows, since the\n"
         "// rows are loaded in any case. All work is enqueued on the stream; nothing is allocated, waited for or "
         "thrown.\n";
  for (const lower::kernel *k : predicates_of(u)) {
    out += fmt::format("struct {} {{\n  static cudaError_t decide{};\n", identifier(k->asked.asked->name), parameters);
    if (u.asks(lang::rung::certified))
      out += fmt::format("  static cudaError_t certify{};\n", parameters);
    out += fmt::format("  static cudaError_t run{};\n", run_parameters);
    if (order_of(u, *k))
      out += fmt::format("  static cudaError_t first_met{};\n", first_met_parameters);
    if (walks_first(u, *k))
      out += fmt::format("  static cudaError_t walk_first{};\n", walk_first_parameters);
    if (device_contacts_of(u, *k))
      out += fmt::format("  static cudaError_t contacts{};\n", contacts_parameters);
    out += "};\n";
  }
  out += "\n// The launchers of each kind, for the catalogue.\nnamespace kinds {\n";
  for (const lower::lowered_kind *k : element_kinds(u))
    out += fmt::format("meetc::cuda::set_launchers {}();\n", identifier(k->name));
  out += "} // namespace kinds\n";
  if (!formulas_on_columns(u).empty())
    out += "\n// The launchers of each formula, for the catalogue.\nnamespace detail {\n"
           "const meetc::cuda::formula_launchers *formulas();\n} // namespace detail\n";
  return out + fmt::format("\n}} // namespace cuda\n}} // namespace {}\n\n#endif\n", space);
}

std::string cuda_catalogue(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, "The catalogue of launchers on a CUDA device.");
  out += fmt::format("#include <{0}/{0}_cuda.hpp>\n#include <meetc/number/self_test.hpp>\n\n"
                     "namespace {0} {{\nnamespace cuda {{\n\n",
                     space);
  out += catalogue_text(u);
  if (u.asks(lang::rung::certified))
    out += "cudaError_t self_test(unsigned *faults, cudaStream_t stream) {\n"
           "  return meetc::launch_self_test(faults, stream);\n}\n";
  return out + fmt::format("\n}} // namespace cuda\n}} // namespace {}\n", space);
}

// A kernel's name holds no dot, so that no predicate's source has this name.
std::string kind_source(const std::string &kind) {
  return "kind." + identifier(kind);
}

std::string cuda_kind(const unit &u, const lower::lowered_kind &k) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, fmt::format("Sets of elements of the kind {} on a CUDA device.", k.name));
  out += fmt::format("#include <{0}/{0}_cuda.hpp>\n#include <{0}/shapes.hpp>\n"
                     "#include <meetc/cuda/arrange.hpp>\n#include <meetc/cuda/cull.hpp>\n"
                     "#include <meetc/cuda/sets.hpp>\n#include <meetc/cuda/tree.hpp>\n\n"
                     "namespace {0} {{\nnamespace cuda {{\nnamespace kinds {{\n\n",
                     space);
  out += fmt::format("meetc::cuda::set_launchers {2}() {{\n"
                     "  return {{.name = \"{0}\",\n"
                     "          .fields = {1}::fields,\n"
                     "          .pose = meetc::cuda::pose_rows<{1}>,\n"
                     "          .instances = meetc::cuda::instances<{1}>,\n"
                     "          .sift = meetc::cuda::sift<{1}>,\n"
                     "          .arrange = meetc::cuda::arrange<{1}>,\n"
                     "          .places = meetc::cuda::places<{1}>,\n"
                     "          .gather = meetc::cuda::gather<{1}>,\n"
                     "          .boxes = meetc::cuda::boxes<{1}>}};\n}}\n",
                     k.name, shape_of(k.name), identifier(k.name));
  return out + fmt::format("\n}} // namespace kinds\n}} // namespace cuda\n}} // namespace {}\n", space);
}

std::string cuda_launchers(const unit &u, const lower::kernel &k) {
  const std::string space = identifier(u.scene.space), name = identifier(k.asked.asked->name);
  std::string out = banner(u.scene, fmt::format("Launchers of {} on a CUDA device.", k.asked.asked->name));
  out += fmt::format("#include <{0}/{0}_cuda.hpp>\n#include <{0}/{1}.hpp>\n"
                     "#include <meetc/cuda/steps.hpp>\n\nnamespace {0} {{\nnamespace cuda {{\n\n",
                     space, k.asked.name());
  const std::string predicate = fmt::format("::{}::{}", space, name);
  out += fmt::format("cudaError_t {0}::decide{2} {{\n"
                     "  return meetc::cuda::decide_rows<{1}, rungs>(rung, a, b, pairs, n, out, stream);\n}}\n",
                     name, predicate, parameters);
  if (u.asks(lang::rung::certified))
    out += fmt::format("cudaError_t {0}::certify{2} {{\n"
                       "  return meetc::cuda::certify_rows<{1}>(rung, a, b, pairs, n, out, stream);\n}}\n",
                       name, predicate, parameters);
  out += fmt::format("cudaError_t {0}::run{2} {{\n"
                     "  return meetc::cuda::run<{1}, rungs>(which, a, b, in, yes, left, stream);\n}}\n",
                     name, predicate, run_parameters);
  return out + fmt::format("\n}} // namespace cuda\n}} // namespace {}\n", space);
}

// A file of its own, since it compiles as long as the predicate's other launchers.
std::string cuda_order(const unit &u, const lower::kernel &k, const lower::kernel &order) {
  const std::string space = identifier(u.scene.space), name = identifier(k.asked.asked->name);
  const bool walks = walks_first(u, k);
  std::string out =
      banner(u.scene, fmt::format("In which order the hits of {} lie, on a CUDA device.", k.asked.asked->name));
  out += fmt::format("#include <{0}/{0}_cuda.hpp>\n#include <{0}/{1}.hpp>\n#include <{0}/{2}.hpp>\n"
                     "#include <meetc/cuda/first_met.hpp>\n{3}\nnamespace {0} {{\nnamespace cuda {{\n\n",
                     space, k.asked.name(), order.asked.name(), walks ? "#include <meetc/cuda/walk_first.hpp>\n" : "");
  out += fmt::format("cudaError_t {1}::first_met{2} {{\n"
                     "  return meetc::cuda::first_met<::{0}::{1}, ::{0}::{3}_sign>(job, stream);\n}}\n",
                     space, name, first_met_parameters, identifier(order.asked.name()));
  if (walks)
    out += fmt::format("cudaError_t {1}::walk_first{2} {{\n"
                       "  return meetc::cuda::walk_first<::{0}::{1}>(job, stream);\n}}\n",
                       space, name, walk_first_parameters);
  return out + fmt::format("\n}} // namespace cuda\n}} // namespace {}\n", space);
}

// Several predicates may have contacts by one sign. A kernel's name holds no dot here either.
std::string contact_source(const lower::kernel &k) {
  return "contacts." + k.asked.name();
}

std::string cuda_contacts(const unit &u, const lower::kernel &k, const lower::kernel &side) {
  const std::string space = identifier(u.scene.space), name = identifier(k.asked.asked->name);
  return banner(u.scene, fmt::format("Where the hits of {} meet, on a CUDA device.", k.asked.asked->name)) +
         fmt::format("#include <{0}/{0}_cuda.hpp>\n#include <{0}/{1}.hpp>\n"
                     "#include <meetc/cuda/contacts.hpp>\n\nnamespace {0} {{\nnamespace cuda {{\n\n"
                     "cudaError_t {2}::contacts{3} {{\n"
                     "  return meetc::cuda::contacts<::{0}::{4}_sign, {5}>(job, stream);\n}}\n"
                     "\n}} // namespace cuda\n}} // namespace {0}\n",
                     space, side.asked.name(), name, contacts_parameters, identifier(side.asked.name()),
                     k.decision.inputs_a / 3);
}

std::string cuda_text(const unit &u, std::size_t kernel) {
  if (u.kernels[kernel].is_sign)
    throw spec_error({}, "only predicates and formulas have CUDA launchers; a sign's header (--emit=cpp) is host and "
                         "device code");
  if (!u.kernels[kernel].is_predicate)
    return broken_lines(cuda_formulas(u));
  return broken_lines(cuda_launchers(u, u.kernels[kernel]));
}

std::vector<file> cuda_files(const unit &u) {
  const std::string space = identifier(u.scene.space);
  const bool formulas = !formulas_on_columns(u).empty();
  if (predicates_of(u).empty() && !formulas)
    return {}; // nothing to launch
  std::vector<file> out{{space + '/' + space + "_cuda.hpp", cuda_header(u)},
                        {space + '/' + space + "_cuda.cu", cuda_catalogue(u)}};
  for (const lower::kernel *k : predicates_of(u))
    out.push_back({fmt::format("{}/src/{}.cu", space, k->asked.name()), cuda_launchers(u, *k)});
  for (const lower::kernel *k : predicates_of(u))
    if (const lower::kernel *const order = order_of(u, *k))
      out.push_back({fmt::format("{}/src/{}.cu", space, order->asked.name()), cuda_order(u, *k, *order)});
  for (const lower::kernel *k : predicates_of(u))
    if (const lower::kernel *const side = device_contacts_of(u, *k))
      out.push_back({fmt::format("{}/src/{}.cu", space, contact_source(*k)), cuda_contacts(u, *k, *side)});
  for (const lower::lowered_kind *k : element_kinds(u))
    out.push_back({fmt::format("{}/src/{}.cu", space, kind_source(k->name)), cuda_kind(u, *k)});
  if (formulas)
    out.push_back({space + "/src/formulas.cu", cuda_formulas(u)});
  for (file &f : out)
    f.text = broken_lines(f.text);
  return out;
}

} // namespace meetc::target
