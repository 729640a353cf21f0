// Compiles drawn specs, each in a process of its own with limits, and tells those that end otherwise than a spec may.
#pragma once
#include "tests/gen/fuzz/specs/text.hpp"

#include <string>
#include <vector>

namespace meetc::fuzz {

struct spec_plan {
  std::string algebra_spec; // the folder
  std::uint64_t seed = 1;
  std::uint64_t count = 0;
  double seconds = 20;   // of each spec
  long megabytes = 2000; // of each spec
  std::string findings;  // the folder for those that fail; empty: they are only counted
};

struct spec_tally {
  std::uint64_t compiled = 0, refused = 0;
  std::vector<std::string> findings; // one line each
};

spec_tally run_specs(const spec_plan &p);

} // namespace meetc::fuzz
