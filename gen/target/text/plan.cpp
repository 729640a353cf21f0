// What a scene's tolerance comes to, in words.
#include "gen/target/text/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string number(double v) {
  return fmt::format("{:.3g}", v);
}

struct line {
  std::string kernel, rung, error, why;
};

// A predicate of a scene with a tolerance.
line planned(const lower::kernel &k, const lower::tolerant_way &w) {
  if (w.by_distance)
    return {k.asked.text, "plain fp32", number(w.moves.get_d()),
            "it compares a distance with lengths, and its error is a length; k = 1"};
  return {k.asked.text, fmt::format("fp32 with its bound, then int{}", w.width), number(w.moves.get_d()),
          fmt::format("differences are integers of {} bits on the grid, so that every value fits; k = 2", w.bits)};
}

std::string rungs_of(const lang::scene &s) {
  std::string out;
  for (const lang::rung r : s.rungs)
    out += fmt::format("{}{}", out.empty() ? "" : ", ", lang::info_of(r).name);
  return out;
}

} // namespace

std::string plan_text(const unit &u) {
  const lang::scene &s = u.scene;
  std::string out =
      fmt::format("{}: tolerance {}, box {}, rungs {}\n", s.name, s.tolerance > 0 ? number(s.tolerance) : "none",
                  s.box > 0 ? number(s.box) : "none", rungs_of(s));
  const bool tolerant = u.asks(lang::rung::tolerant);
  if (u.tolerance.low)
    out += fmt::format("All numbers are rounded to multiples of 2^{} ({}).\n", *u.tolerance.low,
                       number(bound::power_of_two(*u.tolerance.low).get_d()));
  else if (tolerant)
    out += "No number is rounded.\n";
  else
    out += "No answer may be wrong, unless a plain rung gives it.\n";
  std::vector<line> lines{{"kernel", "decided by", "moves", "why"}};
  for (std::size_t i = 0; i < u.kernels.size(); ++i) {
    const lower::kernel &k = u.kernels[i];
    if (!k.is_predicate)
      lines.push_back({k.asked.text, "formula", "-", "a value, not an answer"});
    else if (i < u.tolerance.ways.size() && u.tolerance.ways[i])
      lines.push_back(planned(k, *u.tolerance.ways[i]));
    else
      lines.push_back({k.asked.text, "the rungs asked for", "0",
                       tolerant ? "one sign" : "the scene states no tolerance; certified is never wrong"});
  }
  std::size_t widths[3] = {0, 0, 0};
  for (const line &l : lines) {
    widths[0] = std::max(widths[0], l.kernel.size());
    widths[1] = std::max(widths[1], l.rung.size());
    widths[2] = std::max(widths[2], l.error.size());
  }
  for (const line &l : lines)
    out +=
        fmt::format("{:<{}}  {:<{}}  {:>{}}  {}\n", l.kernel, widths[0], l.rung, widths[1], l.error, widths[2], l.why);
  if (tolerant)
    out += "moves: a wrong answer is right again after moving one operand by at most this.\n";
  return out;
}

} // namespace meetc::target
