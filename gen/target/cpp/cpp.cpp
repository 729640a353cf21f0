// C++ headers: the kinds, one header for each kernel, and one for the namespace.
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"
#include "gen/target/gappa/gappa.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace meetc::target {
namespace {

using algebra::blade;

std::uint64_t content_hash(const lang::scene &s) {
  std::uint64_t h = 14695981039346656037u; // FNV-1a
  for (const auto &file : s.files)
    for (const char c : file->text + '\0')
      h = (h ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return h;
}

std::string lower_include(const std::string &kernel) {
  return kernel + ".hpp";
}

std::string field_list(const std::vector<std::string> &names) {
  return join(names, ", ");
}

} // namespace

std::vector<const lang::kind *> kinds_of(const unit &u) {
  std::set<const lang::kind *> wanted;
  const std::function<void(const lang::kind *)> want = [&](const lang::kind *k) {
    if (!k || !wanted.insert(k).second)
      return;
    for (const lang::field &f : k->store)
      want(u.model.spec().find_kind(f.type));
    for (const lang::constructor &c : k->from)
      for (const lang::field &f : c.of)
        want(u.model.spec().find_kind(f.type));
  };
  for (const lower::kernel &k : u.kernels) {
    for (const lang::kind *operand : k.asked.kinds)
      want(operand);
    if (!k.is_predicate)
      want(k.value.result_kind);
  }
  std::vector<const lang::kind *> out;
  for (const lang::kind &k : u.model.spec().kinds)
    if (wanted.count(&k))
      out.push_back(&k);
  // A struct comes after the structs that it holds.
  std::vector<const lang::kind *> ordered;
  std::set<const lang::kind *> done;
  const std::function<void(const lang::kind *)> place = [&](const lang::kind *k) {
    if (!done.insert(k).second)
      return;
    for (const lang::field &f : k->store)
      if (const lang::kind *part = u.model.spec().find_kind(f.type))
        place(part);
    ordered.push_back(k);
  };
  for (const lang::kind *k : out)
    place(k);
  return ordered;
}

std::set<const lang::kind *> blades_of(const unit &u) {
  std::set<const lang::kind *> out;
  for (const lower::kernel &k : u.kernels)
    if (!k.is_predicate) {
      out.insert(k.asked.kinds.begin(), k.asked.kinds.end());
      if (k.value.result_kind)
        out.insert(k.value.result_kind);
    }
  return out;
}

namespace {

// The condition that predicates assume of an operand: finite numbers, and the kind's `where`.
std::string valid_text(const unit &u, const lang::kind &k) {
  const std::vector<lower::stored_real> reals = u.model.layout(k).reals;
  std::string holds;
  for (const lower::stored_real &r : reals)
    holds += fmt::format("{}meetc::is_finite(k.{})", holds.empty() ? "" : " &&\n      ", path_identifier(r.path));
  std::string rule;
  if (k.rule) {
    const lower::enclosure e = lower::enclosing(u.model, k);
    const std::string path = path_identifier(reals[static_cast<std::size_t>(e.rule_input)].path);
    holds += " &&\n      " + rule_test(e, "k." + path);
    rule = fmt::format(" and {}", e.rule_text);
  }
  return fmt::format("// Whether all numbers are finite{}, by their bits. Predicates assume it.\n"
                     "template <class T> MEETC_HD inline bool valid(const {}<T> &k) {{\n  return {};\n}}\n",
                     rule, identifier(k.name), holds);
}

std::string struct_text(const unit &u, const lang::kind &k) {
  const std::string name = identifier(k.name);
  std::string out = fmt::format("// A {} as it is stored: {} numbers.\ntemplate <class T = float> struct {} {{\n",
                                k.name, u.model.layout(k).reals.size(), name);
  for (std::size_t i = 0; i < k.store.size();) {
    // Adjacent members of one type share a line.
    std::vector<std::string> names;
    const std::string &type = k.store[i].type;
    bool clash = false; // a member named like its type would change the meaning of that name
    for (; i < k.store.size() && k.store[i].type == type; ++i) {
      names.push_back(identifier(k.store[i].name));
      for (const lang::field &f : k.store)
        clash = clash || identifier(f.name) == identifier(type);
    }
    const std::string space = clash ? "::" + identifier(u.scene.space) + "::" : "";
    out += fmt::format("  {} {};\n", type == "real" ? "T" : space + identifier(type) + "<T>", field_list(names));
  }
  out += "};\n";
  out += fmt::format("template <class T> MEETC_HD inline void to_row(const {}<T> &k, T *out) {{\n", name);
  int i = 0;
  for (const lower::stored_real &r : u.model.layout(k).reals)
    out += fmt::format("  out[{}] = k.{};\n", i++, path_identifier(r.path));
  return out + "}\n" + valid_text(u, k) + "\n";
}

// Reads a kind's struct from the row, starting at `at`, which moves past it.
std::string members_in_row(const unit &u, const lang::kind &k, int &at) {
  std::string out;
  for (const lang::field &f : k.store) {
    const lang::kind *part = u.model.spec().find_kind(f.type);
    out += (out.empty() ? "" : ", ") + (part ? '{' + members_in_row(u, *part, at) + '}' : fmt::format("row[{}]", at++));
  }
  return out;
}
std::string row_reader(const unit &u, const lang::kind &k) {
  int at = 0;
  const std::string members = members_in_row(u, k, at);
  return fmt::format("template <class T> MEETC_HD MEETC_INLINE {0}<T> {0}_in(const T *row) {{\n  return {{{1}}};\n}}\n",
                     identifier(k.name), members);
}

std::string blade_struct(const unit &u, const lang::kind &k) {
  const std::vector<blade> blades = lower::support(u.model, k);
  std::vector<std::string> fields;
  for (const blade b : blades)
    fields.push_back(blade_field(u.model.working(), b));
  return fmt::format(
      "// The blade of a {}: coefficients on {}.\ntemplate <class T = float> struct {}_blade {{\n"
      "  T {};\n}};\n",
      k.name,
      [&] {
        std::vector<std::string> names;
        for (const blade b : blades)
          names.push_back(u.model.working().name(b));
        return join(names, ", ");
      }(),
      identifier(k.name), field_list(fields));
}

std::string maker_text(const unit &u, const lang::kind &k) {
  std::string out;
  const std::vector<blade> blades = lower::support(u.model, k);
  for (const lower::blade_maker &maker : u.makers.at(&k)) {
    const lang::expr *written = k.blade.get();
    for (const lang::constructor &c : k.from)
      if (c.name == maker.name)
        written = c.blade.get();
    out += fmt::format("// {}\n// {}.\n", lang::print(*written),
                       count_text(ir::count(maker.code.nodes, maker.code.results)));
    std::string parameters;
    if (maker.name.empty()) {
      parameters = fmt::format("const {}<T> &k", identifier(k.name));
      out +=
          fmt::format("template <class T> MEETC_HD inline {}_blade<T> blade({}) {{\n", identifier(k.name), parameters);
    } else {
      for (const lang::field &f : maker.of)
        parameters += fmt::format("{}const {} &{}", parameters.empty() ? "" : ", ",
                                  f.type == "real" ? "T" : identifier(f.type) + "<T>", identifier(f.name));
      out += fmt::format("template <class T> MEETC_HD inline {0}_blade<T> {1}({2}) {{\n", identifier(k.name),
                         identifier(k.name + "_from_" + maker.name), parameters);
    }
    body_names names;
    names.input = [&](int i) {
      return (maker.name.empty() ? "k." : "") + path_identifier(maker.inputs[static_cast<std::size_t>(i)]);
    };
    names.result = [&](std::size_t i, const std::string &value) {
      return fmt::format("B.{} = {};", blade_field(u.model.working(), blades[i]), value);
    };
    out += fmt::format("  {}_blade<T> B;\n", identifier(k.name)) + body(maker.code, names, "  ") + "  return B;\n}\n";
  }
  return out + "\n";
}

std::string kinds_header(const unit &u) {
  std::string out = banner(u.scene, "Kinds: what is stored, and the blades that it stands for.");
  out += open_header(u.scene, "file_kinds");
  const auto blades = blades_of(u);
  for (const lang::kind *k : kinds_of(u))
    out += struct_text(u, *k);
  out += "// Reads kinds from rows.\nnamespace detail {\n";
  for (const lang::kind *k : kinds_of(u))
    out += row_reader(u, *k);
  out += "} // namespace detail\n\n";
  for (const lang::kind *k : kinds_of(u))
    if (blades.count(k))
      out += blade_struct(u, *k) + maker_text(u, *k);
  return out + close_header(u.scene);
}

// Marks an operand that nothing reads, so that no compiler warns about it.
std::string unused_mark(const std::string &body, const std::string &name) {
  return body.find(name + '.') == std::string::npos ? "[[maybe_unused]] " : "";
}

std::string formula_header(const unit &u, const lower::kernel &k) {
  const lower::formula &f = k.value;
  const bool number = f.result.size() == 1 && f.result[0] == 0;
  std::string out;
  if (!number && !f.result_kind) {
    std::vector<std::string> fields;
    for (const blade b : f.result)
      fields.push_back(blade_field(u.model.working(), b));
    out += fmt::format("template <class T = float> struct {}_result {{\n  T {};\n}};\n\n", identifier(k.asked.name()),
                       field_list(fields));
  }
  const std::string type = number          ? "T"
                           : f.result_kind ? identifier(f.result_kind->name) + "_blade<T>"
                                           : identifier(k.asked.name()) + "_result<T>";
  std::vector<std::string> blade_names;
  for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
    for (const blade b : lower::support(u.model, *k.asked.kinds[i]))
      blade_names.push_back(k.asked.names[i] + '.' + blade_field(u.model.working(), b));
  // On blades.
  out += fmt::format("// {} on blades\n", k.asked.text);
  for (std::size_t i = 0; i < f.result.size(); ++i) {
    const std::string left = number ? "" : "B." + blade_field(u.model.working(), f.result[i]) + " = ";
    if (f.polynomials[i].length() <= 60)
      out += wrapped(left + poly_with_names(f.polynomials[i], blade_names), "//   ");
    else
      out += fmt::format("//   {}{} terms when expanded\n", left, f.polynomials[i].length());
  }
  out += fmt::format("// {}.\n", count_text(ir::count(f.from_blades.nodes, f.from_blades.results)));
  const auto parameters = [&](const char *suffix, const std::string &reads) {
    std::string list;
    for (std::size_t i = 0; i < k.asked.kinds.size(); ++i) {
      const std::string kind = identifier(k.asked.kinds[i]->name), name = identifier(k.asked.names[i]);
      list += fmt::format("{}{}const {}{}<T> &{}", i ? ", " : "", unused_mark(reads, name), kind, suffix, name);
    }
    return list;
  };
  std::string call;
  for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
    call += fmt::format("{}blade({})", i ? ", " : "", identifier(k.asked.names[i]));
  body_names names;
  names.input = [&](int i) { return blade_names[static_cast<std::size_t>(i)]; };
  if (number) {
    names.result = [](std::size_t, const std::string &value) { return fmt::format("return {};", value); };
    const std::string code = body(f.from_blades, names, "  ");
    out += fmt::format("template <class T> MEETC_HD inline T {}({}) {{\n{}}}\n", kernel_function(k.asked),
                       parameters("_blade", code), code);
  } else {
    names.result = [&](std::size_t i, const std::string &value) {
      return fmt::format("B.{} = {};", blade_field(u.model.working(), f.result[i]), value);
    };
    std::string rest;
    if (f.result_kind)
      for (const blade b : lower::support(u.model, *f.result_kind))
        if (std::find(f.result.begin(), f.result.end(), b) == f.result.end())
          rest += fmt::format("  B.{} = T(0);\n", blade_field(u.model.working(), b));
    const std::string code = body(f.from_blades, names, "  ");
    out += fmt::format("template <class T> MEETC_HD inline {} {}({}) {{\n  {} B;\n{}{}  return B;\n}}\n", type,
                       kernel_function(k.asked), parameters("_blade", code), type, code, rest);
  }
  // On stored operands.
  if (number) {
    std::vector<std::string> inputs;
    for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
      for (const lower::stored_real &r : u.model.layout(*k.asked.kinds[i]).reals)
        inputs.push_back(identifier(k.asked.names[i]) + '.' + path_identifier(r.path));
    names.input = [&](int i) { return inputs[static_cast<std::size_t>(i)]; };
    out +=
        fmt::format("\n// {} from stored numbers, in differences if it is translation invariant; B is not computed.\n"
                    "// {}.\n",
                    k.asked.text, count_text(ir::count(f.from_stored.nodes, f.from_stored.results)));
    const std::string code = body(f.from_stored, names, "  ");
    out += fmt::format("template <class T> MEETC_HD inline T {}({}) {{\n{}}}\n", kernel_function(k.asked),
                       parameters("", code), code);
  } else {
    std::string all;
    for (const std::string &name : k.asked.names)
      all += identifier(name) + '.';
    out += fmt::format("template <class T> MEETC_HD inline {} {}({}) {{\n  return {}({});\n}}\n", type,
                       kernel_function(k.asked), parameters("", all), kernel_function(k.asked), call);
  }
  return out;
}

} // namespace

std::string banner(const lang::scene &s, const std::string &what, const char *comment) {
  std::vector<std::string> names;
  for (const auto &file : s.files)
    names.push_back(file->path.substr(file->path.find_last_of('/') + 1));
  return fmt::format("{0} Generated by meetc {1} from {2} (content {3:016x}): do not edit.\n{0} {4}\n", comment,
                     MEETC_VERSION, join(names, ", "), content_hash(s), what);
}

std::string open_header(const lang::scene &s, const std::string &name, const std::vector<std::string> &includes,
                        const std::vector<std::string> &kernel_headers) {
  const std::string space = identifier(s.space);
  // The length keeps guards different where '_' could be the border between two names.
  std::string out = fmt::format("#ifndef MEETC_{2}_{0}_{1}_HPP\n#define MEETC_{2}_{0}_{1}_HPP\n\n#include "
                                "<meetc/support.hpp>\n",
                                space, name, space.size());
  for (const std::string &i : kernel_headers)
    out += fmt::format("#include <meetc/{}>\n", i);
  for (const std::string &i : includes)
    out += fmt::format("#include <{}/{}>\n", space, i);
  return out + fmt::format("\nstatic_assert(MEETC_SUPPORT_VERSION == 4, \"meetc/support.hpp is of another version; "
                           "regenerate\");\n\nnamespace {} {{\n\n",
                           space);
}

std::string close_header(const lang::scene &s) {
  return fmt::format("\n}} // namespace {}\n\n#endif\n", identifier(s.space));
}

std::string broken_lines(const std::string &text) {
  constexpr std::size_t width = 110;
  std::string out;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string line = text.substr(from, end - from);
    from = end + 1;
    const std::size_t indent = line.find_first_not_of(' ');
    const bool code = indent != std::string::npos && line[indent] != '#' && line.compare(indent, 2, "//") != 0;
    while (code && line.size() > width) {
      const std::size_t cut = line.rfind(", ", width - 1);
      if (cut == std::string::npos || cut <= indent + 4)
        break;
      out += line.substr(0, cut + 1) + '\n';
      line = std::string(indent + 4, ' ') + line.substr(cut + 2);
    }
    out += line + '\n';
  }
  return out;
}

std::string cpp_text(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  const std::string head = banner(u.scene, k.asked.text);
  if (k.is_predicate)
    return broken_lines(head + kernel_header(u, kernel));
  return broken_lines(head + open_header(u.scene, "kernel_" + k.asked.name(), {"kinds.hpp"}) + formula_header(u, k) +
                      close_header(u.scene));
}

namespace {
// The files of a kernel of signs besides its own header.
void add_parts(const unit &u, std::size_t kernel, std::vector<file> &out) {
  const std::string space = identifier(u.scene.space), name = u.kernels[kernel].asked.name();
  const emitted_predicate p(u, kernel);
  if (p.bounds)
    out.push_back({fmt::format("{}/detail/{}_bounds.hpp", space, name), bounds_header(p)});
  out.push_back({fmt::format("{}/detail/{}_rest.hpp", space, name), rest_header(p)});
  out.push_back({fmt::format("{}/src/{}.cpp", space, name), predicate_source(p)});
}
} // namespace

std::vector<file> cpp_files(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::vector<file> out{{space + "/kinds.hpp", kinds_header(u)}};
  std::vector<std::string> headers{"kinds.hpp"};
  for (std::size_t i = 0; i < u.kernels.size(); ++i) {
    headers.push_back(lower_include(u.kernels[i].asked.name()));
    out.push_back({space + '/' + headers.back(), cpp_text(u, i)});
    if (u.kernels[i].is_predicate)
      add_parts(u, i, out);
  }
  std::sort(headers.begin() + 1, headers.end());
  out.push_back({space + '/' + space + ".hpp", banner(u.scene, "Everything that the scene asks for.") +
                                                   open_header(u.scene, "file_all", headers) + close_header(u.scene)});
  out.push_back({space + "/header_only.hpp", header_only(u)});
  out.push_back({space + "/shapes.hpp", shapes_header(u)});
  out.push_back({space + '/' + space + "_runtime.hpp", runtime_header(u)});
  out.push_back({space + '/' + space + "_runtime.cpp", runtime_source(u)});
  for (file &f : out)
    f.text = broken_lines(f.text);
  if (u.asks(lang::rung::certified))
    for (file &f : proof_files(u))
      out.push_back(std::move(f));
  return out;
}

} // namespace meetc::target
