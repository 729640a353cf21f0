#include "gen/target/cpp/bytecode.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <stdexcept>

namespace meetc::target {
namespace {
using ir::node;
using ir::node_id;
using ir::op;

// Registers are taken again once the value in them has been read for the last time.
class scheduler {
public:
  scheduler(const ir::program &p, int inputs) : p_(p), register_count_(inputs) {
    const std::vector<node_id> order = ir::needed(p.nodes, p.results);
    for (const node_id id : order)
      for (const node_id operand : operands(id))
        ++readers_[operand];
    for (const node_id r : p.results)
      ++readers_[r];
    for (const node_id id : order) {
      compute(id);
      for (std::size_t i = 0; i < p.results.size(); ++i)
        if (p.results[i] == id) {
          add("take_sign", static_cast<int>(i), held_in_.at(id), 0);
          read(id);
        }
    }
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
  const ir::program &p_;
  int register_count_;
  std::set<int> free_;
  std::map<node_id, int> readers_, held_in_;
  std::vector<std::string> code_;

  std::vector<node_id> operands(node_id id) const {
    const node &n = p_.nodes.at(id);
    std::vector<node_id> out;
    if (n.kind != op::input && n.kind != op::constant)
      for (const node_id operand : {n.a, n.b, n.c})
        if (operand >= 0)
          out.push_back(operand);
    return out;
  }
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
  void read(node_id id) {
    if (--readers_[id] == 0)
      free_.insert(held_in_.at(id));
  }
  void compute(node_id id) {
    const node &n = p_.nodes.at(id);
    if (n.kind == op::input) {
      held_in_[id] = n.a;
      return;
    }
    const int r = take();
    const auto at = [&](node_id operand) { return held_in_.at(operand); };
    switch (n.kind) {
    case op::input:
      break;
    case op::constant: {
      const mpz_class z = abs(p_.nodes.value(id).get_num()); // an integer of at most 53 bits
      const unsigned long v = z.get_ui();
      add("constant", r, static_cast<int>(v & 0xffff), static_cast<int>(v >> 16 & 0xffff));
      if (v >> 32)
        add("raise", r, static_cast<int>(v >> 32 & 0xffff), static_cast<int>(v >> 48));
      if (p_.nodes.value(id) < 0)
        add("negate", r, r, 0);
      break;
    }
    case op::negate:
      add("negate", r, at(n.a), 0);
      break;
    case op::add:
      add("add", r, at(n.a), at(n.b));
      break;
    case op::subtract:
      add("subtract", r, at(n.a), at(n.b));
      break;
    case op::multiply:
      add("multiply", r, at(n.a), at(n.b));
      break;
    case op::fused:
      add("multiply", r, at(n.a), at(n.b));
      add("add", r, r, at(n.c));
      break;
    }
    held_in_[id] = r;
    for (const node_id operand : operands(id))
      read(operand);
  }
};
} // namespace

std::string bytecode_text(const ir::program &p, int inputs) {
  return scheduler(p, inputs).text();
}

} // namespace meetc::target
