// The sources of the generated library: one for each kernel that is made of signs.
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"

#include <fmt/format.h>

namespace meetc::target {

std::string info_function(const lower::kernel &k) {
  return identifier(k.asked.asked->name) + "_info";
}

namespace {

// The header and the table's function that find contacts, by the sign if they take one, and the function that finds winding
// numbers by it; empty: there is none.
struct contacts_text {
  const char *header;
  std::string function, winding;
};
contacts_text contacts_by(const emitted_predicate &p, const lower::kernel *sides) {
  const lang::predicate &asked = *p.kernel.asked.asked;
  const char *const surface = asked.mode == "surface" ? "true" : "false";
  if (asked.contacts == lang::one_witness && p.of.asks(lang::rung::certified))
    return {"round_pair", fmt::format("witness_codes<{}, {}>", p.name, surface), ""};
  if (!sides)
    return {"", "", ""};
  const std::string sign = identifier(sides->asked.name()) + "_sign";
  const int numbers = p.kernel.decision.inputs_a; // of the first operand: 4 are a ball
  if (numbers == 4)
    return {"round_pair", fmt::format("ball_segment_codes<{}, {}>", sign, surface), ""};
  return {"contact", fmt::format("contact_codes<{}, {}>", sign, numbers / 3), fmt::format("winding_part<{}>", sign)};
}

} // namespace

std::string predicate_source(const emitted_predicate &p) {
  const std::string space = identifier(p.of.scene.space), name = p.kernel.asked.name();
  std::string out = banner(p.of.scene, fmt::format("The parts of {} that only few pairs need.", p.kernel.asked.text));
  const lower::kernel *const order = p.kernel.is_sign ? nullptr : order_of(p.of, p.kernel);
  const lower::kernel *const sides = p.kernel.is_sign ? nullptr : contacts_of(p.of, p.kernel);
  const contacts_text contacts = p.kernel.is_sign ? contacts_text{"", "", ""} : contacts_by(p, sides);
  out += "#include <meetc/simd/table_functions.hpp>\n";
  if (order)
    out += "#include <meetc/decide/first_met.hpp>\n";
  if (!contacts.function.empty())
    out += fmt::format("#include <meetc/contact/{}.hpp>\n", contacts.header);
  if (!contacts.winding.empty())
    out += "#include <meetc/contact/winding.hpp>\n";
  for (const lower::kernel *const k : {order, sides})
    if (k)
      out += fmt::format("\n#include <{}/{}.hpp>", space, k->asked.name());
  out += fmt::format("\n#include <{0}/{1}.hpp>\n#include <{0}/detail/{1}_later.hpp>\n\nMEETC_NAMESPACE({0}) {{\n\n",
                     space, name);
  out += out_of_line(p, "");
  if (p.has_rare() && p.asks_plain())
    for (const char *type : {"float", "double", "meetc::double_double"})
      out += fmt::format("template bool {}::whole_plain<{}>(const float *, const float *);\n", p.name, type);
  if (lower::on_sets(p.kernel)) {
    std::string rungs;
    for (const lang::rung_info &r : lang::rungs)
      if (p.of.asks(r.id) && (r.id != lang::rung::tolerant || p.tolerant))
        rungs += fmt::format("{}meetc::rung::{}", rungs.empty() ? "" : ", ", r.name);
    out += fmt::format("\nnamespace detail {{\nmeetc::predicate_info {0}(const meetc::kind_info *a, const "
                       "meetc::kind_info *b, int number_a,\n"
                       "    int number_b) {{\n"
                       "  {5}meetc::info_of<{1}, {2}>(\"{3}\", \"{4}\", a, b, number_a,\n      number_b);\n",
                       info_function(p.kernel), p.name, rungs, p.kernel.asked.asked->name, p.kernel.asked.asked->mode,
                       order || !contacts.function.empty() ? "meetc::predicate_info info = " : "return ");
    if (order)
      out +=
          fmt::format("  info.first_met = meetc::first_met<{}, {}_sign>;\n", p.name, identifier(order->asked.name()));
    if (!contacts.function.empty())
      out += fmt::format("  info.contacts = meetc::guarded<meetc::{}>;\n", contacts.function);
    if (!contacts.winding.empty())
      out += fmt::format("  info.winding = meetc::guarded<meetc::{}>;\n", contacts.winding);
    if (order || !contacts.function.empty())
      out += "  return info;\n";
    out += "}\n} // namespace detail\n";
  }
  return out + fmt::format("\n}} // namespace {}\n", space);
}

std::string alone_header(const emitted_predicate &p) {
  const std::string name = p.kernel.asked.name();
  return banner(p.of.scene, fmt::format("{} for a program that needs little else: header-only, and soon compiled.",
                                        p.kernel.asked.text)) +
         open_header(p.of.scene, "alone_" + name, {name + ".hpp", fmt::format("detail/{}_later.hpp", name)}) +
         "// Include this wherever it is called, in a program that neither is linked with the library nor includes\n"
         "// header_only.hpp. Pairs that fp32 leaves unsure are decided in exact integers: as right, and slower.\n" +
         out_of_line(p, "inline ", last_rungs::integers) + close_header(p.of.scene);
}

std::string header_only(const unit &u) {
  std::string out = banner(u.scene, "For header-only users: defines inline what the generated library would compile.");
  std::vector<std::string> includes, rest; // a kernel's header precedes its rest header
  std::string functions;
  for (std::size_t i = 0; i < u.kernels.size(); ++i)
    if (u.kernels[i].is_predicate) {
      const emitted_predicate p(u, i);
      includes.push_back(p.kernel.asked.name() + ".hpp");
      rest.push_back(fmt::format("detail/{}_later.hpp", p.kernel.asked.name()));
      functions += out_of_line(p, "inline ");
    }
  includes.insert(includes.end(), rest.begin(), rest.end());
  out += open_header(u.scene, "file_header_only", includes) +
         "// Include this in at least one source of a program that is not linked with the library.\n" + functions;
  return out + close_header(u.scene);
}

} // namespace meetc::target
