// Reads an algebra from TOML, and checks what each table may hold.
#include "gen/lang/grades.hpp"
#include "gen/lang/places.hpp"
#include "gen/lang/read_basis.hpp"
#include "gen/lang/relations.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace meetc::lang {
namespace {

namespace fs = std::filesystem;

std::string trim(const std::string &s) {
  const auto b = s.find_first_not_of(" \t"), e = s.find_last_not_of(" \t");
  return b == std::string::npos ? "" : s.substr(b, e - b + 1);
}

} // namespace

std::vector<field> read_fields(const toml_reader &in, const toml::node &node, const std::string &what) {
  std::vector<field> out;
  for (const toml::node &item : in.as_array(node, what)) {
    const std::string text = in.as_string(item, "each item of " + what);
    const auto colon = text.find(':');
    const location at = in.place(item);
    if (colon == std::string::npos)
      throw spec_error(at, "expected 'name: type', as in 'x: real'");
    field f{trim(text.substr(0, colon)), trim(text.substr(colon + 1)), at};
    need_name(f.name, at, "a stored number or part");
    need_name(f.type, at, "a type");
    for (const field &other : out)
      if (other.name == f.name)
        throw spec_error(at, fmt::format("'{}' is given twice", f.name));
    out.push_back(std::move(f));
  }
  return out;
}

namespace {

std::vector<named_expr> read_named(const toml_reader &in, const toml::node &node, const std::string &what) {
  std::vector<named_expr> out;
  for (const auto &[key, value] : in.in_file_order(in.as_table(node, what))) {
    const std::string name(key->str());
    need_name(name, in.place(*key), what.c_str());
    out.push_back({name, in.as_expression(*value, fmt::format("{}.{}", what, name)), in.place(*key)});
  }
  return out;
}

void read_blade(const toml_reader &in, const toml::table &t, const std::string &what, kind &k) {
  if (!t.contains("store"))
    throw spec_error(k.where, fmt::format("{} needs 'store': the numbers that it keeps in memory", what));
  if (!t.contains("blade"))
    throw spec_error(k.where, fmt::format("{} needs 'blade': the blade that its numbers stand for", what));
  k.store = read_fields(in, *t.get("store"), what + ".store");
  if (k.store.empty())
    throw spec_error(in.place(*t.get("store")), what + ".store is empty");
  k.blade = in.as_expression(*t.get("blade"), what + ".blade");
}

kind read_kind(const toml_reader &in, const toml::key &key, const toml::node &node) {
  kind k;
  k.name = std::string(key.str());
  k.where = in.place(key);
  need_name(k.name, k.where, "a kind");
  const std::string what = "kinds." + k.name;
  const toml::table &t = in.as_table(node, what);
  in.allow(t, what,
           {"store", "blade", "grades", "from", "parts", "where", "hull", "pad", "position", "relations", "samples"});
  if (t.contains("grades")) {
    for (const char *other : {"store", "blade", "position"})
      if (const toml::node *own = t.get(other))
        throw spec_error(
            in.place(*own),
            fmt::format("{} has 'grades', from which what it stores follows, and so no '{}'", what, other));
    read_grades(in, t, what, k);
  } else {
    read_blade(in, t, what, k);
  }
  if (const toml::node *from = t.get("from"))
    for (const auto &[name, body] : in.in_file_order(in.as_table(*from, what + ".from"))) {
      const std::string where = fmt::format("{}.from.{}", what, name->str());
      const toml::table &c = in.as_table(*body, where);
      in.allow(c, where, {"of", "blade"});
      if (!c.contains("of") || !c.contains("blade"))
        throw spec_error(in.place(*name), where + " needs 'of' and 'blade'");
      need_name(std::string(name->str()), in.place(*name), "a constructor");
      k.from.push_back({std::string(name->str()), read_fields(in, *c.get("of"), where + ".of"),
                        in.as_expression(*c.get("blade"), where + ".blade"), in.place(*name)});
    }
  if (const toml::node *parts = t.get("parts"))
    k.parts = read_named(in, *parts, what + ".parts");
  if (const toml::node *rule = t.get("where"))
    k.rule = in.as_expression(*rule, what + ".where");
  if (const toml::node *hull = t.get("hull"))
    k.hull = in.as_expression(*hull, what + ".hull");
  if (const toml::node *pad = t.get("pad"))
    k.pad = in.as_expression(*pad, what + ".pad");
  if (const toml::node *position = t.get("position"))
    k.position = in.as_bool(*position, what + ".position");
  read_relations(in, t, what, k);
  return k;
}

// Splits 'meet(X, Y)' into a name and its parameters.
void read_signature(const std::string &text, const location &at, function &out) {
  const auto open = text.find('(');
  if (open == std::string::npos || text.back() != ')')
    throw spec_error(at, "a function's key is its name and parameters, as in 'meet(X, Y)'");
  out.name = trim(text.substr(0, open));
  need_name(out.name, at, "a function");
  for (const char *reserved : {"all", "any", "each", "sign", "grade", "if"})
    if (out.name == reserved)
      throw spec_error(at, fmt::format("'{}' is a keyword of the language", reserved));
  std::string rest = text.substr(open + 1, text.size() - open - 2);
  for (std::size_t from = 0; from <= rest.size();) {
    const auto comma = std::min(rest.find(',', from), rest.size());
    const std::string p = trim(rest.substr(from, comma - from));
    need_name(p, at, "a parameter");
    if (std::find(out.params.begin(), out.params.end(), p) != out.params.end())
      throw spec_error(at, fmt::format("parameter '{}' is given twice", p));
    out.params.push_back(p);
    from = comma + 1;
  }
}

predicate read_predicate(const toml_reader &in, const toml::key &key, const toml::node &node) {
  predicate p;
  p.name = std::string(key.str());
  p.where = in.place(key);
  need_name(p.name, p.where, "a predicate");
  const std::string what = "predicates." + p.name;
  const toml::table &t = in.as_table(node, what);
  in.allow(t, what, {"of", "let", "reject", "hit", "mode", "means", "common", "contacts"});
  if (!t.contains("of") || !t.contains("hit"))
    throw spec_error(p.where, what + " needs 'of' and 'hit'");
  p.of = read_fields(in, *t.get("of"), what + ".of");
  if (p.of.size() != 2)
    throw spec_error(in.place(*t.get("of")), what + ".of names two operands, as in ['A: sphere', 'B: line']");
  if (const toml::node *lets = t.get("let"))
    p.lets = read_named(in, *lets, what + ".let");
  if (const toml::node *reject = t.get("reject"))
    for (const toml::node &item : in.as_array(*reject, what + ".reject"))
      p.reject.push_back(in.as_expression(item, "each item of " + what + ".reject"));
  p.hit = in.as_expression(*t.get("hit"), what + ".hit");
  if (const toml::node *mode = t.get("mode")) {
    p.mode = in.as_string(*mode, what + ".mode");
    if (p.mode != "solid" && p.mode != "surface")
      throw spec_error(in.place(*mode), what + ".mode is 'solid' or 'surface'");
  }
  read_meaning(in, t, what, p);
  if (const toml::node *contacts = t.get("contacts")) {
    p.contacts = in.as_string(*contacts, what + ".contacts");
    p.contacts_where = in.place(*contacts);
  }
  return p;
}

// The files that were read, and those whose content is in `open` already.
struct reading_files {
  std::vector<std::shared_ptr<const source_file>> &files;
  const std::vector<std::string> &algebra_path;
  std::vector<std::string> open;
};

void load_into(const std::string &path, algebra &out, reading_files &all);

// The algebra that this one extends: its vectors and its metric are those of this one too.
void extend(const toml_reader &in, const toml::table &t, algebra &out, reading_files &all) {
  const toml::node &base = *t.get("extends");
  for (const char *key : {"vectors", "squares", "metric", "null"})
    if (const toml::node *own = t.get(key))
      throw spec_error(
          in.place(*own),
          fmt::format("an algebra that extends another one has that one's '{}', and none of its own", key));
  const std::string path = find_algebra(in.place(base), in.as_string(base, "algebra.extends"), all.algebra_path);
  const std::size_t before = all.files.size();
  load_into(path, out, all);
  if (out.vectors.empty())
    throw spec_error(in.place(base),
                     all.files.size() == before
                         ? fmt::format("{} extends itself", path)
                         : fmt::format("{} declares no [algebra], so there is nothing to extend; to take "
                                       "its kinds and functions, write import = ['{}']",
                                       path, in.as_string(base, "algebra.extends")));
}

void load_into(const std::string &path, algebra &out, reading_files &all) {
  std::vector<std::string> &open = all.open;
  const std::string key = fs::weakly_canonical(path).string();
  if (std::find(open.begin(), open.end(), key) != open.end())
    return; // a second import, or an import of itself, adds nothing
  open.push_back(key);
  const toml_reader in(path);
  all.files.push_back(in.file());
  const toml::table &root = in.root();
  in.allow(root, "an algebra", {"algebra", "constants", "kinds", "functions", "predicates", "gives", "import"});
  if (const toml::node *t = root.get("algebra")) {
    if (!out.vectors.empty())
      throw spec_error(in.place(*t), "an imported file cannot declare an algebra of its own");
    const toml::table &basis = in.as_table(*t, "algebra");
    in.allow(basis, "algebra", {"vectors", "squares", "metric", "null", "order", "import", "extends", "spec"});
    check_version(in, basis);
    out.where = in.place(*t);
    if (basis.contains("extends"))
      extend(in, basis, out, all);
    else
      read_basis(in, basis, out);
    if (const toml::node *order = basis.get("order"))
      read_order(in, *order, out);
    out.where = in.place(*t);
    out.name = fs::path(path).stem().string();
  }
  if (const toml::node *constants = root.get("constants"))
    for (named_expr &c : read_named(in, *constants, "constants"))
      out.constants.push_back(std::move(c));
  if (const toml::node *kinds = root.get("kinds"))
    for (const auto &[name, body] : in.in_file_order(in.as_table(*kinds, "kinds")))
      out.kinds.push_back(read_kind(in, *name, *body));
  if (const toml::node *functions = root.get("functions"))
    for (const auto &[name, body] : in.in_file_order(in.as_table(*functions, "functions"))) {
      function f;
      f.where = in.place(*name);
      read_signature(std::string(name->str()), f.where, f);
      if (const toml::table *t = body->as_table()) {
        const std::string what = "functions." + f.name;
        in.allow(*t, what, {"is", "where", "orders"});
        if (!t->contains("is"))
          throw spec_error(f.where, what + " needs 'is'");
        f.body = in.as_expression(*t->get("is"), what);
        if (const toml::node *domain = t->get("where"))
          f.domain = in.as_expression(*domain, what + ".where");
        if (const toml::node *orders = t->get("orders")) {
          f.orders = in.as_string(*orders, what + ".orders");
          f.orders_where = in.place(*orders);
        }
      } else {
        f.body = in.as_expression(*body, "functions." + f.name);
      }
      out.functions.push_back(std::move(f));
    }
  if (const toml::node *predicates = root.get("predicates"))
    for (const auto &[name, body] : in.in_file_order(in.as_table(*predicates, "predicates")))
      out.predicates.push_back(read_predicate(in, *name, *body));
  if (const toml::node *gives = root.get("gives"))
    for (const auto &[name, body] : in.in_file_order(in.as_table(*gives, "gives"))) {
      const std::string kind(name->str());
      out.readings.push_back({kind, read_named(in, *body, "gives." + kind), in.place(*name)});
    }
  const auto import_all = [&](const toml::node &imports) {
    for (const toml::node &item : in.as_array(imports, "import")) {
      const std::string name = in.as_string(item, "each item of import");
      const fs::path target = fs::path(path).parent_path() / name;
      std::error_code unreadable; // as a name that is too long for a file
      if (!fs::is_regular_file(target, unreadable))
        throw spec_error(in.place(item), fmt::format("cannot find '{}'", target.generic_string()));
      load_into(target.generic_string(), out, all);
    }
  };
  if (const toml::node *imports = root.get("import"))
    import_all(*imports);
  if (const toml::node *t = root.get("algebra"))
    if (const toml::node *imports = t->as_table()->get("import"))
      import_all(*imports);
}

} // namespace

void load_algebra(const std::string &path, algebra &out, std::vector<std::shared_ptr<const source_file>> &files,
                  const std::vector<std::string> &algebra_path) {
  reading_files all{files, algebra_path, {}};
  const std::size_t own = files.size(); // a scene that names this file stands before it
  load_into(path, out, all);
  if (out.vectors.empty())
    throw spec_error({files[own], 0, 1}, fmt::format("{} declares no [algebra]", path));
  complete_grades(out);
  check(out);
}

} // namespace meetc::lang
