// Emitters: text from compiled kernels. They decide nothing.
#pragma once
#include "gen/bound/bound.hpp"

#include <functional>
#include <string>
#include <vector>

namespace meetc::target {

struct file {
  std::string path; // relative to the output folder, '/' between parts
  std::string text;
};

// Everything that an emitter of whole files needs.
struct unit {
  const lang::scene &scene;
  const lower::model &model;
  std::vector<lower::kernel> kernels;
  // Of kernels made of signs, where the scene asks for rungs that need them.
  std::vector<std::optional<bound::kernel_bounds>> bounds;

  bool asks(const char *rung) const;
  bool has_backend(const char *backend) const;
};

// Headers, the runtime table and the CUDA launchers, as the scene's backends ask. Sorted by path.
std::vector<file> cpp_files(const unit &u);

// The folders below the namespace's own that emitted files lie in, of C++ ("//" opens a comment) and of proofs ("#").
inline constexpr const char *code_folders[] = {"detail", "src", "units"};
inline constexpr const char *proof_folder = "proofs";

// So many sources a language that include the predicates' own sources, which lie in <space>/src: for a build that has to
// know the names of what it compiles before the scene is read.
std::vector<file> umbrella_sources(const std::vector<file> &files, const lang::scene &s, int units);

std::string json(const lower::model &m, const lower::kernel &k);
std::string latex(const lower::model &m, const lower::kernel &k);
std::string poly_text(const lower::model &m, const lower::kernel &k);
// What a kernel of two operands computes as sums of products f(X) g(Y), and the numbers of them for many kernels.
std::string separate_text(const lower::model &m, const lower::kernel &k);
std::string separate_table(const lower::model &m, const std::vector<lower::kernel> &kernels);
// The graph, one node a line; `schedule` in the order and with the names in which it is emitted.
std::string dag_text(const lower::kernel &k, bool schedule);
// A kernel's own header.
std::string cpp_text(const unit &u, std::size_t kernel);

// The CUDA launchers of the unit's predicates.
std::string cuda_text(const unit &u);

} // namespace meetc::target
