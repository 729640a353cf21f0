#include "gen/target/cpp/stored_values.hpp"

#include "gen/target/cpp/body.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

// All code for one operand, with its stored numbers as row[0], row[1], ...: equal texts compute equal values. Empty if
// nothing is stored.
std::string stored_text(const emitted_predicate &p, int operand) {
  const auto row = [&](int input) {
    return fmt::format("row[{}]", operand == 0 ? input : input - p.kernel.decision.inputs_a);
  };
  std::string out;
  const auto add = [&](const ir::program &code, const std::function<std::string(int)> &input) {
    const stored_body stored = stored_parts(code, {input, {}, "float"}, "");
    out += operand == 0 ? stored.object_a : stored.object_b;
  };
  for (const emitted_stage &s : p.stages) {
    if (s.code == &p.kernel.decision.rare)
      continue;
    add(s.code->code, row);
    if (!s.bounds)
      continue;
    const std::size_t before = out.size();
    add(s.bounds->magnitudes, [&](int i) {
      const bound::leaf &l = s.bounds->leaves[static_cast<std::size_t>(i)];
      return l.subtrahend < 0 ? row(l.minuend) : fmt::format("({} - {})", row(l.minuend), row(l.subtrahend));
    });
    if (out.size() > before)
      out += fmt::format("floor {}\n", s.bounds->floor_fp32);
  }
  return out;
}

} // namespace

stored_numbers number_stored(const unit &u) {
  stored_numbers out;
  std::map<std::string, std::map<std::string, int>> known; // by kind
  for (std::size_t i = 0; i < u.kernels.size(); ++i) {
    const lower::kernel &k = u.kernels[i];
    if (!lower::on_sets(k))
      continue;
    const emitted_predicate p(u, i);
    for (int operand = 0; operand < 2; ++operand) {
      const std::string &kind = k.asked.kinds[static_cast<std::size_t>(operand)]->name;
      int &number = out.of[&k][static_cast<std::size_t>(operand)] = -1;
      if (const std::string text = stored_text(p, operand); !text.empty())
        number = known[kind].try_emplace(text, static_cast<int>(known[kind].size())).first->second;
    }
  }
  for (const auto &[kind, texts] : known)
    out.count[kind] = static_cast<int>(texts.size());
  return out;
}

} // namespace meetc::target
