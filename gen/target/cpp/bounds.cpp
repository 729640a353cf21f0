#include "gen/target/cpp/bounds.hpp"

#include "gen/target/cpp/body.hpp"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <functional>

namespace meetc::target {
namespace {
using bound::leaf;

std::string leaf_text(const leaf &l, const emitted_predicate &p) {
  return l.subtrahend < 0 ? p.input(l.minuend) : fmt::format("{} - {}", p.input(l.minuend), p.input(l.subtrahend));
}

// A function that looks up a value by the sign's number; if all values are equal, it returns a constant.
std::string lookup(const char *type, const char *name, const std::vector<std::string> &values) {
  const std::string head = fmt::format("  MEETC_HD static {} {}(", type, name);
  if (std::all_of(values.begin(), values.end(), [&](const std::string &v) { return v == values.front(); }))
    return fmt::format("{}int) {{ return {}; }}\n", head, values.front());
  std::string list, line = "     ";
  for (const std::string &v : values) {
    if (line.size() + v.size() > 108) {
      list += line + '\n';
      line = "     ";
    }
    line += fmt::format(" {},", v);
  }
  line.pop_back();
  return fmt::format("{}int i) {{\n    static constexpr {} all[] = {{\n{}{}}};\n    return all[i];\n  }}\n", head, type,
                     list, line);
}

// A function of two numbers that looks up an entry of a table.
std::string table_text(const char *comment, const char *name, const std::vector<std::vector<int>> &rows) {
  std::string list, line = "       ";
  for (const std::vector<int> &row : rows) {
    std::string entry;
    for (const int n : row)
      entry += fmt::format("{}{}", entry.empty() ? "" : ", ", n);
    if (line.size() + entry.size() > 106) {
      list += line + '\n';
      line = "       ";
    }
    line += fmt::format(" {{{}}},", entry);
  }
  line.pop_back();
  return fmt::format("  // {}.\n  MEETC_HD static constexpr int {}(int i, int group) {{\n"
                     "    constexpr signed char all[][{}] = {{\n{}{}}};\n    return all[i][group];\n  }}\n",
                     comment, name, rows.front().size(), list, line);
}

std::string extent_text(const char *object, const std::vector<leaf> &leaves, const emitted_predicate &p) {
  std::string most = "0.0f", body;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    if (i + 1 < leaves.size()) {
      body += fmt::format("    const float m{} = meetc::larger({}, {});\n", i, most, leaf_text(leaves[i], p));
      most = fmt::format("m{}", i);
    } else {
      most = fmt::format("meetc::larger({}, {})", most, leaf_text(leaves[i], p));
    }
  body += fmt::format("    return {};\n", most);
  const std::string operand = p.operands_in(body, "    ");
  return fmt::format("  MEETC_HD MEETC_INLINE static float extent_{0}(const float *{1}) {{\n{2}{3}  }}\n", object,
                     operand.empty() ? "" : fmt::format("row_{}", object), operand, body);
}

// The magnitudes as functions: one for each object that stores some, and one for the pair.
std::string magnitudes_text(const bound::stage_bounds &b, const emitted_predicate &p) {
  const ir::program &code = b.magnitudes;
  const auto input = [&](int i) {
    return fmt::format("leaf({})", leaf_text(b.leaves[static_cast<std::size_t>(i)], p));
  };
  const body_names names{[](int i) { return fmt::format("l{}", i); },
                         [](std::size_t i, const std::string &v) { return fmt::format("m[{}] = {};", i, v); }};
  const stored_body stored = stored_parts(code, names, "    ");
  // Each leaf that a part reads is a named constant, since it takes some operations.
  const auto with_leaves = [&](const std::vector<ir::node_id> &results, const std::vector<ir::node_id> &given,
                               const std::string &text) {
    std::string out;
    for (const ir::node_id id : ir::needed(code.nodes, results, given))
      if (const ir::node &n = code.nodes.at(id); n.kind == ir::op::input)
        out += fmt::format("    const T l{} = {};\n", n.a, input(n.a));
    return p.operands_in(out, "    ") + out + text;
  };
  const auto row = [](const std::string &text, const char *name) {
    return fmt::format("const T *{}", text.find(fmt::format("({})", name)) == std::string::npos ? "" : name);
  };
  const auto object = [&](char which, poly::residency where, const std::string &body) {
    const std::string text = with_leaves(ir::stored_of(code, where), {}, body);
    return fmt::format("  template <class T, class Leaf>\n  MEETC_HD MEETC_INLINE static void magnitudes_{}({}, const "
                       "Leaf &leaf, T *f) {{\n{}  }}\n",
                       which, row(text, which == 'a' ? "row_a" : "row_b"), text);
  };
  std::string out = fmt::format(
      "  // The program on the magnitudes of its leaves, with additions for subtractions; some values are stored.\n"
      "  static constexpr int magnitudes_of_a = {}, magnitudes_of_b = {};\n",
      stored.fields_a, stored.fields_b);
  if (stored.fields_a > 0)
    out += object('a', poly::residency::a, stored.object_a);
  if (stored.fields_b > 0)
    out += object('b', poly::residency::b, stored.object_b);
  const std::string text = with_leaves(code.results, code.stored, pair_body(code, stored, names, false, {}, "    "));
  const auto field = [&](const char *name) {
    return fmt::format("const T *{}", text.find(fmt::format("{}[", name)) == std::string::npos ? "" : name);
  };
  return out + fmt::format("  template <class T, class Leaf>\n  MEETC_HD MEETC_INLINE static void magnitudes({}, {}, "
                           "{}, {}, const Leaf &leaf, T *m) {{\n{}  }}\n",
                           row(text, "row_a"), field("fa"), row(text, "row_b"), field("fb"), text);
}

} // namespace

std::string hex_literal(const ir::rational &q, const char *suffix) {
  if (q == 0)
    return suffix[0] == 'f' ? "0.0f" : "0.0";
  mpz_class m = q.get_num();
  long e = -(static_cast<long>(mpz_sizeinbase(q.get_den().get_mpz_t(), 2)) - 1);
  const mp_bitcnt_t low = mpz_scan1(m.get_mpz_t(), 0);
  m >>= low;
  e += static_cast<long>(low);
  return fmt::format("0x{}p{}{}", m.get_str(16), e, suffix);
}

std::string stage_widths_text(const bound::stage_bounds &b) {
  return fmt::format("  // With inputs that are integers below 2^bits every value is below 2^(degree bits + growth).\n"
                     "  static constexpr int degree = {}, growth = {};\n  static constexpr bool mixed = {};\n",
                     b.degree, b.growth, b.mixed);
}

std::string stage_bounds_text(const bound::stage_bounds &b, const emitted_stage &stage, const emitted_predicate &p) {
  const lower::stage &s = *stage.code;
  std::string out = fmt::format(
      "  // With inputs that are integers below 2^bits every value is below 2^(degree bits + growth).\n"
      "  static constexpr int degree = {}, growth = {};\n"
      "  // Exact where differences are integers below 2^window on a grid: fp64{}.\n"
      "  static constexpr int window = {};\n  static constexpr bool mixed = {};\n"
      "  // Leaves below 2^floor count as 2^floor{}.\n"
      "  static constexpr int floor_fp32 = {}, floor_fp64 = {}{};\n",
      b.degree, b.growth, b.mixed ? ", and double-double from degree 3" : "", b.window, b.mixed,
      p.asks_box() ? "; a box's side is from 2^box_lowest to 2^box_highest" : "", b.floor_fp32, b.floor_fp64,
      p.asks_box() ? fmt::format(", box_lowest = {}, box_highest = {}", b.box_lowest, b.box_highest) : "");
  std::vector<std::string> factors, unfused_factors, boxes, unfused_boxes, degrees, zeros;
  const bound::stage_bounds &unfused = b.unfused->bounds;
  const auto factor = [](const bound::stage_bounds &of, std::size_t i) {
    const auto k = [&](const bound::arithmetic &a, const bound::roundings &r, const char *suffix) {
      return hex_literal(bound::rounded_up(bound::factor(a, r), 12), suffix);
    };
    return fmt::format("{{{}, {}, {}}}", k(bound::fp32, of.fp32[i], "f"), k(bound::fp64, of.fp64[i], ""),
                       k(bound::fp64x2, of.fp64x2[i], ""));
  };
  const auto box = [](const bound::box_bound &x) {
    return fmt::format("{{{}, {}, {}, {}}}", hex_literal(x.value, "f"), x.a, x.b, x.pair);
  };
  for (std::size_t i = 0; i < s.atoms.size(); ++i) {
    factors.push_back(factor(b, i)), unfused_factors.push_back(factor(unfused, i));
    if (p.asks_box())
      boxes.push_back(box(b.box[i])), unfused_boxes.push_back(box(unfused.box[i]));
    degrees.push_back(fmt::format("{}", b.fp32[i].degree));
    zeros.push_back(fmt::format("0x{:x}u", b.zero_if[i]));
  }
  out += "  // |computed - true| <= factor * magnitude, in fp32, fp64 and fp64x2: ((1 + u)^theta - 1) / (1 - u)^(phi "
         "+ 1).\n";
  out += fmt::format("  // factor_unfused {} where a fused multiply-add is computed as a product and a sum.\n",
                     p.asks_box() ? "and box_unfused hold" : "holds");
  out += lookup("meetc::factors", "factor", factors);
  out += lookup("meetc::factors", "factor_unfused", unfused_factors);
  if (p.asks_box()) {
    out += "  // In fp32: <= c alpha^a beta^b D^pair for objects of extents alpha, beta in a box of side D, powers of "
           "two.\n";
    out += lookup("meetc::box_factor", "box", boxes);
    out += lookup("meetc::box_factor", "box_unfused", unfused_boxes);
  }
  out += b.degrees.empty() ? lookup("int", "degree_of", degrees)
                           : table_text("The degree of each sign in each group", "degree_in", b.degrees);
  out += "  // The coincidences of points that make the sign zero.\n";
  out += lookup("unsigned", "zero_if", zeros);
  if (p.asks_box()) {
    out += extent_text("a", bound::leaves_of(b, poly::residency::a), p);
    out += extent_text("b", bound::leaves_of(b, poly::residency::b), p);
  }
  return out + magnitudes_text(b, p);
}

namespace {

// The points that a comment names: "A.c = B.a".
std::string points_text(const bound::coincidence &c, const emitted_predicate &p) {
  const auto point = [&](const std::vector<int> &inputs) {
    const std::string &path = p.kernel.decision.stored_inputs[static_cast<std::size_t>(inputs.front())];
    return path.substr(0, path.rfind('.'));
  };
  return fmt::format("{} = {}", point(c.x), point(c.y));
}

// A comment of whole words in lines.
std::string comment_lines(const std::string &text) {
  constexpr std::size_t width = 110;
  std::string out, line = "  //";
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(' ', from), text.size());
    if (line.size() + 1 + end - from > width) {
      out += line + '\n';
      line = "  //";
    }
    line += ' ' + text.substr(from, end - from);
    from = end + 1;
  }
  return out + line + '\n';
}

// Where one equality of points settles the decision, as a function of the numbers of many pairs.
std::string settled_lanes_text(std::uint32_t alone, const bound::kernel_bounds &b, const emitted_predicate &p) {
  std::string any;
  for (std::size_t i = 0; i < b.coincidences.size(); ++i) {
    if (!(alone >> i & 1))
      continue;
    std::string both;
    for (std::size_t axis = 0; axis < b.coincidences[i].x.size(); ++axis)
      both += fmt::format("{}({} == {})", both.empty() ? "" : " & ", p.input(b.coincidences[i].x[axis]),
                          p.input(b.coincidences[i].y[axis]));
    any += fmt::format("{}({})", any.empty() ? "" : " |\n        ", both);
  }
  const char *number = p.a == "L" || p.b == "L" ? "Lanes" : "L"; // which an operand must not hide
  return fmt::format(
      "  // The same for many pairs at a time (meetc/simd/lanes.hpp), as far as one bit alone says so.\n"
      "  template <class {0}> MEETC_INLINE static auto settled_lanes(const {0} *row_a, const {0} *row_b) {{\n"
      "{1}    return {2};\n  }}\n",
      number, p.operands_in(any, "    "), any);
}

// Whether equal points settle the decision, as a function of rows.
std::string settled_text(const bound::kernel_bounds &b, const emitted_predicate &p) {
  std::uint32_t alone = 0;
  std::string claims, together;
  for (const std::uint32_t set : b.settled_by) {
    std::string claim;
    for (std::size_t i = 0; i < b.coincidences.size(); ++i)
      if (set >> i & 1)
        claim += (claim.empty() ? "" : " and ") + points_text(b.coincidences[i], p);
    claims += (claims.empty() ? "" : ", or ") + claim;
    if (std::has_single_bit(set))
      alone |= set;
    else
      together += fmt::format(" || (equal & 0x{0:x}u) == 0x{0:x}u", set);
  }
  const std::string comment =
      claims.empty() ? "No equal points are known to make a pair a hit whatever its other numbers are."
                     : fmt::format("A pair is a hit, whatever its other numbers are, where {}. The proof puts equal "
                                   "points into the polynomials of all signs; see meetc/decide/first_stages.hpp.",
                                   claims);
  const std::string bits = alone              ? fmt::format("(equal & settled_by) != 0{}", together)
                           : together.empty() ? "false"
                                              : together.substr(4);
  return comment_lines(comment) +
         fmt::format("  static constexpr unsigned settled_by = 0x{:x}u; // any of these bits\n"
                     "  MEETC_HD static constexpr bool settled(unsigned{}) {{ return {}; }}\n",
                     alone, bits == "false" ? "" : " equal", bits) +
         (alone ? settled_lanes_text(alone, b, p) : "");
}

} // namespace

std::string kernel_bounds_text(const bound::kernel_bounds &b, const emitted_predicate &p) {
  // Points differ in their first coordinate as a rule, so the others are not compared.
  std::string tests;
  for (std::size_t i = 0; i < b.coincidences.size(); ++i) {
    const bound::coincidence &c = b.coincidences[i];
    const auto equal = [&](std::size_t axis) {
      return fmt::format("{} == {}", p.input(c.x[axis]), p.input(c.y[axis]));
    };
    std::string others;
    for (std::size_t axis = 1; axis < c.x.size(); ++axis)
      others += fmt::format("{}({})", others.empty() ? "" : " & ", equal(axis));
    tests += fmt::format("    if ({})\n      bits |= {} << {};\n", equal(0),
                         others.empty() ? "1U" : fmt::format("static_cast<unsigned>({})", others), i);
  }
  const std::string operands = p.operands_in(tests, "    ");
  const auto row = [&](const char *name) {
    return fmt::format("const float *{}", operands.find(name) == std::string::npos ? "" : name);
  };
  std::string out = fmt::format("  // Bits of the points that coincide; zero_if says which signs are then zero.\n"
                                "  static constexpr int coincidences = {};\n"
                                "  MEETC_HD static unsigned coincident({}, {}) {{\n{}  }}\n",
                                b.coincidences.size(), row("row_a"), row("row_b"),
                                tests.empty() ? "    return 0;\n"
                                              : operands + "    unsigned bits = 0;\n" + tests + "    return bits;\n");
  if (!p.kernel.is_sign)
    out += settled_text(b, p);
  std::string axes;
  for (const int axis : b.axes)
    axes += fmt::format("{}{}", axes.empty() ? "" : ", ", axis);
  out += fmt::format("  // The axis of each input, or -1 if it occurs outside a difference.\n"
                     "  MEETC_HD static constexpr int axis(int i) {{\n    constexpr int all[] = {{{}}};\n    "
                     "return all[i];\n  }}\n",
                     axes);
  if (b.groups.weights.empty())
    return out;
  return out +
         fmt::format("  static constexpr int groups = {}; // of numbers, each with a grid of its own\n",
                     b.groups.groups()) +
         table_text(
             "The weight of each input in each group: its grid is the product of the groups' steps, each to this "
             "power",
             "weight", b.groups.weights);
}

} // namespace meetc::target
