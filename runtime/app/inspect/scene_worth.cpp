#include "meet/app/inspect/scene_worth.hpp"

#include "meet/app/query/collide_sets.hpp"
#include "meet/app/text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meetc::app {

namespace {

struct timed {
  answers found;
  double seconds = 0; // to prepare and to collide
};

// The fastest of three runs, or of those up to the first that takes more than two seconds.
timed run(const io::element_set &a, const io::element_set &b, const query &q) {
  timed out;
  for (int i = 0; i < 3; ++i) {
    answers found = collide_sets(a, b, q);
    const double seconds = found.prepare_seconds + found.collide_seconds;
    if (i == 0 || seconds < out.seconds)
      out = {std::move(found), seconds};
    if (seconds > 2)
      break;
  }
  return out;
}

std::string milliseconds(double seconds) {
  return fmt::format("{:.3g} ms", seconds * 1e3);
}

std::string unsure(const answers &f) {
  return fmt::format("{} of {} pairs left to fp64, {} to fp64x2, {} to exact", grouped(f.rungs.unsure[0]),
                     grouped(f.candidates), grouped(f.rungs.unsure[1]), grouped(f.rungs.unsure[2]));
}

} // namespace

std::string worth_of_scene(const catalogue &all, const io::element_set &a, const io::element_set &b, const choice &by,
                           double box, double tolerance) {
  query q;
  q.by = by;
  const timed certified = run(a, b, q);
  std::string out = fmt::format(
      "The gain from the lines of the scene, by queries of {} with the kernels of this program\n"
      "   kernels     no more than these files need, of {} predicates; meetc compare default.toml SCENE shows "
      "the saving\n"
      "   certified   {}: {} pairs; {}\n",
      by.predicate->name, all.predicate_count, milliseconds(certified.seconds), grouped(certified.found.pairs),
      unsure(certified.found));
  query plain = q;
  plain.precision = rung::fp32;
  const timed fast = run(a, b, plain);
  out += fmt::format("               plain fp32 would take {} and find {} pairs, without any bound\n",
                     milliseconds(fast.seconds), grouped(fast.found.pairs));
  if (box > 0) {
    query boxed = q;
    boxed.box = static_cast<float>(box);
    const timed in_box = run(a, b, boxed);
    out += fmt::format("   box         {}: the first rung bounds errors by it; {}\n", milliseconds(in_box.seconds),
                       unsure(in_box.found));
  }
  if (tolerance > 0) {
    query tolerant = q;
    set_tolerance(tolerant, tolerance);
    tolerant.box = static_cast<float>(box);
    const timed rounded = run(a, b, tolerant);
    out += fmt::format("   tolerance   {}: {} pairs on the grid 2^{}; {}\n", milliseconds(rounded.seconds),
                       grouped(rounded.found.pairs), std::ilogb(tolerant.grid), unsure(rounded.found));
  }
  return out;
}

} // namespace meetc::app
