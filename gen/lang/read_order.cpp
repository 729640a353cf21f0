// The key `order` of [algebra]: the order and the signs of basis blades in output.
#include "gen/lang/operators.hpp"
#include "gen/lang/read_basis.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace meetc::lang {
namespace {

using vectors = std::vector<std::string>;
using vector_set = std::set<std::string>;

std::size_t grade(const ordered_blade &b) {
  return b.vectors.size();
}

vector_set set_of(const ordered_blade &b) {
  return {b.vectors.begin(), b.vectors.end()};
}

std::string as_written(const vectors &of) {
  return of.empty() ? "1" : join(of, "^");
}

class order_reader {
public:
  explicit order_reader(const algebra &a) : a_(a), known_(a.vectors) {
    for (const named_expr &n : a.null)
      known_.push_back(n.name);
  }

  ordered_blade read(const expr &e) const {
    ordered_blade out{{}, e.where};
    collect(e, e, out.vectors);
    const vector_set different = set_of(out);
    if (different.size() == grade(out))
      return out;
    const auto twice = std::find_if(out.vectors.begin(), out.vectors.end(), [&](const std::string &v) {
      return std::count(out.vectors.begin(), out.vectors.end(), v) > 1;
    });
    throw spec_error(e.where, fmt::format("'{}' is 0, since {} stands in it twice; leave it out, or write a blade of "
                                          "different vectors",
                                          print(e), *twice));
  }

private:
  const algebra &a_;
  vectors known_;

  void collect(const expr &e, const expr &whole, vectors &out) const {
    if (e.kind == op::outer) {
      collect(*e.args[0], whole, out);
      collect(*e.args[1], whole, out);
    } else if (e.kind == op::name) {
      add(e, out);
    } else if (e.kind == op::number && e.text == "1" && &e == &whole) { // the scalar
    } else if (e.kind == op::number) {
      throw spec_error(e.where, fmt::format("{} is no basis blade; the scalar is '1'", e.text));
    } else if (e.kind == op::negate) {
      throw spec_error(e.where, negated(*e.args[0]));
    } else {
      throw spec_error(e.where,
                       fmt::format("'{}' is no basis blade; write the outer product of its vectors, as in '{}'",
                                   print(e), as_written({a_.vectors.front(), a_.vectors.back()})));
    }
  }

  void add(const expr &e, vectors &out) const {
    if (std::find(known_.begin(), known_.end(), e.text) != known_.end()) {
      out.push_back(e.text);
      return;
    }
    const vectors factors = vectors_of_name(a_, e.text);
    if (factors.empty())
      throw spec_error(e.where, fmt::format("no vector '{}' in this algebra; 'order' lists blades of {}{}", e.text,
                                            join(known_, ", "), nearest(e.text, known_)));
    out.insert(out.end(), factors.begin(), factors.end());
  }

  // The order of the vectors is the sign.
  std::string negated(const expr &e) const {
    vectors of;
    try {
      collect(e, e, of);
    } catch (const spec_error &) {
    }
    if (of.size() < 2)
      return fmt::format("a blade of 'order' has no sign of its own; write '{}'", print(e));
    std::swap(of[0], of[1]);
    return fmt::format("a blade of 'order' takes its sign from the order of its vectors; write '{}'", as_written(of));
  }
};

// The blades of these vectors and of this grade that the list lacks.
std::vector<std::string> missing(const std::vector<ordered_blade> &list, const vectors &of, std::size_t grade_of) {
  std::set<vector_set> have;
  for (const ordered_blade &b : list)
    have.insert(set_of(b));
  std::vector<std::string> out;
  for (std::size_t mask = 0; mask < std::size_t{1} << of.size(); ++mask) {
    vectors blade;
    for (std::size_t i = 0; i < of.size(); ++i)
      if (mask >> i & 1)
        blade.push_back(of[i]);
    if (blade.size() == grade_of && !have.count({blade.begin(), blade.end()}))
      out.push_back('\'' + as_written(blade) + '\'');
  }
  return out;
}

// Lists go by grade, or have all blades of each grade that they name.
void check_grades(const algebra &a) {
  vectors of; // with null vectors, those that the list names, since the others may be replaced
  for (const std::string &v : a.vectors)
    if (a.null.empty())
      of.push_back(v);
  for (const ordered_blade &b : a.order)
    for (const std::string &v : b.vectors)
      if (std::find(of.begin(), of.end(), v) == of.end())
        of.push_back(v);
  for (std::size_t i = 1; i < a.order.size(); ++i) {
    const ordered_blade &b = a.order[i], &before = a.order[i - 1];
    if (grade(b) >= grade(before))
      continue;
    for (const ordered_blade &named : a.order)
      if (const std::vector<std::string> lacks = missing(a.order, of, grade(named)); !lacks.empty())
        throw spec_error(b.where, fmt::format("'{}' has grade {}, and stands behind '{}' of grade {}; write lower "
                                              "grades first, or list all blades of each grade, here {} too",
                                              as_written(b.vectors), grade(b), as_written(before.vectors),
                                              grade(before), join(lacks, ", ")));
  }
}

} // namespace

void read_order(const toml_reader &in, const toml::node &list, algebra &out) {
  out.order.clear();
  const order_reader reader(out);
  for (const toml::node &item : in.as_array(list, "algebra.order")) {
    ordered_blade b = reader.read(*in.as_expression(item, "each item of algebra.order"));
    for (const ordered_blade &other : out.order)
      if (set_of(other) == set_of(b))
        throw spec_error(b.where, fmt::format("'{}' is given twice, here as '{}'; write one of the two",
                                              as_written(other.vectors), as_written(b.vectors)));
    out.order.push_back(std::move(b));
  }
  if (out.order.empty())
    throw spec_error(in.place(list), "algebra.order is empty; leave it out, or list blades in the order of output, as "
                                     "in order = ['e23', 'e31', 'e12']");
  check_grades(out);
}

} // namespace meetc::lang
