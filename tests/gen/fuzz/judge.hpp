// The right value of a formula, by the oracle, and whether its programs give it. Nothing here reads the spec or its syntax
// tree.
#ifndef MEETC_TESTS_FUZZ_JUDGE_HPP
#define MEETC_TESTS_FUZZ_JUDGE_HPP

#include "tests/gen/fuzz/compiler.hpp"

namespace meetc::fuzz {

class judge {
public:
  judge(const lower::model &m, const compiled &c) : model_(m), c_(c) {}

  // The value, by coefficients on the blades of lowering, for operands that are the coefficients of their kinds' blades, or
  // their stored numbers; one operand after another.
  multivector on_blades(const std::vector<rational> &numbers) const;
  multivector on_stored(const std::vector<rational> &numbers) const;

  std::size_t blade_numbers() const { return c_.kernel.value.blade_inputs.size(); }
  std::size_t stored_numbers() const;

  // The fault of the kernel's programs in exact arithmetic, or "". Its form in the declared basis, if that is given, is
  // judged too.
  std::string programs(std::uint64_t seed, const lower::declared_formula *declared) const;

private:
  const lower::model &model_;
  const compiled &c_;

  std::vector<multivector> stored_operands(const std::vector<rational> &numbers) const; // in the declared basis
  multivector value(const std::vector<multivector> &operands) const;                    // in the declared basis
};

} // namespace meetc::fuzz

#endif
