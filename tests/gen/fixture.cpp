#include "tests/gen/fixture.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace meetc::compiler_test {

fs::path source_folder() {
  return MEETC_SOURCE_DIR;
}
fs::path default_scene_path() {
  return source_folder() / "algebra_spec" / "scenes" / "default.toml";
}

const compilation &default_scene() {
  static const compilation compiled = [] {
    compilation c = load(default_scene_path().string());
    compile_all(c);
    return c;
  }();
  return compiled;
}

const lower::kernel &default_kernel(const std::string &name) {
  for (const lower::kernel &k : default_scene().kernels)
    if (k.asked.name() == name)
      return k;
  throw std::logic_error("the default scene has no " + name);
}

const bound::kernel_bounds &default_bounds(const std::string &name) {
  const auto at = static_cast<std::size_t>(&default_kernel(name) - default_scene().kernels.data());
  return default_scene().bounds.at(at).value();
}

std::vector<const lower::kernel *> default_kernels(want what) {
  std::vector<const lower::kernel *> out;
  for (const lower::kernel &k : default_scene().kernels)
    if (what == want::formulas        ? !k.is_predicate
        : what == want::made_of_signs ? k.is_predicate
                                      : k.is_predicate && k.is_sign == (what == want::signs))
      out.push_back(&k);
  return out;
}

std::string read(const fs::path &path) {
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

temporary_folder::temporary_folder() {
  std::string name = (fs::temp_directory_path() / "meetc-test-XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw std::runtime_error("no temporary folder");
  path_ = name;
}
temporary_folder::~temporary_folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}
fs::path temporary_folder::write(const std::string &name, const std::string &text) const {
  const fs::path path = path_ / name;
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

outcome run_meetc(const std::string &arguments, const fs::path &in_folder) {
  const temporary_folder said;
  const fs::path out = said.path() / "out", err = said.path() / "err";
  const std::string command = fmt::format("cd '{}' && '{}' {} >'{}' 2>'{}'", in_folder.string(), MEETC_PROGRAM,
                                          arguments, out.string(), err.string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
}

spec_copy::spec_copy(const std::vector<std::string> &kernels) {
  fs::copy(source_folder() / "algebra_spec", folder_.path(), fs::copy_options::recursive);
  std::string text = "[scene]\nalgebra = '../cga3.toml'\nnamespace = 'asked'\nkernels = [\n";
  for (const std::string &k : kernels)
    text += fmt::format("  '{}',\n", k);
  folder_.write("scenes/asked.toml", text + "]\n");
}

void spec_copy::replace(const std::string &file, const std::string &from, const std::string &to) const {
  const fs::path path = folder_.path() / file;
  std::string text = read(path);
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
    FAIL(file << " does not hold '" << from << "'; the test is out of date");
  text.replace(at, from.size(), to);
  folder_.write(file, text);
}

compilation spec_copy::compile() const {
  compilation c = load(scene().string());
  compile_all(c);
  return c;
}

oracle::matrix declared_metric(const lower::model &m) {
  const auto n = static_cast<std::size_t>(m.declared().vectors());
  oracle::matrix out(n, std::vector<oracle::rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      out[i][j] = m.declared().product(static_cast<int>(i), static_cast<int>(j));
  return out;
}

oracle::matrix identity(std::size_t n) {
  oracle::matrix out(n, std::vector<oracle::rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    out[i][i] = 1;
  return out;
}

std::string shown(const compilation &c, const lower::kernel &k, const std::string &target) {
  return meetc::shown(c, {k, std::nullopt}, target);
}

lower::kernel compile_text(const compilation &c, const std::string &request) {
  return compile(c, lower::resolve(*c.model, lang::parse_expression(request, "a test"))).kernel;
}

lower::kernel compile_expression(const compilation &c, const std::string &expression,
                                 const std::vector<std::pair<std::string, std::string>> &with) {
  return compile(c, lower::resolve(*c.model, lang::parse_expression(expression, "a test"), with)).kernel;
}

} // namespace meetc::compiler_test
