#include "gen/lower/tolerance.hpp"

#include "gen/ir/evaluate.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace meetc::lower {
namespace {

constexpr int shortest = 62, longest = 126; // bits of values, without their sign, in 64 and in 128 bits

// Half of the root of the number of dimensions, rounded up: how far rounding moves a point, in steps.
rational half_root(std::size_t dimensions) {
  switch (dimensions) {
  case 1:
    return rational(1, 2);
  case 2:
    return rational(7071068, 10000000);
  default:
    return rational(8660255, 10000000);
  }
}

struct operand_shape {
  enclosure around;
  rational moves; // in steps
};

struct tolerant_kernel {
  const kernel *of;
  const bound::kernel_bounds *bounds;
  std::array<operand_shape, 2> operands;
  rational moves() const { return operands[0].moves + operands[1].moves; } // in steps
};

std::string in_words(const rational &q) {
  return fmt::format("{:.3g}", q.get_d());
}

// Throws where no short move is proved to mend a wrong answer of the predicate.
tolerant_kernel offered(const model &m, const kernel &k, const bound::kernel_bounds &bounds) {
  tolerant_kernel out{&k, &bounds, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    operand_shape &o = out.operands[i];
    const lang::kind &kind = *k.asked.kinds[i];
    o.around = enclosing(m, kind);
    if (o.around.hull.empty())
      throw spec_error(k.asked.where,
                       fmt::format("'{}' keeps no tolerance: the kind {} has no hull, so that nothing is "
                                   "known of moving it; ask for the rung certified",
                                   k.asked.text, kind.name));
    std::size_t dimensions = 0;
    for (const std::vector<int> &point : o.around.hull)
      dimensions = std::max(dimensions, point.size());
    o.moves = half_root(dimensions) + (o.around.pad >= 0 ? rational(1, 2) : rational(0));
    const auto reals = m.layout(kind).reals;
    for (std::size_t r = 0; r < reals.size(); ++r)
      if (!reals[r].position && static_cast<int>(r) != o.around.pad)
        throw spec_error(k.asked.where, fmt::format("'{}' keeps no tolerance: {} of {} is neither a coordinate nor the "
                                                    "pad, so that rounding it may move anything",
                                                    k.asked.text, reals[r].path, kind.name));
  }
  if (k.asked.asked->means != lang::meaning::touch)
    throw spec_error(k.asked.where, fmt::format("'{}' keeps no tolerance: its meaning is not 'touch', so that no short "
                                                "move is proved to mend its wrong answers; ask for the rung certified",
                                                k.asked.text));
  if (!bounds.groups.weights.empty())
    throw spec_error(k.asked.where, fmt::format("'{}' keeps no tolerance: its signs are homogeneous only in groups of "
                                                "numbers, each with a grid of its own; ask for the rung certified",
                                                k.asked.text));
  if (k.asked.asked->mode == "surface" &&
      (out.operands[0].around.hull.size() > 1 || out.operands[1].around.hull.size() > 1))
    throw spec_error(k.asked.where,
                     fmt::format("'{}' keeps no tolerance: no short move is proved to take an element into "
                                 "a surface, as where both ends of a segment are on a sphere around its "
                                 "middle; ask for the rung certified",
                                 k.asked.text));
  return out;
}

poly::poly square(const poly::poly &p) {
  return p * p;
}

// Whether the kernel has one sign, that of c (d^2 - R^2), and its magnitude is |c| (d^2 + R^2).
bool compares_a_distance(const tolerant_kernel &k) {
  const predicate &d = k.of->decision;
  const bound::stage_bounds &b = k.bounds->common;
  const enclosure &x = k.operands[0].around, &y = k.operands[1].around;
  if (!d.reject.atoms.empty() || !d.rare.atoms.empty() || d.common.atoms.size() != 1 || x.hull.size() != 1 ||
      y.hull.size() != 1 || x.hull[0].size() != y.hull[0].size() || k.of->asked.asked->mode == "surface")
    return false;
  const auto number = [&d](int i) { return poly::poly::variable(*d.numbers, i); };
  const auto length = [&](const enclosure &e, int from) {
    return e.pad < 0 ? poly::poly(*d.numbers) : number(from + e.pad);
  };
  poly::poly distance(*d.numbers);
  for (std::size_t axis = 0; axis < x.hull[0].size(); ++axis)
    distance = distance + square(number(x.hull[0][axis]) - number(d.inputs_a + y.hull[0][axis]));
  const poly::poly lengths = square(length(x, 0) + length(y, d.inputs_a));
  const auto [content, primitive] = d.signs.atoms()[static_cast<std::size_t>(d.common.atoms[0])].primitive();
  if (!(primitive == (distance - lengths).primitive().second))
    return false;
  // The magnitude, as a polynomial in the leaves: one for each difference, and one for each length.
  std::vector<std::string> names;
  for (std::size_t i = 0; i < b.leaves.size(); ++i)
    names.push_back(fmt::format("l{}", i));
  const poly::ring ring(names);
  poly::poly differences(ring), pads(ring);
  for (std::size_t i = 0; i < b.leaves.size(); ++i) {
    const poly::poly leaf = poly::poly::variable(ring, static_cast<int>(i));
    if (b.leaves[i].subtrahend >= 0)
      differences = differences + square(leaf);
    else
      pads = pads + leaf;
  }
  const std::vector<poly::poly> magnitude = ir::to_poly(b.magnitudes, ring);
  return magnitude.size() == 1 && magnitude[0] == (differences + square(pads)).scaled(abs(content));
}

// The move that mends a wrong answer of such a kernel in plain fp32, in a box.
rational distance_error(const tolerant_kernel &k, const rational &box) {
  const bound::stage_bounds &b = k.bounds->common;
  const int theta = std::max(b.fp32[0].theta, b.unfused->bounds.fp32[0].theta);
  rational growth = 1;
  for (int i = 0; i < theta; ++i)
    growth *= 1 + bound::power_of_two(-bound::fp32.precision);
  // If an answer is wrong, d is within a thousandth of R, and R is the sum of two lengths of at most 2 box. The last
  // term is more than the root of what underflows.
  return (growth - 1) * 8 * box * rational(1001, 1000) + bound::power_of_two(-70);
}

int bits_of(const mpz_class &n) {
  return n == 0 ? 0 : static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2));
}

mpz_class ceiling(const rational &q) {
  mpz_class out;
  mpz_cdiv_q(out.get_mpz_t(), q.get_num().get_mpz_t(), q.get_den().get_mpz_t());
  return out;
}

// The largest power of two that is at most q > 0.
int floor_log2(const rational &q) {
  int k = bits_of(q.get_num()) - bits_of(q.get_den());
  while (bound::power_of_two(k) > q)
    --k;
  return k;
}

// The bits of differences for which every value has at most `most` bits.
int longest_differences(const bound::kernel_bounds &b, int most) {
  int out = most;
  for (const bound::stage_bounds *s : {&b.reject, &b.common, &b.rare})
    if (s->degree > 0)
      out = std::min(out, (most - s->growth) / s->degree);
  return out;
}

// The exponent of the coarsest grid that keeps the tolerance for these kernels; for all of them if none is named. No grid
// is coarser than a float32.
int grid_for(const std::map<std::size_t, tolerant_kernel> &all, const std::set<std::size_t> &of,
             const rational &tolerance) {
  rational most;
  for (const auto &[i, k] : all)
    if (of.empty() || of.count(i))
      most = std::max(most, k.moves());
  return std::min(floor_log2(tolerance / most), 127);
}

tolerant_way on_grid(const tolerant_kernel &k, const lang::scene &s, int low) {
  const rational step = bound::power_of_two(low), box(s.box);
  const mpz_class steps = ceiling(box / step); // the largest |coordinate|; a length has at most twice as many
  tolerant_way out;
  out.low = low;
  out.bits = bits_of(2 * steps - 1); // the least with 2 steps <= 2^bits
  out.reach = rational(steps) * step;
  out.moves = k.moves() * step;
  const int most = longest_differences(*k.bounds, longest);
  if (out.bits > most)
    throw spec_error(
        s.tolerance_where,
        fmt::format("'{}' needs integers of more than 128 bits for a tolerance of {} in a box of {}: state a "
                    "box of at most {}, or a larger tolerance",
                    k.of->asked.text, in_words(s.tolerance), in_words(s.box),
                    in_words(bound::power_of_two(most - 1) * step)));
  out.width = out.bits <= longest_differences(*k.bounds, shortest) ? 64 : 128;
  return out;
}

} // namespace

tolerance_plan plan_tolerance(const model &m, const lang::scene &s, const std::vector<kernel> &kernels,
                              const std::vector<std::optional<bound::kernel_bounds>> &bounds) {
  tolerance_plan out;
  out.ways.resize(kernels.size());
  out.refusals.resize(kernels.size());
  const bool has_others = s.asks(lang::rung::exact) || s.asks(lang::rung::certified);
  std::map<std::size_t, tolerant_kernel> all;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const kernel &k = kernels[i];
    if (k.is_sign && s.rungs == std::vector{lang::rung::tolerant})
      throw spec_error(k.asked.where,
                       fmt::format("'{}' is one sign, and nothing says which move changes it: ask for the "
                                   "rung certified beside tolerant",
                                   k.asked.text));
    if (!k.is_predicate || k.is_sign)
      continue;
    try {
      all.emplace(i, offered(m, k, bounds[i].value()));
    } catch (const spec_error &e) {
      if (!has_others)
        throw;
      out.refusals[i] = e.message();
    }
  }
  if (all.empty())
    return out;
  const rational tolerance(s.tolerance);
  if (s.box == 0) {
    int most = longest;
    for (const auto &[i, k] : all)
      most = std::min(most, longest_differences(*k.bounds, longest));
    throw spec_error(s.tolerance_where,
                     fmt::format("scene.tolerance cannot be proved without scene.box, the largest coordinate: for this "
                                 "tolerance state one of at most {}",
                                 in_words(bound::power_of_two(most - 1 + grid_for(all, {}, tolerance)))));
  }
  const rational box(s.box);
  // The kernels that keep the tolerance by the grid; the others compare a distance in plain fp32, beside the grid.
  std::set<std::size_t> by_grid;
  const auto beside = [&](const tolerant_kernel &k, const std::optional<int> &low) -> std::optional<tolerant_way> {
    tolerant_way w;
    w.by_distance = true;
    const rational step = low ? bound::power_of_two(*low) : rational(0);
    w.low = low.value_or(0);
    w.beside_grid = low.has_value();
    w.reach = low ? rational(ceiling(box / step)) * step : box;
    w.moves = distance_error(k, w.reach) + k.moves() * step;
    // In a larger box the squares overflow.
    const bool fits = 2 * w.reach <= bound::power_of_two(k.bounds->common.box_highest);
    return fits && w.moves <= tolerance ? std::optional(w) : std::nullopt;
  };
  for (const auto &[i, k] : all)
    if (!compares_a_distance(k) || !beside(k, std::nullopt))
      by_grid.insert(i);
  for (bool again = !by_grid.empty(); again;) {
    again = false;
    out.low = grid_for(all, by_grid, tolerance);
    for (const auto &[i, k] : all)
      if (!by_grid.count(i) && !beside(k, out.low)) // then its own share of the tolerance counts too
        again = by_grid.insert(i).second;
  }
  if (out.low && *out.low < -149)
    throw spec_error(s.tolerance_where, "scene.tolerance is below the spacing of float32: ask for the rung certified");
  for (const auto &[i, k] : all)
    out.ways[i] = by_grid.count(i) ? on_grid(k, s, *out.low) : beside(k, out.low);
  return out;
}

} // namespace meetc::lower
