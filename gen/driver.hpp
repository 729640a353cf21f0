// The pipeline: one function for each command. Text goes to stdout; on an error the caller writes one line or a caret
// to stderr.
#pragma once
#include "gen/target/target.hpp"

#include <memory>
#include <optional>

namespace meetc {

// A scene with its model and its kernels, compiled in the scene's order.
struct compilation {
  std::unique_ptr<lang::scene> scene;
  std::unique_ptr<lower::model> model;
  std::vector<lower::kernel> kernels;
  std::vector<lower::analytic_kernel> analytic;
  std::vector<std::optional<bound::kernel_bounds>> bounds; // for kernels made of signs, if a rung needs them
};

// One kernel after the last pass. It has bounds if it is made of signs and a rung of the scene needs them.
struct compiled_kernel {
  lower::kernel kernel;
  std::optional<bound::kernel_bounds> bounds;
};

// Spec and model, with one kernel for each choice of a wildcard; nothing compiled. Algebras are also looked for in
// `algebra_path`.
compilation load(const std::string &scene_path, const std::vector<std::string> &algebra_path = {});
compiled_kernel compile(const compilation &c, const lower::request &r);
lower::analytic_kernel compile_analytic(const compilation &c, const lang::expr &call);
void compile_all(compilation &c);                   // every kernel of the scene
std::vector<target::file> emit_all(compilation &c); // moves the kernels out

// A target's view of one kernel.
std::string shown(const compilation &c, const compiled_kernel &k, const std::string &target);
std::string shown(const compilation &c, const lower::analytic_kernel &k, const std::string &target);
// And of all kernels of the scene, for a target that has one. Compiles them.
std::string shown_all(compilation &c, const std::string &target);

// Folders in which algebras are looked for, in each command's options.
using folders = std::vector<std::string>;

struct generate_options {
  std::string scene, out, depfile, stamp, space;
  std::vector<std::string> required_backends; // named by a build that compiles them
  bool check = false, quiet = false;
  bool kernel_headers = true; // write meetc/ beside what is emitted
  int units = 0;              // umbrella sources for each language, see target::umbrella_sources()
  folders algebra_path;
};
struct verify_options {
  std::string scene;
  long cases = 5000;
  unsigned seed = 1;
  bool allow_unchecked = false; // else a kernel of which nothing could be compared is a failure
  folders algebra_path;
};
struct show_options {
  std::string scene, emit, expression, with; // emit: empty for C++, and without a kernel for the list of them
  std::vector<std::string> words;
  folders algebra_path;
};
struct plan_options {
  std::string scene;
  folders algebra_path;
};
struct eval_options {
  std::string scene, expression, with;
  folders algebra_path;
};

struct compare_options {
  std::vector<std::string> scenes;
  std::string cxx, nvcc; // compilers for the emitted sources; empty: they are not compiled
  bool formulas = false; // what each formula costs
  std::string beside;    // a file of counts that other generators publish; empty: none
  bool kernels = false;  // also a table of the kernels, scene beside scene
  folders algebra_path;
};

int generate(const generate_options &o);
// Prints which arithmetic keeps the scene's tolerance, kernel by kernel, and why.
int plan_scene(const plan_options &o);
int verify_scene(const verify_options &o);
// Prints the table of targets.
int list_targets();
int show(const show_options &o);
// Prints the exact value of an expression for operands that are given as numbers: 'S: sphere = 0,0,0,1; L: line = …'.
int eval(const eval_options &o);
// Writes a first algebra, a scene, and a CMake project with a program into a folder that is new or empty.
int new_project(const std::string &folder);
// A table of what the scenes' code costs: its size, and the operations and stored values of all kernels together.
int compare_scenes(const compare_options &o);
// The values of --emit.
std::vector<std::string> stages();

} // namespace meetc
