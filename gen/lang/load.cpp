// Reads an algebra from TOML, and checks what each table may hold.
#include "gen/lang/relations.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <numeric>

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

kind read_kind(const toml_reader &in, const toml::key &key, const toml::node &node) {
  kind k;
  k.name = std::string(key.str());
  k.where = in.place(key);
  need_name(k.name, k.where, "a kind");
  const std::string what = "kinds." + k.name;
  const toml::table &t = in.as_table(node, what);
  in.allow(t, what, {"store", "blade", "from", "parts", "where", "hull", "pad", "position", "relations", "samples"});
  if (!t.contains("store"))
    throw spec_error(k.where, fmt::format("{} needs 'store': the numbers that it keeps in memory", what));
  if (!t.contains("blade"))
    throw spec_error(k.where, fmt::format("{} needs 'blade': the blade that its numbers stand for", what));
  k.store = read_fields(in, *t.get("store"), what + ".store");
  if (k.store.empty())
    throw spec_error(in.place(*t.get("store")), what + ".store is empty");
  k.blade = in.as_expression(*t.get("blade"), what + ".blade");
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
  in.allow(t, what, {"of", "let", "reject", "hit", "mode"});
  if (!t.contains("of") || !t.contains("hit"))
    throw spec_error(p.where, what + " needs 'of' and 'hit'");
  p.of = read_fields(in, *t.get("of"), what + ".of");
  if (p.of.size() != 2)
    throw spec_error(in.place(*t.get("of")), what + ".of names two operands");
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
  return p;
}

// 'p/q' in lowest terms, so that equal entries have equal text. Numbers with too many digits stay as they are.
std::string reduced(const std::string &s) {
  const auto slash = std::min(s.find('/'), s.size());
  if (slash > 18 || s.size() - slash > 18)
    return s;
  const long long p = std::stoll(s.substr(0, slash)), q = slash == s.size() ? 1 : std::stoll(s.substr(slash + 1));
  const long long common = std::gcd(p, q);
  return q == common ? std::to_string(p / common) : fmt::format("{}/{}", p / common, q / common);
}

std::string rational_text(const toml_reader &in, const toml::node &node) {
  if (node.is_integer())
    return std::to_string(node.as_integer()->get());
  if (node.is_string()) {
    const std::string s = node.as_string()->get();
    const auto slash = s.find('/');
    const auto digits = [](const std::string &d, bool sign) {
      const std::size_t from = sign && !d.empty() && d[0] == '-' ? 1 : 0;
      return d.size() > from && d.find_first_not_of("0123456789", from) == std::string::npos;
    };
    if (slash == std::string::npos ? digits(s, true)
                                   : digits(s.substr(0, slash), true) && digits(s.substr(slash + 1), false) &&
                                         s.find_first_not_of('0', slash + 1) != std::string::npos)
      return reduced(s);
  }
  throw spec_error(in.place(node), "a metric's entry is a whole number or a 'p/q' string");
}

void read_basis(const toml_reader &in, const toml::table &t, algebra &out) {
  in.allow(t, "algebra", {"vectors", "squares", "metric", "null", "import"});
  if (!t.contains("vectors"))
    throw spec_error(out.where, "algebra needs 'vectors'");
  const toml::node &names = *t.get("vectors");
  out.vectors = in.as_strings(names, "algebra.vectors");
  const std::size_t n = out.vectors.size();
  if (n == 0 || n > 8)
    throw spec_error(in.place(names), fmt::format("an algebra has 1 to 8 basis vectors, not {}", n));
  for (std::size_t i = 0; i < n; ++i) {
    need_name(out.vectors[i], in.place(names), "a basis vector");
    if (std::find(out.vectors.begin(), out.vectors.begin() + static_cast<std::ptrdiff_t>(i), out.vectors[i]) !=
        out.vectors.begin() + static_cast<std::ptrdiff_t>(i))
      throw spec_error(in.place(names), fmt::format("vector '{}' is given twice", out.vectors[i]));
  }
  if (t.contains("squares") == t.contains("metric"))
    throw spec_error(out.where, "algebra needs either 'squares' or 'metric'");
  out.metric.assign(n, std::vector<std::string>(n, "0"));
  if (const toml::node *squares = t.get("squares")) {
    const toml::array &a = in.as_array(*squares, "algebra.squares");
    if (a.size() != n)
      throw spec_error(in.place(*squares), fmt::format("{} squares for {} vectors", a.size(), n));
    for (std::size_t i = 0; i < n; ++i)
      out.metric[i][i] = rational_text(in, a[i]);
  } else {
    const toml::node &metric = *t.get("metric");
    const toml::array &rows = in.as_array(metric, "algebra.metric");
    if (rows.size() != n)
      throw spec_error(in.place(metric), fmt::format("{} rows for {} vectors", rows.size(), n));
    for (std::size_t i = 0; i < n; ++i) {
      const toml::array &row = in.as_array(rows[i], "each row of algebra.metric");
      if (row.size() != n)
        throw spec_error(in.place(rows[i]), fmt::format("{} entries for {} vectors", row.size(), n));
      for (std::size_t j = 0; j < n; ++j)
        out.metric[i][j] = rational_text(in, row[j]);
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (out.metric[i][j] != out.metric[j][i])
          throw spec_error(in.place(metric),
                           fmt::format("the metric is not symmetric at row {}, column {}", i + 1, j + 1));
  }
  if (const toml::node *null = t.get("null"))
    for (const toml::node &item : in.as_array(*null, "algebra.null")) {
      const std::string name = in.as_string(item, "each item of algebra.null");
      need_name(name, in.place(item), "a null vector");
      const auto size = name.size();
      const location at = in.place(item);
      const auto file = in.file();
      const std::size_t inner = at.offset + 1;
      out.null.push_back({name, parse_expression({file, inner, inner + size}), at});
    }
}

void load_into(const std::string &path, algebra &out, std::vector<std::shared_ptr<const source_file>> &files,
               std::vector<std::string> &open) {
  const std::string key = fs::weakly_canonical(path).string();
  if (std::find(open.begin(), open.end(), key) != open.end())
    return; // a second import, or an import of itself, adds nothing
  open.push_back(key);
  const toml_reader in(path);
  files.push_back(in.file());
  const toml::table &root = in.root();
  in.allow(root, "an algebra", {"algebra", "constants", "kinds", "functions", "predicates", "import"});
  if (const toml::node *t = root.get("algebra")) {
    if (!out.vectors.empty())
      throw spec_error(in.place(*t), "an imported file cannot declare an algebra of its own");
    out.where = in.place(*t);
    out.name = fs::path(path).stem().string();
    read_basis(in, in.as_table(*t, "algebra"), out);
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
  const auto import_all = [&](const toml::node &imports) {
    for (const toml::node &item : in.as_array(imports, "import")) {
      const std::string name = in.as_string(item, "each item of import");
      const fs::path target = fs::path(path).parent_path() / name;
      if (!fs::is_regular_file(target))
        throw spec_error(in.place(item), fmt::format("cannot find '{}'", target.generic_string()));
      load_into(target.generic_string(), out, files, open);
    }
  };
  if (const toml::node *imports = root.get("import"))
    import_all(*imports);
  if (const toml::node *t = root.get("algebra"))
    if (const toml::node *imports = t->as_table()->get("import"))
      import_all(*imports);
}

} // namespace

void load_algebra(const std::string &path, algebra &out, std::vector<std::shared_ptr<const source_file>> &files) {
  std::vector<std::string> open;
  const std::size_t own = files.size(); // a scene that names this file stands before it
  load_into(path, out, files, open);
  if (out.vectors.empty())
    throw spec_error({files[own], 0, 1}, fmt::format("{} declares no [algebra]", path));
  check(out);
}

} // namespace meetc::lang
