#include "gen/target/cpp/body.hpp"

#include <fmt/format.h>
#include <map>
#include <set>

namespace meetc::target {
namespace {
using ir::node;
using ir::node_id;
using ir::op;

constexpr std::size_t longest_inline = 72;

std::string constant_text(const ir::rational &q, const std::string &type) {
  const auto integer = [&](const mpz_class &z) { return fmt::format("{}({})", type, z.get_str()); };
  if (q.get_den() == 1)
    return integer(q.get_num());
  return fmt::format("({} / {})", integer(q.get_num()), integer(q.get_den()));
}

// Writes nodes in id order; a node used once is folded into its user while that stays readable.
class writer {
public:
  // wide[id]: the node is of type W.
  writer(const ir::program &p, std::function<std::string(int)> input, std::string type, std::string indent,
         const std::vector<node_id> &order, std::vector<char> wide = {})
      : p_(p), input_(std::move(input)), type_(std::move(type)), indent_(std::move(indent)), wide_(std::move(wide)) {
    for (const node_id id : order) {
      const node &n = p.nodes.at(id);
      if (n.kind != op::input && n.kind != op::constant)
        for (const node_id operand : {n.a, n.b, n.c})
          if (operand >= 0)
            ++uses_[operand];
    }
  }

  void name(node_id id, std::string text, bool atom = true) { text_[id] = {std::move(text), atom}; }
  bool used(node_id id) const { return uses_.count(id) > 0; }

  void write(node_id id, bool keep) {
    const node &n = p_.nodes.at(id);
    std::string text;
    bool atom = false;
    switch (n.kind) {
    case op::input:
      text = input_(n.a);
      atom = true;
      break;
    case op::constant:
      text = constant_text(p_.nodes.value(id), type_);
      atom = true;
      break;
    case op::negate:
      text = '-' + factor(n.a);
      break;
    case op::add:
      text = fmt::format("{} + {}", term(n.a), term(n.b));
      break;
    case op::subtract:
      text = fmt::format("{} - {}", term(n.a), factor(n.b));
      break;
    case op::multiply:
      if (is_wide(id) && !is_wide(n.a) && !is_wide(n.b)) {
        text = fmt::format("meetc::times<W>({}, {})", plain(n.a), plain(n.b));
        atom = true;
      } else {
        text = fmt::format("{} * {}", factor(n.a), factor(n.b));
      }
      break;
    case op::fused:
      text = fmt::format("meetc::fma({}, {}, {})", plain(n.a), plain(n.b), plain(n.c));
      atom = true;
      break;
    }
    const bool trivial = n.kind == op::input || n.kind == op::constant;
    const bool single = uses_[id] <= 1 && !keep;
    if (trivial || (single && text.size() <= longest_inline)) {
      text_[id] = {text, atom};
      return;
    }
    const std::string t = fmt::format("t{}", next_++);
    out_ += fmt::format("{}const {} {} = {};\n", indent_, is_wide(id) ? "W" : type_, t, text);
    text_[id] = {t, true};
  }

  bool is_wide(node_id id) const { return !wide_.empty() && wide_[static_cast<std::size_t>(id)]; }
  std::string plain(node_id id) const { return text_.at(id).first; }
  std::string take() { return std::move(out_); }
  void line(const std::string &statement, const std::string &remark = "") {
    if (remark.empty())
      out_ += indent_ + statement + '\n';
    else if (indent_.size() + statement.size() + remark.size() < 106)
      out_ += indent_ + statement + " // " + remark + '\n';
    else
      out_ += indent_ + "// " + remark + '\n' + indent_ + statement + '\n';
  }

private:
  const ir::program &p_;
  std::function<std::string(int)> input_;
  std::string type_, indent_, out_;
  std::vector<char> wide_;
  std::map<node_id, int> uses_;
  std::map<node_id, std::pair<std::string, bool>> text_; // and whether it needs no parentheses
  int next_ = 0;

  std::string factor(node_id id) const {
    const auto &[text, atom] = text_.at(id);
    return atom ? text : '(' + text + ')';
  }
  // The left side of a sum, or the right side of '+': only sums need no care there, but order must not change.
  std::string term(node_id id) const {
    const op kind = p_.nodes.at(id).kind;
    const auto &[text, atom] = text_.at(id);
    return atom || kind == op::multiply ? text : '(' + text + ')';
  }
};

} // namespace

std::string body(const ir::program &p, const body_names &names, const std::string &indent) {
  const std::vector<node_id> order = ir::needed(p.nodes, p.results);
  writer w(p, names.input, names.type, indent, order);
  std::map<node_id, int> results;
  for (const node_id r : p.results)
    ++results[r];
  for (const node_id id : order)
    w.write(id, results[id] > 1);
  for (std::size_t i = 0; i < p.results.size(); ++i)
    w.line(names.result(i, w.plain(p.results[i])));
  return w.take();
}

parts split_body(const ir::program &p, const std::function<std::string(int)> &input, bool mixed,
                 const std::vector<std::string> &remarks, const std::string &indent) {
  using poly::residency;
  const std::vector<node_id> order = ir::needed(p.nodes, p.results);
  const auto computed = [&](node_id id) {
    const op kind = p.nodes.at(id).kind;
    return kind != op::input && kind != op::constant;
  };
  // A value of one object is stored when the pair reads it.
  std::set<node_id> stored;
  std::map<node_id, node_id> negative_of; // what is read as the negative of a stored value, or of an input
  const auto read_by_pair = [&](node_id id) {
    if (id < 0 || !computed(id) || p.nodes.where(id) == residency::pair || p.nodes.where(id) == residency::scene)
      return;
    if (p.nodes.at(id).kind == op::negate) {
      const node_id of = p.nodes.at(id).a;
      negative_of[id] = of;
      id = of;
    }
    if (computed(id))
      stored.insert(id);
  };
  for (const node_id id : order)
    if (computed(id) && p.nodes.where(id) == residency::pair)
      for (const node_id operand : {p.nodes.at(id).a, p.nodes.at(id).b, p.nodes.at(id).c})
        read_by_pair(operand);
  for (const node_id r : p.results)
    read_by_pair(r);
  std::vector<char> wide(mixed ? p.nodes.size() : 0);
  if (mixed) {
    const std::vector<ir::magnitude> all = ir::magnitudes(p);
    for (const node_id id : order)
      wide[static_cast<std::size_t>(id)] = all[static_cast<std::size_t>(id)].degree >= 3;
  }
  parts out;
  std::map<node_id, std::string> field;
  const auto object = [&](residency where, const char *array, int &count) {
    std::vector<node_id> here;
    for (const node_id id : stored)
      if (p.nodes.where(id) == where)
        here.push_back(id);
    const std::vector<node_id> needed = ir::needed(p.nodes, here);
    writer w(p, input, "T", indent, needed);
    for (const node_id id : needed)
      if (p.nodes.where(id) == where || !computed(id))
        w.write(id, stored.count(id) > 0 && w.used(id));
    for (const node_id id : order)
      if (stored.count(id) && p.nodes.where(id) == where) {
        w.line(fmt::format("f[{}] = {};", count, w.plain(id)));
        field[id] = fmt::format("{}[{}]", array, count++);
      }
    return w.take();
  };
  out.object_a = object(residency::a, "fa", out.fields_a);
  out.object_b = object(residency::b, "fb", out.fields_b);
  writer w(p, input, "T", indent, order, wide);
  std::map<node_id, int> results;
  for (const node_id r : p.results)
    ++results[r];
  for (const node_id id : order) {
    if (const auto it = field.find(id); it != field.end())
      w.name(id, it->second);
    else if (const auto negative = negative_of.find(id); negative != negative_of.end())
      w.name(id, '-' + w.plain(negative->second), false);
    else if (!computed(id) || p.nodes.where(id) == residency::pair || p.nodes.where(id) == residency::scene)
      w.write(id, results[id] > 1);
  }
  for (std::size_t i = 0; i < p.results.size(); ++i)
    w.line(fmt::format(fmt::runtime(mixed && !w.is_wide(p.results[i]) ? "v[{}] = W({});" : "v[{}] = {};"), i,
                       w.plain(p.results[i])),
           remarks[i]);
  out.pair = w.take();
  return out;
}

std::string count_text(const ir::counts &c) {
  const auto number = [](int n, const char *what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  return number(c.multiplications + c.fused, "multiplication") + ", " + number(c.additions + c.fused, "addition");
}

std::string poly_with_names(const poly::poly &p, const std::vector<std::string> &names) {
  const poly::ring renamed(names);
  return poly::poly::from_terms(renamed, p.terms()).text();
}

std::string wrapped(const std::string &text, const std::string &prefix, std::size_t width) {
  std::string out;
  std::size_t from = 0;
  std::string lead = prefix;
  while (lead.size() + text.size() - from > width) {
    std::size_t cut = text.rfind(' ', from + width - lead.size());
    // Break before a '+' or '-' that stands between spaces.
    while (cut != std::string::npos && cut > from && !(cut + 2 < text.size() && text[cut + 2] == ' '))
      cut = text.rfind(' ', cut - 1);
    if (cut == std::string::npos || cut <= from)
      break;
    out += lead + text.substr(from, cut - from) + '\n';
    from = cut + 1;
    lead = prefix + "    ";
  }
  return out + lead + text.substr(from) + '\n';
}

} // namespace meetc::target
