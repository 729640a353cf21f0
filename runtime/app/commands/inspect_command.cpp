#include "meet/app/commands/inspect_command.hpp"

#include "meet/app/input/algebra_file.hpp"
#include "meet/app/input/failure.hpp"
#include "meet/app/input/input_options.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/option_values.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/inspect/inspection.hpp"
#include "meet/app/inspect/scene_file.hpp"
#include "meet/app/inspect/scene_worth.hpp"
#include "meet/app/output/output_files.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/text/boxes.hpp"
#include "meet/app/text/words.hpp"
#include "meet/core/views/nouns.hpp"
#include "meet/core/views/pose.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/read.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

constexpr int exact_window = 26; // fp64 with exact products decides differences of up to so many bits

std::string power(int exponent) {
  return fmt::format("2^{}", exponent);
}

std::string grid_in_words(const grid &numbers, const box &points) {
  const std::optional<int> bits = difference_bits(points, numbers);
  if (!bits)
    return "no numbers";
  if (numbers.bits() == 0)
    return "all numbers are 0";
  return fmt::format("multiples of {} below {} ({} bits); differences to {} steps: {}", power(numbers.low),
                     power(numbers.high), numbers.bits(), power(*bits),
                     *bits <= exact_window ? "they fit 26 bits" : "more than 26 bits");
}

std::string faults_in_words(const io::element_set &set, const inspection &f) {
  std::string out;
  const auto add = [&out](std::size_t n, std::string_view one, std::string_view many) {
    if (n > 0)
      out += fmt::format("{}{} {}", out.empty() ? "" : ", ", grouped(n), n == 1 ? one : many);
  };
  add(f.zero_area, "face with a zero-area triangle", "faces with zero-area triangles");
  add(f.zero_length, "zero-length segment", "zero-length segments");
  add(f.zero_radius, "sphere of radius 0", "spheres of radius 0");
  add(f.flat, "flat box", "flat boxes");
  if (is_mesh(set))
    add(f.duplicates, "duplicate face", "duplicate faces");
  else
    add(f.duplicates, "duplicate", "duplicates");
  add(f.unused_vertices, "unused vertex", "unused vertices");
  return out.empty() ? "none" : out;
}

// The least size of the elements that have one. It limits algorithms that divide; the predicates here do not.
std::string least_in_words(const io::element_set &set, const inspection &f) {
  if (!std::isfinite(f.least_size))
    return "no element has a size";
  const char *const what = set.kind->points == 3        ? "height of a triangle"
                           : set.kind->points == 2      ? "length of a segment"
                           : lies_along_axes(*set.kind) ? "side of a box"
                                                        : "radius";
  return fmt::format("{} {:.4g}", what, f.least_size);
}

std::string note_lines(const io::element_set &set) {
  std::string out;
  for (const std::string &note : set.notes)
    out += fmt::format("   {}  {}\n", out.empty() ? "notes     " : "          ", note);
  return out;
}

std::string file_lines(const char *label, const fs::path &path, const io::element_set &set, const inspection &f) {
  const std::string vertices = set.vertices > 0 ? fmt::format(", {} vertices", grouped(set.vertices)) : "";
  return fmt::format("{}  {}\n"
                     "   kind        {}: {}{}\n"
                     "   box         {}\n"
                     "   grid        {}\n"
                     "   least       {}\n"
                     "   degenerate  {}\n"
                     "   rounded     {}\n{}",
                     label, path.string(), set.kind->name, counted(set), vertices, in_words(f.bounds),
                     grid_in_words(f.numbers, f.points), least_in_words(set, f), faults_in_words(set, f),
                     set.rounded.numbers == 0 ? "float32 holds all numbers" : in_words(set.rounded), note_lines(set));
}

std::string predicate_lines(const std::vector<choice> &fit, const kind_info &a, const kind_info &b) {
  if (fit.empty())
    return fmt::format("   predicates  none for {} with {}\n", a.name, b.name);
  std::string out;
  for (const choice &c : fit)
    out += fmt::format("   {}  {}{}\n", out.empty() ? "predicates" : "          ", c.predicate->name,
                       *c.predicate->mode ? fmt::format(" (--mode {})", c.predicate->mode) : "");
  return out;
}

// Refuses a tolerance for which the scene's kernels would need integers of more than 128 bits, since the grid is too fine
// for the box, which is a power of two.
void check_width(const std::vector<choice> &kept, double box, double tolerance) {
  double step = HUGE_VAL, finest = 0; // of the grid that keeps the tolerance for all, and of the finest that fits
  for (const choice &c : kept) {
    step = std::min(step, grid_within(*c.predicate, tolerance));
    if (c.predicate->longest_differences > 0)
      finest = std::max(finest, std::ldexp(2 * box, -c.predicate->longest_differences));
  }
  if (step >= finest)
    return;
  double moved = 0;
  for (const choice &c : kept)
    moved = std::max(moved, moved_by_grid(*c.predicate, finest));
  throw failure(
      fmt::format("--tolerance {}: the scene would need integers of more than 128 bits; state one of at least "
                  "{:.3g} for these files",
                  tolerance, 1.01 * moved)); // three digits must not fall below
}

} // namespace

std::string inspect(const catalogue &all, const inspect_request &q) {
  if (q.algebra && !q.scene)
    throw failure("--algebra is for the scene file that --scene writes; it goes with --scene");
  if (q.tolerance > 0 && !q.scene)
    throw failure("--tolerance is for the scene file that --scene writes; it goes with --scene");
  if (!q.b && q.scene)
    throw failure("--scene needs two files, between which it asks for predicates");
  std::vector<fs::path> inputs{q.a, q.b.value_or(q.a)};
  fs::path algebra;
  if (q.scene) {
    algebra = algebra_path(q.algebra, algebra_places());
    inputs.push_back(algebra);
  }
  output_files outputs(inputs);
  if (q.scene)
    outputs.expect(*q.scene);
  const std::vector<const kind_info *> kinds = kinds_of(all);
  if (!q.b) {
    const io::element_set only = io::read(q.a, kinds, q.read_a);
    return file_lines("A", q.a, only, inspection_of(only));
  }
  check_inputs(q.a, *q.b);
  const io::element_set a = io::read(q.a, kinds, q.read_a), b = io::read(*q.b, kinds, q.read_b);
  const std::vector<choice> fit = fitting(all, *a.kind, *b.kind);
  const inspection in_a = inspection_of(a), in_b = inspection_of(b);

  std::string out = file_lines("A", q.a, a, in_a) + file_lines("B", *q.b, b, in_b);
  out += "A with B\n";
  out += fmt::format("   boxes       {}\n", is_empty(in_a.bounds) || is_empty(in_b.bounds) ? "one is empty"
                                            : disjoint(in_a.bounds, in_b.bounds)           ? "disjoint"
                                                                                           : "they overlap");
  out += fmt::format("   grid        {}\n",
                     grid_in_words(around(in_a.numbers, in_b.numbers), around(in_a.points, in_b.points)));
  out += predicate_lines(fit, *a.kind, *b.kind);
  if (!q.scene)
    return out;
  if (fit.empty())
    throw failure(fmt::format("--scene: no predicate for {} with {}", a.kind->name, b.kind->name));
  std::vector<std::string> names;
  std::vector<choice> kept; // in the scene
  for (const choice &c : fit)
    if (q.tolerance == 0 || grid_within(*c.predicate, q.tolerance) > 0) {
      names.emplace_back(c.predicate->name);
      kept.push_back(c);
    } else {
      out += fmt::format("   left out    {}, which keeps no tolerance of {}\n", c.predicate->name, q.tolerance);
    }
  if (kept.empty())
    throw failure(
        fmt::format("--tolerance {}: no predicate for {} with {} keeps it", q.tolerance, a.kind->name, b.kind->name));
  const double box = box_for(in_a, in_b);
  if (q.tolerance > 0 && box == 0)
    throw failure(
        "--tolerance: it needs a box, and none that is a float32 holds these files, or all their numbers are 0");
  if (q.tolerance > 0)
    check_width(kept, box, q.tolerance);
  out += worth_of_scene(all, a, b, kept.front(), box, q.tolerance);
  const std::string text =
      scene_text(*q.scene, algebra, names, box, q.tolerance,
                 fmt::format("The scene that {} with {} require.", plural_of(a.kind->name), plural_of(b.kind->name)));
  outputs.write(*q.scene, [&text](const fs::path &to) { io::write_file(to, text); });
  outputs.commit();
  return out + fmt::format("wrote {}\n", q.scene->string());
}

command add_inspect(CLI::App &program, const catalogue &all) {
  CLI::App &c = *program.add_subcommand(
      "inspect", "Describe one file or two: elements, degenerate ones, and the predicates that fit");
  const auto q = std::make_shared<inspect_request>();
  c.add_option("A", q->a, files_help)->required()->type_name("FILE");
  c.add_option("B", q->b, "The other set, if any")->type_name("FILE");
  const auto read_a = std::make_shared<input_arguments>(), read_b = std::make_shared<input_arguments>();
  add_reading(c, 'a', *read_a);
  add_reading(c, 'b', *read_b);
  c.add_option("--scene", q->scene, "Write the scene file that these files require, for meetc")->type_name("out.toml");
  c.add_option("--algebra", q->algebra, "The algebra that the scene file names (the shipped cga3.toml)")
      ->type_name("PATH");
  const auto tolerance = std::make_shared<std::optional<std::string>>();
  c.add_option("--tolerance", *tolerance,
               "A length that the scene file states: answers may be wrong where moving one element by at most this "
               "changes them (meetc plan)")
      ->type_name("LENGTH");
  return {&c, [&all, q, tolerance, read_a, read_b] {
            q->read_a = input_named('a', *read_a);
            q->read_b = input_named('b', *read_b);
            if (*tolerance)
              q->tolerance = length_named("--tolerance", **tolerance);
            return inspect(all, *q);
          }};
}

} // namespace meetc::app
