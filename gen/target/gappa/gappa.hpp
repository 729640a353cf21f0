// Error bounds: scripts by which Gappa proves them, and what the readable table shares with these.
#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

// A stage of a kernel that consists of signs, with its bounds.
struct bounded_stage {
  const char *name; // "reject"
  const lower::stage &signs;
  const bound::stage_bounds &bounds;
};
// The stages that kernel `i` of the unit has, in the order in which they run.
std::vector<bounded_stage> bounded_stages(const unit &u, std::size_t i);

// The powers by which a box bound is multiplied: "beta^2 D".
std::string powers_text(const bound::box_bound &b);

// The box form of every sign of the unit as scripts for Gappa, <space>/proofs/<name>.gappa, sorted by path. There is
// one for all signs that differ only in the names of their leaves.
std::vector<file> proof_files(const unit &u);

// The margins of the matrix filter of balls, for scenes with a CUDA backend.
std::vector<file> filter_proofs(const unit &u);

// The scripts of a unit that has only this kernel, one after the other.
std::string show_proofs(const unit &u, std::size_t kernel);

// Throws spec_error where a kernel has no error bounds.
void check_bounded(const unit &u, std::size_t kernel);

} // namespace meetc::target
