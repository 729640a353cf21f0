// Targets: text from lowered kernels. They know no algebra and solve nothing.
//
// A target is an entry of one table (registry.cpp): a name, what it can carry, and functions that write its files and
// show one kernel. A new target is a folder here and an entry there.
#pragma once
#include "gen/bound/bound.hpp"
#include "gen/lower/analytic/analytic.hpp"
#include "gen/lower/ball_form.hpp"
#include "gen/lower/kinds.hpp"
#include "gen/lower/separated.hpp"
#include "gen/lower/tolerance.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meetc::target {

struct file {
  std::string path; // relative to the output folder, '/' between parts
  std::string text;
};

// The forms of a kernel that only targets for readers and for other programs need.
struct forms {
  std::optional<lower::declared_formula> declared;  // for a formula
  std::vector<lower::separated> separated;          // its signs, or its values on general blades
  std::vector<lower::separated> declared_separated; // its values in the declared basis
};

// The input of a target: lowered kernels after the last pass, and their bounds.
struct unit {
  const lang::scene &scene;
  std::vector<lower::kernel> kernels;
  // For kernels that consist of signs, if the scene asks for rungs that need them.
  std::vector<std::optional<bound::kernel_bounds>> bounds;
  std::vector<lower::lowered_kind> kinds; // the kinds that the kernels need, each after those that it contains
  std::optional<lower::ball_form> balls;  // for filters by enclosing balls, if the algebra has it
  std::vector<forms> shown;               // by kernel; empty if no polynomial is shown
  lower::tolerance_plan tolerance;        // if the scene asks for the rung tolerant
  std::vector<lower::analytic_kernel> analytic;

  // The kind with this name.
  const lower::lowered_kind &kind(const std::string &name) const;
  bool asks(lang::rung r) const { return scene.asks(r); }
  bool asks_plain() const { return std::any_of(scene.rungs.begin(), scene.rungs.end(), lang::is_plain); }
};

// Which requests of a scene a target can carry.
struct carries {
  bool formulas = false, signs = false, plain = false, certified = false, tolerant = false, launchers = false,
       analytic = false;
};

struct target {
  const char *name; // as in a scene's `backends` and in `meetc show --emit=NAME`
  const char *what; // one line, for help
  carries can;
  // For a target with files: the types of numbers that it computes in, and the promise of its formulas' bits.
  const char *numbers = "", *bits = "";
  bool is_default = false; // written if the scene names no backends
  // It shows polynomials, and so needs unit::shown and cannot carry a formula that is too long to be expanded.
  bool reads_polynomials = false;
  // The files of a unit, in any order; null: `meetc generate` writes none. Throws spec_error if it cannot carry the
  // unit.
  std::vector<file> (*files)(const unit &) = nullptr;
  const char *over = nullptr; // the target whose files its files include; those are written too
  // The ending of <space>/<space>..., the file by which a build knows the target's output: "_runtime.cpp", which it compiles
  // once. Each target with files has one.
  const char *source = nullptr;
  // One kernel of the unit, to be read; null: it shows nothing. Throws spec_error if it cannot carry the kernel.
  std::string (*show)(const unit &, std::size_t kernel) = nullptr;
  // One function of the unit that is no polynomial; null: it shows none.
  std::string (*show_analytic)(const unit &, std::size_t kernel) = nullptr;
  // All kernels of the unit in one table, to be read; null: there is none.
  std::string (*show_all)(const unit &) = nullptr;
};

// The subfolders of the namespace's folder with emitted C++ ("//" opens a comment) and with proofs ("#").
inline constexpr const char *code_folders[] = {"detail", "src", "units"};
inline constexpr const char *proof_folder = "proofs";

// For each language, `units` sources that include the predicates' sources in <space>/src. They serve a build that must
// know the names of its sources before the scene is read.
std::vector<file> umbrella_sources(const std::vector<file> &files, const lang::scene &s, int units);

// All targets, in the order in which help lists them.
std::span<const target> all();
// Null if no target has this name.
const target *find(const std::string &name);
// The targets that write files and what each carries, a line each, below a line of titles.
std::string list_of_targets();
// The targets that write files, which a scene's `backends` may name.
lang::backend_choice backends();
// The files of the scene's backends and of the targets that those include, with the kernel headers, sorted by path.
// Throws spec_error if two files would have one path.
std::vector<file> files_of(const unit &u);

} // namespace meetc::target
