// The interface between a runtime and generated code: plain data and functions, which name no shape. The functions of an
// emitted table may be called under any control word (table_entry.hpp).
#ifndef MEETC_TABLE_TABLE_HPP
#define MEETC_TABLE_TABLE_HPP

#include <meetc/number/logic.hpp>
#include <meetc/table/formula_table.hpp>

#include <cstddef>

namespace meetc {

// The role of a stored number, by which a runtime can move and check an element without knowing its shape.
enum class role : std::uint8_t { x, y, z, length, other };

// One kind of element. A row is `fields` floats in the spec's store order.
struct kind_info {
  const char *name;
  const char *csv;   // the CSV header: the stored names, comma-separated
  int fields;        // floats in a row
  const role *roles; // one for each field
  int points;        // > 0: the row is this many points x, y, z and nothing else, so it can be indexed
  // Closed boxes that enclose the elements, never too small, as lo[3] and hi[3] for each of n rows.
  void (*boxes)(const float *rows, std::size_t n, float *out);
  const char *(*fault)(const float *row); // the broken `where` rule, or null
  int stored = 0;                         // the number of different stored_values of its predicates
  // The element is a part of all points within row[pad] of the convex hull of `hull` points. Coordinate k of point p is
  // row[hull_fields[3 p + k]], or 0 where that is -1. hull 0: nothing but the box is known; pad -1: the distance is 0.
  int hull = 0;
  const int *hull_fields = nullptr;
  int pad = -1;

  // The box of one row.
  void box(const float *row, float lo[3], float hi[3]) const {
    float ends[6];
    boxes(row, 1, ends);
    for (int k = 0; k < 3; ++k)
      lo[k] = ends[k], hi[k] = ends[3 + k];
  }
};

// The values that a set stores beside its rows for a predicate: `floats` numbers for each element, in the order of the
// rows.
struct stored_values {
  int number = -1; // by kind; predicates with the same stored values share a number. -1: nothing is stored
  int floats = 0;
  // Fills out for n rows. Returns false, and stores nothing, where the arithmetic is not as bounds assume.
  bool (*compute)(const float *rows, std::size_t n, float *out) = nullptr;
};

// A set's rows, and its stored values for the predicate; null: each pair computes them.
struct row_array {
  const float *rows;
  const float *stored;
  MEETC_HD MEETC_INLINE row_array(const float *r, const float *s = nullptr)
      : rows(r), stored(s) {} // NOLINT: rows alone suffice
};

struct index_pair {
  std::uint32_t a, b;
};

// fp32, fp64 and fp64x2 are plain: they take the sign of the computed value. exact and certified are never wrong.
// certified runs the bounded rungs, the cheapest first, each on what the one before left unsure, and exact last. tolerant
// is wrong only where moving one element by at most a proved length changes the answer (tolerant.hpp).
enum class rung : std::uint8_t { fp32 = 0, fp64 = 1, fp64x2 = 2, exact = 3, certified = 4, tolerant = 5 };
inline constexpr int rung_count = 6;
constexpr bool never_wrong(rung r) {
  return r == rung::exact || r == rung::certified;
}
// The rungs of `certified` before exact are named as the plain ones: fp32, fp64, fp64x2.
inline constexpr int bounded_rungs = 3;

// Decides n candidate pairs: pairs[i].a and .b index rows of floats. A true answer is the same for rows that are all
// multiplied by one positive number.
using decide_function = void (*)(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out);

// The assumptions of the rung tolerant about both sets, and its promises.
struct tolerance_info {
  double moves = 0; // an answer may be wrong only where moving one element by at most this changes it
  // The step of the scene's grid, a power of two; 0: it has none. `rounds`: all numbers must have been rounded to it.
  // Otherwise they may have been.
  double step = 0;
  bool rounds = false;
  double reach = 0; // the largest |coordinate| of any element; no length exceeds twice this
  // Whether a set that was rounded to this grid (0: to none) will do.
  constexpr bool fits(double grid) const { return grid == step || (!rounds && grid == 0); }
  // Whether one with these largest magnitudes of a coordinate and of a length is in the box.
  constexpr bool holds(float coordinate, float length) const {
    return static_cast<double>(coordinate) <= reach && static_cast<double>(length) <= 2 * reach;
  }
};

// One predicate on an ordered pair of kinds.
struct predicate_info {
  const char *name;
  const char *mode; // "solid", "surface", or "" where the two do not differ
  const kind_info *a, *b;
  // Indexed by rung; rows have a->fields and b->fields floats. Null where the scene does not ask for the rung, and for
  // certified, which is the functions of `certify` and the exact rung. No entry answers unsure.
  decide_function decide[rung_count];
  // The bounded rungs of `certified`, fp32 first, each for the pairs that the one before left unsure. Their no and yes
  // are proved. decide[exact] runs last, so a table made by hand must fill it as well: if any of the four is missing,
  // the runtime has no `certified`. Null without `certified`.
  decide_function certify[bounded_rungs];
  // The first of them in a box of side D, which is a power of two from box_least to box_most that no difference of
  // coordinates, no coordinate and no length of the elements exceeds. Bounds use the extents of each object.
  void (*certify_in_box)(float side, row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out);
  float box_least, box_most;
  // The stored values that certify[0] and certify_in_box read, and those that decide[fp32] reads.
  // They differ where only the latter are computed with the fused multiply-add.
  stored_values stored_a = {}, stored_b = {}, plain_stored_a = {}, plain_stored_b = {};
  // decide[exact] for pairs that all bounded rungs left unsure: it does not repeat what they have tried. Null:
  // decide[exact] takes its place.
  decide_function decide_last = nullptr;
  tolerance_info tolerance = {}; // of decide[tolerant]
  // Where no difference and no length exceeds 2^this, in steps of a grid, every value fits 128 bits; 0: not known.
  int longest_differences = 0;
  // Proved: the exact answer, and with it that of every rung that is never wrong, is the same with the operands exchanged.
  bool symmetric = false;
  // Which of two rows of b an element of a meets first on its way from its first point to its second, of rows that it meets:
  // -1, 1, or 0 for both at one point. It is exact, and a total order of any rows of b; null: not generated (first_met.hpp).
  int (*first_met)(const float *a, const float *b, const float *other) = nullptr;
  // The contact codes of n pairs of rows (meetc/contact/code.hpp), which are exact; null: not generated.
  void (*contacts)(const float *a, const float *b, const index_pair *pairs, std::size_t n,
                   std::uint64_t *codes) = nullptr;
  // The part of n rows of b in the winding number at a point that lies on none of them, which is exact; null: not generated
  // (meetc/contact/winding.hpp).
  int (*winding)(const float *point, const float *b, std::size_t n) = nullptr;
  // Whether the exact answer stays the same when all numbers are multiplied by one positive number.
  bool scales = true;
};

// All that a namespace offers to a runtime.
struct catalogue {
  const char *space;
  const kind_info *kinds;
  int kind_count;
  const predicate_info *predicates;
  int predicate_count;
  const formula_info *formulas;
  int formula_count;
  // The scene's box: every coordinate lies in [-box, box], every length in [0, 2 box]. 0: the scene states none.
  float box;
  instruction_set compiled_for = instruction_set::baseline;
};

} // namespace meetc

#endif
