// Proven error bounds of the signs of a stage.
//
// Problem: the final, scheduled graph of a stage computes v^ in floating point; the sign that is wanted is that of the
// exact v. Find E with |v^ - v| <= E, or rather with: v^ > E implies v > 0.
//
// Method: two analyses of the same graph, node for node, in exact rationals, rounded outwards at the end.
//   magnitude form  |v^ - v| <= K M: M is the graph itself, run on the absolute values of its leaves with every
//                   subtraction replaced by an addition. K counts roundings, as (1 + u)^theta - 1 (Higham 2002, ch. 3).
//                   It holds at any scale, with one M for each pair (a semi-static filter).
//   box form        |v^ - v| <= c alpha^i beta^j D^k where the leaves of object A, of object B and of the pair are
//                   at most the powers of two alpha, beta and D, with alpha, beta <= D. If alpha and beta are the
//                   objects' own extents, it is the bound per object; if alpha = beta = D, it is the static bound of a
//                   scene's box. The recurrence for (bound, error) follows Meyer and Pion 2008; each c has a Gappa
//                   proof (gen/target/gappa/gappa.cpp).
//
// A leaf is the difference of two stored numbers, or a stored number itself. Its one rounding is counted, so the bounds
// cover the whole chain from the float32 input, including stored object values. The last rounding is not counted where
// rounding is to nearest, since it is monotonic and keeps the sign of what it rounds.
//
// Underflow: a product may fall below the normal numbers. Its rounding error is then at most half the smallest
// subnormal instead of u times the product, and that is at most u M, because the floor f of the leaves makes f^degree
// far larger (in fp32 f^degree >= 2^-102). Overflow: there is no division, so if an operation on the way to v^
// overflows, v^ is infinite or NaN, and if one on the way to M^ does, M^ is; neither then proves a sign.
//
// Contraction: a compiler may contract a product and a sum of the program of v^, of that of M^, of both or of neither.
// Each contraction removes one factor (1 + delta) from some monomials and adds none, so theta and phi remain upper
// bounds, each for its own program, and the argument about overflow is made for each program alone. In the box form a
// contraction removes one error from the recurrence, which is monotonic in its errors. Without a fused multiply-add a
// second schedule runs, in which every fma(a, b, c) is a b + c with two roundings; it has its own theta, phi, K, box
// form and Gappa scripts.
//
// The box form: the rounding error of a value below 2^e is taken as half a unit in the last place there, and powers of
// two commute with rounding. So the theorem is one about leaves in [-1, 1], in a float format whose least exponent
// covers every scale that is allowed.
//
// Limits: stages must be homogeneous with integer constants (growth.hpp), in each group of numbers if there are several
// (grading.hpp), under round to nearest and gradual underflow. With several groups there is no box form.
// The emitted thresholds say where they hold; elsewhere a rung answers unsure.
#pragma once
#include "gen/bound/grading.hpp"
#include "gen/ir/fold.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace meetc::bound {

using ir::rational;

// The subject of the analysis: the programs of a kernel's signs, by stage, and the polynomials whose signs they are.
// All are borrowed.
struct subject {
  const poly::ring &numbers; // the stored numbers of both operands
  const poly::local_origin &local;
  struct stage {
    const ir::program *code = nullptr;
    std::vector<const poly::poly *> signs; // of the program's results; empty: there is no such stage
  };
  std::array<stage, 3> stages;
};

struct leaf {
  int minuend, subtrahend; // inputs of the program; subtrahend -1: the stored number itself
  poly::residency where;
  auto operator<=>(const leaf &) const = default;
};

// The properties of an arithmetic that decide how roundings count.
struct arithmetic {
  const char *name;
  int precision;    // u = 2^-precision
  int significand;  // integers with this many bits are exact
  bool leaf_rounds; // a difference of two float32 numbers is rounded
  bool fuses;       // a*b + c is rounded once
  bool monotonic;   // rounding keeps the sign, so the last one is not counted
};
// Products are assumed to have a relative rounding error; the floors of stage_bounds keep them above the subnormals.
inline constexpr arithmetic fp32{"fp32", 24, 24, true, true, true};
inline constexpr arithmetic fp64{"fp64", 53, 53, true, true, true};
// Double-double: every operation is within 2^-102 of its result (runtime/kernel/meetc/number/double_double.hpp). M is in fp64.
inline constexpr arithmetic fp64x2{"fp64x2", 102, 106, false, false, false};

// The roundings on the way to a value (theta) and to its computed magnitude (phi), which is always in fp32 or fp64.
struct roundings {
  int theta = 0, phi = 0, degree = 0;
};

// The exact K for which v^ > fl(K M^) implies v > 0, for the magnitude M^ computed from computed leaves.
rational factor(const arithmetic &a, const roundings &r);
// The least float with `bits` significant bits that is not below q >= 0.
rational rounded_up(const rational &q, int bits);
rational power_of_two(int exponent);

// One sign in the box form: |v^ - v| <= c alpha^a beta^b D^pair for every D in [2^box_lowest, 2^box_highest].
struct box_bound {
  rational value;             // c, a float32
  int a = 0, b = 0, pair = 0; // the powers; their sum is the degree
};

struct unfused_stage;

struct stage_bounds {
  std::vector<leaf> leaves;
  ir::program magnitudes;                    // inputs: |leaf| by number; results: M, one for each sign
  std::vector<roundings> fp32, fp64, fp64x2; // by sign
  std::vector<box_bound> box;                // by sign; empty where numbers have groups
  int degree = 0, growth = 0;                // the maxima over all values and inputs (growth.hpp)
  std::vector<std::vector<int>> degrees;     // by sign, by group; empty where there is one group
  // Leaves below 2^floor count as 2^floor, so that products of them underflow by no more than a rounding.
  int floor_fp32 = 0, floor_fp64 = 0;
  int box_lowest = 0, box_highest = 0; // exponents of D
  std::vector<std::uint32_t> zero_if;  // by sign: the coincidences of kernel_bounds that make it zero
  // Values of degree 3 and more may be in a wider type than the others. No object stores one.
  bool mixed = false;
  int window = -1; // differences of this many bits on a common grid are exact in fp64 (mixed: and double-double)
  // The same for machines without a fused multiply-add, which run another schedule; null in such bounds themselves.
  std::shared_ptr<const unfused_stage> unfused;
};

// The schedule with a product and a sum for every fused multiply-add, and its bounds. All but the roundings and the box
// form equals that of the fused one.
struct unfused_stage {
  ir::program code;
  stage_bounds bounds;
};

// Points of the operands that may have equal coordinates, as inputs by axis.
struct coincidence {
  std::vector<int> x, y;
  auto operator<=>(const coincidence &) const = default;
};
inline constexpr std::size_t most_coincidences = 32; // the bits of one word

struct kernel_bounds {
  stage_bounds reject, common, rare; // empty where the predicate lacks the stage
  std::array<stage_bounds *, 3> stages() { return {&reject, &common, &rare}; }
  std::vector<coincidence> coincidences; // at most most_coincidences
  // Sets of them, as bits: where all of a set hold, the decision is a hit (gen/lower/predicate/settled.hpp).
  std::vector<std::uint32_t> settled_by;
  // For each input: its axis if it occurs only in differences with inputs of the same axis, else -1.
  std::vector<int> axes;
  grading groups;
};

// Every pair of points that could have equal coordinates, of the same operand or not.
std::vector<coincidence> pairs_of_points(const poly::local_origin &local);
// The polynomial for operands at which all of these coincidences hold.
poly::poly with_equal_points(const poly::poly &f, const std::vector<coincidence> &all);

void find_coincidences(const subject &of, kernel_bounds &out); // coincidences, zero_if and axes

// Returns nothing where a sign is not homogeneous in any groups of the stored numbers or has a constant that is not an integer.
std::optional<kernel_bounds> analyse(const subject &of);

// The exact recurrence of the box form for one program, in an arithmetic of `precision` bits. The Gappa scripts prove
// its results, which are rounded up into box_bound. It is scaled to alpha = beta = D = 1.
struct box_node {
  rational exact, computed; // |value| <= this
  rational error;           // |computed - exact| <= this
  rational unrounded_error; // the same before the node's own rounding
  int a = 0, b = 0, pair = 0;
};
ir::folded<box_node> box_nodes(const ir::program &p, int precision, int lowest_exponent);
// The least exponent of a scaled float32 in the box form; the format of the proofs is float<24, this>.
inline constexpr int box_format_lowest = -47;

// The difference or stored number that a node of a program is, if it is a leaf.
std::optional<leaf> leaf_at(const ir::arena &nodes, ir::node_id id);

// Whether the node is a product with a power of two, which is exact.
bool scales_exactly(const ir::arena &nodes, ir::node_id id);

// The node with the last rounding on the way to a value, and the value's magnitude relative to it, a power of two. It
// is an input or a constant if nothing is rounded.
struct last_rounding {
  ir::node_id node;
  rational scale;
};
last_rounding last_rounding_of(const ir::arena &nodes, ir::node_id id);

// The leaves with residency `of`, whose largest magnitude is the extent of an object.
std::vector<leaf> leaves_of(const stage_bounds &s, poly::residency of);

} // namespace meetc::bound
