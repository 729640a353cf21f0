// The plan for a scene's tolerance, in words.
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
            w.beside_grid ? "it compares a distance with lengths, and its error is a length; k = 1, and 2 for the grid"
                          : "it compares a distance with lengths, and its error is a length; k = 1"};
  return {k.asked.text, fmt::format("fp32 with its bound, then int{}", w.width), number(w.moves.get_d()),
          fmt::format("no difference exceeds 2^{} steps of the grid, so that every value fits; k = 2", w.bits)};
}

// A kernel of signs that the tolerance does not change.
line unplanned(const unit &u, std::size_t i) {
  const lower::kernel &k = u.kernels[i];
  const bool never_wrong = u.asks(lang::rung::certified) || u.asks(lang::rung::exact);
  const std::string refusal = i < u.tolerance.refusals.size() ? u.tolerance.refusals[i] : "";
  const char *const why = !refusal.empty()        ? refusal.c_str()
                          : k.is_sign             ? "one sign, which no tolerance is about"
                          : u.scene.tolerance > 0 ? "the scene does not ask for the rung tolerant"
                          : never_wrong           ? "the scene states no tolerance"
                                                  : "the scene states no tolerance, and plain rungs promise nothing";
  return {k.asked.text,
          u.asks(lang::rung::certified) ? "certified"
          : never_wrong                 ? "exact"
                                        : "plain rungs",
          never_wrong ? "0" : "-", why};
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
  std::vector<line> lines{{"kernel", "decided by", "moves", "why"}};
  for (std::size_t i = 0; i < u.kernels.size(); ++i) {
    const lower::kernel &k = u.kernels[i];
    if (!k.is_predicate)
      lines.push_back({k.asked.text, "formula", "-", "a value, not an answer"});
    else if (i < u.tolerance.ways.size() && u.tolerance.ways[i])
      lines.push_back(planned(k, *u.tolerance.ways[i]));
    else
      lines.push_back(unplanned(u, i));
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
