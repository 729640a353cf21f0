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
  std::vector<std::optional<bound::kernel_bounds>> bounds; // for kernels made of signs, if a rung needs them
};

// One kernel after the last pass. It has bounds if it is made of signs and a rung of the scene needs them.
struct compiled_kernel {
  lower::kernel kernel;
  std::optional<bound::kernel_bounds> bounds;
};

compilation load(const std::string &scene_path); // spec and model, nothing compiled
compiled_kernel compile(const compilation &c, const lower::request &r);
void compile_all(compilation &c);                   // every kernel of the scene
std::vector<target::file> emit_all(compilation &c); // moves the kernels out

// A target's view of one kernel.
std::string shown(const compilation &c, const compiled_kernel &k, const std::string &target);

struct generate_options {
  std::string scene, out, depfile, stamp, space;
  std::vector<std::string> required_backends; // named by a build that compiles them
  bool check = false, quiet = false;
  bool kernel_headers = true; // write meetc/ beside what is emitted
  int units = 0;              // umbrella sources for each language, see target::umbrella_sources()
};
struct verify_options {
  std::string scene;
  long cases = 5000;
  unsigned seed = 1;
  bool allow_unchecked = false; // else a kernel of which nothing could be compared is a failure
};
struct show_options {
  std::string scene, emit = target::backends().unless_said.front(), expression, with;
  std::vector<std::string> words;
};

struct compare_options {
  std::vector<std::string> scenes;
  std::string cxx, nvcc; // compilers for the emitted sources; empty: they are not compiled
};

int generate(const generate_options &o);
// Prints which arithmetic keeps the scene's tolerance, kernel by kernel, and why.
int plan_scene(const std::string &scene);
int verify_scene(const verify_options &o);
int show(const show_options &o);
// A table of what the scenes' code costs: its size, and the operations and stored values of all kernels together.
int compare_scenes(const compare_options &o);
// The values of --emit.
std::vector<std::string> stages();

} // namespace meetc
