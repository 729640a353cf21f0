// Targets: text from lowered kernels. They know no algebra and solve nothing.
//
// A target is a struct of functions in one table (registry.cpp): a name, what it can carry, the files that it writes and
// what it shows of one kernel. A new target is a folder here and a line there.
#pragma once
#include "gen/bound/bound.hpp"
#include "gen/lower/ball_form.hpp"
#include "gen/lower/kinds.hpp"
#include "gen/lower/separated.hpp"

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

// What only targets for eyes and for other programs need of a kernel.
struct forms {
  std::optional<lower::declared_formula> declared;  // of a formula
  std::vector<lower::separated> separated;          // its signs, or its values on general blades
  std::vector<lower::separated> declared_separated; // its values in the declared basis
};

// Everything that a target is given: lowered kernels after the last pass, and their bounds.
struct unit {
  const lang::scene &scene;
  std::vector<lower::kernel> kernels;
  // Of kernels made of signs, where the scene asks for rungs that need them.
  std::vector<std::optional<bound::kernel_bounds>> bounds;
  std::vector<lower::lowered_kind> kinds; // that the kernels need, each after those that it holds
  std::optional<lower::ball_form> balls;  // where a backend filters by enclosing balls
  std::vector<forms> shown;               // by kernel; empty where nothing is shown

  // A kind of the unit.
  const lower::lowered_kind &kind(const std::string &name) const;
  bool asks(lang::rung r) const { return scene.asks(r); }
  bool asks_plain() const { return std::any_of(scene.rungs.begin(), scene.rungs.end(), lang::is_plain); }
};

// What a target can carry of what a scene asks for.
struct carries {
  bool formulas = false, signs = false, plain = false, certified = false, launchers = false;
};

struct target {
  const char *name; // as in a scene's `backends` and in `meetc show --emit=NAME`
  const char *what; // one line, for help
  carries can;
  bool is_default = false;  // written where the scene names no backends
  bool needs_balls = false; // it filters by enclosing balls
  // The files of a unit, in any order; null: `meetc generate` writes none. Throws spec_error for what it cannot carry.
  std::vector<file> (*files)(const unit &) = nullptr;
  const char *over = nullptr;   // the target whose files its own include; they are written too
  const char *source = nullptr; // what a build compiles once: <space>/<space> and this, "_runtime.cpp"
  // One kernel of the unit, for eyes; null: it shows nothing. Throws spec_error for what it cannot carry.
  std::string (*show)(const unit &, std::size_t kernel) = nullptr;
  // All kernels of the unit in one table, for eyes; null: it has none.
  std::string (*show_all)(const unit &) = nullptr;
};

// The folders below the namespace's own that emitted files lie in, of C++ ("//" opens a comment) and of proofs ("#").
inline constexpr const char *code_folders[] = {"detail", "src", "units"};
inline constexpr const char *proof_folder = "proofs";

// So many sources a language that include the predicates' own sources, which lie in <space>/src: for a build that has to
// know the names of what it compiles before the scene is read.
std::vector<file> umbrella_sources(const std::vector<file> &files, const lang::scene &s, int units);

// All of them, in the order in which help lists them.
std::span<const target> all();
// Null where there is none of this name.
const target *find(const std::string &name);
// Those that write files: what a scene's `backends` may hold.
lang::backend_choice backends();
// Whether a backend of the scene filters by enclosing balls.
bool needs_balls(const lang::scene &s);
// The files of the scene's backends and of what they stand over, sorted by path, with the kernel headers. Throws
// spec_error where two would have one path.
std::vector<file> files_of(const unit &u);

} // namespace meetc::target
