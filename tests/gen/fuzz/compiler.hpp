// Formulas through the library calls of meetc.
#ifndef MEETC_TESTS_FUZZ_COMPILER_HPP
#define MEETC_TESTS_FUZZ_COMPILER_HPP

#include "gen/driver.hpp"
#include "gen/ir/evaluate.hpp"
#include "gen/lower/declared.hpp"
#include "tests/folder.hpp"
#include "tests/gen/fuzz/draw.hpp"

namespace meetc::fuzz {

namespace fs = std::filesystem;

// How gen/lower/kernel/formula.cpp computes a value, whichever takes the fewest operations: expanded, from the arguments of
// calls, from the values of all parts.
enum class way { expanded, arguments, parts };

// A formula that compiled.
struct compiled {
  formula from;
  lower::kernel kernel;
  bool was_expanded; // false: too long
};

// One algebra, loaded.
class compiler {
public:
  explicit compiler(const space &s);

  const lower::model &model() const { return *c_.model; }
  // Throws spec_error for what the language refuses. Any other exception is a fault of meetc.
  compiled compile(const formula &f);
  // Whether the formula has a value for general operands and for stored ones, whatever compile() said of it.
  bool expands(const formula &f);
  // For the formula that was compiled last.
  way way_of(const compiled &c) const;
  // The files of a scene with these kernels.
  std::vector<target::file> emit(const std::vector<const compiled *> &all);
  // The formula in the declared basis, as the targets json and latex have it. It must be one that was expanded.
  lower::declared_formula in_declared_basis(const compiled &c);

private:
  compilation c_;
  std::size_t functions_; // of the spec itself

  void define(const formula &f); // in place of the formula before it
};

} // namespace meetc::fuzz

#endif
