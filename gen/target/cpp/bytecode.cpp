#include "gen/target/cpp/predicate.hpp"

#include "gen/ir/fold.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <stdexcept>

namespace meetc::target {
namespace {
using ir::node_id;
using ir::node_ref;

// A value and the register that holds it.
struct held {
  node_id id;
  int in;
};

// The domain of the fold that writes instructions. A register is reused once its value has been read for the last
// time.
class scheduler {
public:
  using value = held;

  scheduler(const ir::program &p, int inputs) : results_(p.results), register_count_(inputs) {
    for (const node_id id : ir::needed(p.nodes, p.results))
      for (const node_id operand : ir::operands(p.nodes.at(id)))
        ++readers_[operand];
    for (const node_id r : p.results)
      ++readers_[r];
  }

  // ---- the domain ----
  value input(const node_ref &at, int number) { return made(at, number, {}); }
  value constant(const node_ref &at, const ir::rational &q) {
    const mpz_class z = abs(q.get_num()); // an integer of at most 53 bits
    const unsigned long v = z.get_ui();
    const int r = take();
    add("constant", r, static_cast<int>(v & 0xffff), static_cast<int>(v >> 16 & 0xffff));
    if (v >> 32)
      add("raise", r, static_cast<int>(v >> 32 & 0xffff), static_cast<int>(v >> 48));
    if (q < 0)
      add("negate", r, r, 0);
    return made(at, r, {});
  }
  value negate(const node_ref &at, const value &x) {
    const int r = take();
    add("negate", r, x.in, 0);
    return made(at, r, {x});
  }
  value add(const node_ref &at, const value &x, const value &y) { return made(at, combine("add", x, y), {x, y}); }
  value subtract(const node_ref &at, const value &x, const value &y) {
    return made(at, combine("subtract", x, y), {x, y});
  }
  value multiply(const node_ref &at, const value &x, const value &y) {
    return made(at, combine("multiply", x, y), {x, y});
  }
  value fused(const node_ref &at, const value &x, const value &y, const value &z) {
    const int r = combine("multiply", x, y);
    add("add", r, r, z.in);
    return made(at, r, {x, y, z});
  }

  std::string text() const {
    std::string list, line = "     ";
    for (const std::string &s : code_) {
      if (line.size() + s.size() > 108) {
        list += line + '\n';
        line = "     ";
      }
      line += ' ' + s + ',';
    }
    line.pop_back();
    return fmt::format("  // The same program as bytecode, for integers of any width.\n"
                       "  static constexpr int registers = {}, instruction_count = {};\n"
                       "  MEETC_HD static meetc::instruction instruction_at(int i) {{\n"
                       "    using enum meetc::opcode;\n"
                       "    static constexpr meetc::instruction all[] = {{\n{}{}}};\n    return all[i];\n  }}\n",
                       register_count_, code_.size(), list, line);
  }

private:
  const std::vector<node_id> &results_;
  int register_count_;
  std::set<int> free_;
  std::map<node_id, int> readers_;
  std::vector<std::string> code_;

  void add(const char *kind, int r, int a, int b) {
    if (std::max({r, a, b}) > 0xffff)
      throw std::logic_error("a stage has too many values");
    code_.push_back(fmt::format("{{{}, {}, {}, {}}}", kind, r, a, b));
  }
  int take() {
    if (free_.empty())
      return register_count_++;
    const int p = *free_.begin();
    free_.erase(free_.begin());
    return p;
  }
  int combine(const char *kind, const value &x, const value &y) {
    const int r = take();
    add(kind, r, x.in, y.in);
    return r;
  }
  void read(const value &x) {
    if (--readers_[x.id] == 0)
      free_.insert(x.in);
  }
  // The value of this node, computed from `operands`; if it is a result, its sign is taken at once.
  value made(const node_ref &at, int r, std::initializer_list<value> operands) {
    const value out{at.id, r};
    for (const value &x : operands)
      read(x);
    for (std::size_t i = 0; i < results_.size(); ++i)
      if (results_[i] == at.id) {
        add("take_sign", static_cast<int>(i), r, 0);
        read(out);
      }
    return out;
  }
};
} // namespace

std::string bytecode_text(const ir::program &p, int inputs) {
  scheduler s(p, inputs);
  ir::fold(p, s);
  return s.text();
}

} // namespace meetc::target
