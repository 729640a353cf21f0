// Reads a scene from TOML, with the algebra that it names.
#include "gen/lang/analytic.hpp"
#include "gen/lang/places.hpp"
#include "gen/lang/spec.hpp"
#include "gen/lang/toml_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace meetc::lang {
namespace {

namespace fs = std::filesystem;

// A float32 that is not subnormal and that can be doubled.
double box_size(const toml_reader &in, const toml::node &node) {
  const double v = in.as_positive_number(node, "scene.box");
  if (v >= 0x1p127)
    throw spec_error(in.place(node), "scene.box must be below 2^127");
  if (v < 0x1p-126)
    throw spec_error(in.place(node), "scene.box must be at least 2^-126");
  return v;
}

// A kernel that the algebra may have: for a hint.
std::string some_kernel(const algebra &a) {
  if (!a.predicates.empty())
    return a.predicates.front().name;
  const std::string kind = a.kinds.empty() ? "KIND" : a.kinds.front().name;
  return a.functions.empty()
             ? '~' + kind
             : fmt::format("{}({})", a.functions.front().name,
                           join(std::vector<std::string>(a.functions.front().params.size(), kind), ", "));
}

} // namespace

scene load_scene(const std::string &path, const backend_choice &backends, const std::vector<std::string> &search) {
  const toml_reader in(path);
  scene s;
  s.files.push_back(in.file());
  for (const char *const key : {"algebra", "kinds", "functions", "predicates"})
    if (const toml::node *const part = in.root().get(key); part && part->is_table() && !in.root().contains("scene"))
      throw spec_error(in.place(*part), "this is an algebra; a scene names one, and kernels: [scene] with algebra, "
                                        "namespace and kernels");
  in.allow(in.root(), "a scene", {"scene"});
  if (!in.root().contains("scene"))
    throw spec_error({in.file(), 0, 1}, fmt::format("{} has no [scene]", path));
  const toml::node &node = *in.root().get("scene");
  const toml::table &t = in.as_table(node, "scene");
  in.allow(t, "scene",
           {"algebra", "namespace", "kernels", "zero", "rungs", "backends", "box", "tolerance", "kinds", "spec"});
  check_version(in, t);
  for (const char *key : {"algebra", "namespace", "kernels"})
    if (!t.contains(key))
      throw spec_error(in.place(node), fmt::format("scene needs '{}'", key));
  s.name = fs::path(path).stem().string();
  s.space = in.as_string(*t.get("namespace"), "scene.namespace");
  need_name(s.space, in.place(*t.get("namespace")), "a namespace");
  for (const char *taken : {"meetc", "std", "cuda", "every_pair"})
    if (s.space == taken)
      throw spec_error(
          in.place(*t.get("namespace")),
          fmt::format("the namespace '{0}' is taken by the code that is included; write another one, as in "
                      "namespace = 'my_{0}'",
                      taken));
  const std::string algebra_path = in.as_string(*t.get("algebra"), "scene.algebra");
  load_algebra(find_algebra(in.place(*t.get("algebra")), algebra_path, search), s.in, s.files, search);
  for (const toml::node &item : in.as_array(*t.get("kernels"), "scene.kernels"))
    s.kernels.push_back({in.as_expression(item, "each item of scene.kernels"), in.place(item)});
  if (const toml::node *kinds = t.get("kinds"))
    for (const toml::node &item : in.as_array(*kinds, "scene.kinds")) {
      const std::string name = in.as_string(item, "each item of scene.kinds");
      if (!s.in.find_kind(name))
        throw spec_error(in.place(item), fmt::format("no kind '{}'; kinds: {}{}", name, join(s.in.kind_names(), ", "),
                                                     nearest(name, s.in.kind_names())));
      s.kinds.push_back({name, name, in.place(item)});
    }
  take_analytic(s);
  if (const toml::node *zero = t.get("zero"))
    for (const toml::node &item : in.as_array(*zero, "scene.zero"))
      s.zero.push_back({in.as_expression(item, "each item of scene.zero"), in.place(item)});
  const auto choices = [&](const char *key, const std::vector<std::string> &known, std::vector<std::string> out) {
    const toml::node *node_of = t.get(key);
    if (!node_of)
      return out;
    out.clear();
    for (const toml::node &item : in.as_array(*node_of, std::string("scene.") + key)) {
      const std::string value = in.as_string(item, std::string("each item of scene.") + key);
      if (std::find(known.begin(), known.end(), value) == known.end())
        throw spec_error(in.place(item), fmt::format("no '{}' in {}; known: {}", value, key, join(known, ", ")));
      if (std::find(out.begin(), out.end(), value) != out.end())
        throw spec_error(in.place(item), fmt::format("'{}' is given twice", value));
      out.push_back(value);
    }
    if (out.empty())
      throw spec_error(in.place(*node_of), fmt::format("scene.{} is empty; known: {}", key, join(known, ", ")));
    return out;
  };
  if (t.contains("tolerance")) {
    s.tolerance = in.as_positive_number(*t.get("tolerance"), "scene.tolerance");
    s.tolerance_where = in.place(*t.get("tolerance"));
  }
  // A scene that bears a tolerance asks for what is proved to keep it, and for nothing else.
  std::vector<std::string> defaults = rung_names();
  std::erase_if(defaults,
                [&s](const std::string &name) { return (name == info_of(rung::tolerant).name) != (s.tolerance > 0); });
  const std::vector<std::string> asked = choices("rungs", rung_names(), defaults);
  for (const std::string &name : asked)
    for (const rung_info &r : rungs)
      if (name == r.name)
        s.rungs.push_back(r.id);
  if (s.asks(rung::tolerant) && s.tolerance == 0)
    throw spec_error(in.place(*t.get("rungs")), "the rung tolerant needs scene.tolerance, a length");
  if (t.contains("box"))
    s.box = box_size(in, *t.get("box"));
  s.backends = choices("backends", backends.known, backends.unless_said);
  if (s.kernels.empty() && s.analytic.empty() && s.zero.empty())
    throw spec_error(
        in.place(*t.get("kernels")),
        fmt::format("scene.kernels is empty, so nothing would be emitted; name predicates, or functions of "
                    "kinds, as in kernels = ['{}']",
                    some_kernel(s.in)));
  return s;
}

} // namespace meetc::lang
