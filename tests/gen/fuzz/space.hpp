// The algebras of the fuzzer, spelled a second time: vectors, metric, kinds and functions as arithmetic of the oracle. The
// files in spec/ say the same to meetc.
#ifndef MEETC_TESTS_FUZZ_SPACE_HPP
#define MEETC_TESTS_FUZZ_SPACE_HPP

#include "gen/oracle/dense.hpp"

#include <functional>
#include <string>
#include <vector>

namespace meetc::fuzz {

using oracle::multivector;
using oracle::rational;

class space;

// A kind of operand: how many numbers it stores, and the blade that they say, in the declared basis.
struct kind {
  std::string name;
  std::size_t stored;
  std::function<multivector(const space &, const std::vector<rational> &)> blade;
  std::vector<bool> support = {}; // by declared blade
  int grade = -1;                 // -1: mixed
};

class space {
public:
  // `working`: rows of the vectors of lowering in the declared ones, where they differ.
  space(std::string name, std::vector<std::string> vectors, const oracle::matrix &metric,
        std::vector<std::pair<std::string, std::vector<rational>>> null = {});

  const std::string &name() const { return name_; }
  const oracle::dense_algebra &algebra() const { return algebra_; }
  const std::vector<std::string> &vectors() const { return vectors_; }
  const std::vector<std::string> &null_vectors() const { return null_; }
  bool is_orthogonal() const { return orthogonal_; }
  const std::vector<kind> &kinds() const { return kinds_; }
  const kind &find(const std::string &kind) const;

  void add(kind k);     // computes its support and grade
  void add_by_grades(); // g1, g2, ..., even, odd, full: one stored number for each blade

  // A vector, declared or null, or I. Throws std::out_of_range.
  const multivector &vector(const std::string &name) const;
  multivector blade(const std::vector<std::string> &vectors) const; // their outer product; none: 1
  // The same multivector by coefficients on blades of the vectors of lowering.
  multivector in_working(const multivector &declared) const;
  std::size_t working_blade(const std::vector<std::string> &vectors) const; // its index there

  // The text of general.toml: the kinds of add_by_grades().
  std::string general_text() const;

private:
  std::string name_;
  std::vector<std::string> vectors_, working_, null_;
  oracle::dense_algebra algebra_;
  bool orthogonal_;
  std::vector<std::pair<std::string, multivector>> known_;
  std::vector<std::vector<rational>> declared_in_working_;
  std::vector<kind> kinds_;
};

// cga2, cga3, pga3, r33.
const std::vector<space> &spaces();

} // namespace meetc::fuzz

#endif
