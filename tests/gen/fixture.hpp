// Shared by the compiler's tests: the shipped scene compiled once, temporary folders, and the program itself.
#ifndef MEETC_TESTS_COMPILER_FIXTURE_HPP
#define MEETC_TESTS_COMPILER_FIXTURE_HPP

#include "gen/driver.hpp"
#include "gen/ir/count.hpp"
#include "gen/ir/evaluate.hpp"
#include "gen/oracle/dense.hpp"
#include "tests/catch.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace meetc::compiler_test {

using meetc::test::contains;

namespace fs = std::filesystem;

fs::path source_folder();           // of the checkout
fs::path default_scene_path();      // algebra_spec/scenes/default.toml
const compilation &default_scene(); // compiled, once a run
const lower::kernel &default_kernel(const std::string &name);
const bound::kernel_bounds &default_bounds(const std::string &name);
enum class want { formulas, signs, predicates, made_of_signs }; // the last: signs and predicates
std::vector<const lower::kernel *> default_kernels(want what);

std::string read(const fs::path &path);

// A separate folder in the system's temporary one, removed at the end.
class temporary_folder {
public:
  temporary_folder();
  ~temporary_folder();
  temporary_folder(const temporary_folder &) = delete;
  temporary_folder &operator=(const temporary_folder &) = delete;

  const fs::path &path() const { return path_; }
  fs::path write(const std::string &name, const std::string &text) const;

private:
  fs::path path_;
};

// The output and exit code of meetc. The shell reads `arguments`.
struct outcome {
  int code = -1;
  std::string out, err;
};
outcome run_meetc(const std::string &arguments, const fs::path &in_folder);

// A copy of algebra_spec, in which pieces of text can be replaced, with a scene that asks for `kernels`
// (comma-separated, unquoted).
class spec_copy {
public:
  explicit spec_copy(const std::vector<std::string> &kernels);
  // Replaces the first occurrence; fails the test when there is none.
  void replace(const std::string &file, const std::string &from, const std::string &to) const;
  fs::path folder() const { return folder_.path(); }
  fs::path scene() const { return folder_.path() / "scenes" / "asked.toml"; }
  compilation compile() const;

private:
  temporary_folder folder_;
};

// The metric of an algebra as the oracle takes it, and the declared vectors as rows of the identity.
oracle::matrix declared_metric(const lower::model &m);
oracle::matrix identity(std::size_t n);

// A polynomial of `--emit=json`: [coefficient, {name: exponent, ...}] by term.
template <class Json>
oracle::rational evaluate(const Json &polynomial, const std::map<std::string, oracle::rational> &at) {
  oracle::rational sum = 0;
  for (const Json &term : polynomial) {
    oracle::rational product(term.at(0).template get<std::string>());
    product.canonicalize();
    for (const auto &[name, exponent] : term.at(1).items())
      for (int i = 0; i < exponent.template get<int>(); ++i)
        product *= at.at(name);
    sum += product;
  }
  return sum;
}

std::string shown(const compilation &c, const lower::kernel &k, const std::string &target);
lower::kernel compile_text(const compilation &c, const std::string &request);
lower::kernel compile_expression(const compilation &c, const std::string &expression,
                                 const std::vector<std::pair<std::string, std::string>> &with);

} // namespace meetc::compiler_test

#endif
