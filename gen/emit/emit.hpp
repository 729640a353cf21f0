// Emitters: text from compiled kernels. They decide nothing.
#pragma once
#include "gen/dag/kernel.hpp"

#include <functional>
#include <string>
#include <vector>

namespace meetc::emit {

struct file {
  std::string path; // relative to the output folder, '/' between parts
  std::string text;
};

// Everything that an emitter of whole files needs.
struct unit {
  const spec::scene &scene;
  const decide::model &model;
  std::vector<dag::kernel> kernels;
};

// Headers, the runtime table and the CUDA launchers, as the scene's backends ask. Sorted by path.
std::vector<file> cpp_files(const unit &u);

std::string json(const decide::model &m, const dag::kernel &k);
std::string latex(const decide::model &m, const dag::kernel &k);
std::string poly_text(const decide::model &m, const dag::kernel &k);
// The graph, one node a line; `schedule` in the order and with the names in which it is emitted.
std::string dag_text(const dag::kernel &k, bool schedule);
// A kernel's own header.
std::string cpp_text(const unit &u, const dag::kernel &k);

// The CUDA launchers of the unit's predicates.
std::string cuda_text(const unit &u);

} // namespace meetc::emit
