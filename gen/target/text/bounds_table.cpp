// The bounds of a kernel's signs as a readable table.
#include "gen/target/gappa/gappa.hpp"
#include "gen/target/text/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

// A bound in units of u = 2^-precision, rounded upwards to three decimals.
std::string in_units(const ir::rational &q, int precision) {
  mpz_class thousandths = q.get_num() * 1000;
  thousandths <<= static_cast<mp_bitcnt_t>(precision);
  mpz_cdiv_q(thousandths.get_mpz_t(), thousandths.get_mpz_t(), q.get_den().get_mpz_t());
  return fmt::format("{}.{:03}u", mpz_class(thousandths / 1000).get_str(), mpz_class(thousandths % 1000).get_ui());
}

std::string row(const bound::stage_bounds &b, std::size_t i) {
  const auto magnitude = [](const bound::arithmetic &a, const bound::roundings &r) {
    return fmt::format("{:>5} {:>3} {:>9}", r.theta, r.phi,
                       in_units(bound::rounded_up(bound::factor(a, r), 12), a.precision));
  };
  std::string out = fmt::format("{:>3}  {}  {}  {}  ", b.fp32[i].degree, magnitude(bound::fp32, b.fp32[i]),
                                magnitude(bound::fp64, b.fp64[i]), magnitude(bound::fp64x2, b.fp64x2[i]));
  out += b.box.empty() ? "none" : in_units(b.box[i].value, bound::fp32.precision) + ' ' + powers_text(b.box[i]);
  if (b.zero_if[i]) {
    out += "; zero if";
    for (unsigned c = 0; c < 32; ++c)
      if (b.zero_if[i] >> c & 1)
        out += fmt::format(" {}", c);
  }
  return out;
}

std::string weights_text(const std::vector<int> &weights) {
  std::string out;
  for (const int w : weights)
    out += fmt::format(" {}", w);
  return out;
}

} // namespace

std::string powers_text(const bound::box_bound &b) {
  std::vector<std::string> out;
  const auto add = [&](const char *name, int n) {
    if (n)
      out.push_back(n == 1 ? name : fmt::format("{}^{}", name, n));
  };
  add("alpha", b.a), add("beta", b.b), add("D", b.pair);
  return join(out, " ");
}

std::string bounds_table(const unit &u, std::size_t kernel) {
  check_bounded(u, kernel);
  const lower::predicate &p = u.kernels[kernel].decision;
  std::string out = "u = 2^-24 in fp32, 2^-53 in fp64, 2^-102 in fp64x2; a sign is known where |v| > K M, in fp32 also "
                    "where |v| > c alpha^i beta^j D^k\n";
  for (const bounded_stage &s : bounded_stages(u, kernel)) {
    const bound::stage_bounds &b = s.bounds;
    out += fmt::format("\n{}: {} leaves; those below 2^{} (fp32), 2^{} (fp64) count as that;{}\n"
                       "  exact in fp64{} where differences have at most {} bits on a common grid\n",
                       s.name, b.leaves.size(), b.floor_fp32, b.floor_fp64,
                       b.box.empty() ? "" : fmt::format(" D from 2^{} to 2^{};", b.box_lowest, b.box_highest),
                       b.mixed ? ", in fp64x2 from degree 3," : "", b.window);
    const char *const each = "theta phi         K";
    out += fmt::format("{:>8}  deg  {:<19}{:<19}{:<19}box form\n{:>8}       {}  {}  {}  c\n", "signs", "fp32", "fp64",
                       "fp64x2", "", each, each, each);
    for (std::size_t i = 0, next; i < b.fp32.size(); i = next) {
      const std::string text = row(b, i);
      for (next = i + 1; next < b.fp32.size() && row(b, next) == text; ++next)
        ;
      out += fmt::format("{:>8}  {}\n", next == i + 1 ? fmt::format("{}", i) : fmt::format("{}-{}", i, next - 1), text);
    }
  }
  const bound::grading &groups = u.bounds[kernel]->groups;
  for (std::size_t i = 0; i < groups.weights.size(); ++i)
    out += fmt::format("{}  {}:{}\n", i ? "" : "\nweights in the groups of numbers, each with a grid of its own\n",
                       p.stored_inputs[i], weights_text(groups.weights[i]));
  const auto point = [&](const std::vector<int> &inputs) {
    std::vector<std::string> names;
    for (const int i : inputs)
      names.push_back(p.stored_inputs[static_cast<std::size_t>(i)]);
    return join(names, ", ");
  };
  for (std::size_t i = 0; i < u.bounds[kernel]->coincidences.size(); ++i) {
    const bound::coincidence &c = u.bounds[kernel]->coincidences[i];
    out +=
        fmt::format("{}  {:>2}: ({}) = ({})\n", i ? "" : "\nequal points that make signs zero or settle the decision\n",
                    i, point(c.x), point(c.y));
  }
  for (const std::uint32_t set : u.bounds[kernel]->settled_by) {
    out += "a hit where all of these hold:";
    for (unsigned c = 0; c < bound::most_coincidences; ++c)
      if (set >> c & 1)
        out += fmt::format(" {}", c);
    out += '\n';
  }
  return out;
}

} // namespace meetc::target
