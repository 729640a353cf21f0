#include "gen/ir/print.hpp"

#include "gen/ir/fold.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::ir {
namespace {

// Writes each node as it is visited; a value is the name of a node.
struct printer {
  using value = std::string;
  const std::vector<std::string> &inputs;
  const std::vector<node_id> &stored;
  std::string out;

  value line(const node_ref &at, const std::string &operation) {
    out += fmt::format("  %{} = {}  ; {}{}\n", at.id, operation, name_of(at.where()),
                       std::binary_search(stored.begin(), stored.end(), at.id) ? ", stored" : "");
    return fmt::format("%{}", at.id);
  }
  value input(const node_ref &at, int number) { return line(at, "input " + inputs[static_cast<std::size_t>(number)]); }
  value constant(const node_ref &at, const rational &q) { return line(at, "constant " + q.get_str()); }
  value negate(const node_ref &at, const value &x) { return line(at, "negate " + x); }
  value add(const node_ref &at, const value &x, const value &y) { return line(at, "add " + x + ' ' + y); }
  value subtract(const node_ref &at, const value &x, const value &y) { return line(at, "subtract " + x + ' ' + y); }
  value multiply(const node_ref &at, const value &x, const value &y) { return line(at, "multiply " + x + ' ' + y); }
  value fused(const node_ref &at, const value &x, const value &y, const value &z) {
    return line(at, "fma " + x + ' ' + y + ' ' + z);
  }
};

} // namespace

const char *name_of(residency where) {
  static const char *const names[] = {"scene", "A", "B", "pair"};
  return names[static_cast<int>(where)];
}

std::string print(const program &p, const std::vector<std::string> &inputs) {
  printer d{inputs, p.stored, {}};
  fold(p, d);
  for (std::size_t i = 0; i < p.results.size(); ++i)
    d.out += fmt::format("  result[{}] = %{}\n", i, p.results[i]);
  return d.out;
}

} // namespace meetc::ir
