// Names of values in emitted formulas: those of the spec, and never one that a language, a header or the function itself has.
#include "gen/support/process.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>
#include <set>
#include <sstream>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

std::string emitted(const std::string &request, const char *target = "cpp") {
  return shown(
      default_scene(),
      compile(default_scene(), lower::resolve(*default_scene().model, lang::parse_expression(request, "the test"))),
      target);
}

// The names to which "const T NAME = " gives values.
std::vector<std::string> locals(const std::string &text) {
  const std::string start = "const T ";
  std::vector<std::string> out;
  for (std::size_t at = 0; (at = text.find(start, at)) != std::string::npos; at += start.size()) {
    const std::size_t end = text.find(" = ", at);
    const std::string name = text.substr(at + start.size(), end - at - start.size());
    if (name.find_first_of("*&, ") == std::string::npos)
      out.push_back(name);
  }
  return out;
}

// Function names that C++, C, CUDA, GLSL, WGSL or Python reserve, that headers have as macros, or that emitted code uses.
const std::vector<std::string> words{
    "t3",     "b7",      "k",     "f",        "fa",       "np",   "isinstance", "filter", "register", "fn",
    "let",    "lambda",  "def",   "template", "float",    "vec3", "precise",    "of_X",   "X_blade",  "gl_x",
    "M_PI",   "complex", "errno", "small",    "T",        "W",    "value",      "main",   "fields_a", "double",
    "inline", "sign2",   "var",   "near",     "blade_of", "pair", "mix_",       "_x",     "a__b",     "not_eq"};

std::string algebra_of_words() {
  std::string out =
      "[algebra]\nvectors = ['e1', 'PI', 'blade', 't']\nsquares = [1, 1, 1, 0]\n[kinds.vec]\n"
      "store = ['x: real', 'y: real', 'z: real', 'w: real']\nblade = 'x*e1 + y*PI + z*blade + w*t'\n[functions]\n";
  for (std::size_t i = 0; i < words.size(); ++i)
    out += fmt::format("'{0}(U, V)' = 'U * V + {1}*(V * U)'\n'use{1}(U, V)' = '{0}(U, V) * {0}(U, V) * U'\n"
                       "'square{1}(U, V)' = '({0}(U, V) * ~{0}(U, V))[1]'\n",
                       words[i], i + 2);
  return out;
}

} // namespace

TEST_CASE("values have the spec's names where they have one, and numbers where they have none") {
  const std::string meet = emitted("meet(circle, sphere)");
  for (const char *b : {"e1_e2", "e1_nb", "n_nb"})
    CHECK_THAT(meet, contains(fmt::format("const T B_{0} = ", b)) && contains(fmt::format("B.{0} = B_{0};", b)));
  const std::string norm2 = emitted("norm2(meet(circle, circle))");
  CHECK_THAT(norm2, contains("const T norm2 = ") && contains("return norm2;") && contains("const T t0 = "));
  CHECK_THAT(norm2, contains("const T meet_e1 = ") && contains("meet_e1 * meet_e1"));
  // In every language alike.
  for (const auto &[target, start] : {std::pair("c", "const double "), std::pair("python", "    "),
                                      std::pair("glsl", "float "), std::pair("wgsl", "let ")})
    CHECK_THAT(emitted("norm2(meet(circle, circle))", target), contains(fmt::format("{}meet_e1 = ", start)));
  CHECK(norm2 == emitted("norm2(meet(circle, circle))")); // the same bytes
}

TEST_CASE("each name in a function is given once") {
  for (const lower::kernel *k : default_kernels(want::formulas)) {
    std::istringstream functions(shown(default_scene(), *k, "cpp"));
    std::string line, body;
    const auto check = [&] {
      const std::vector<std::string> all = locals(body);
      CHECK(std::set<std::string>(all.begin(), all.end()).size() == all.size());
    };
    INFO(k->asked.text);
    while (std::getline(functions, line))
      if (line.find("template <class T>") != std::string::npos)
        check(), body.clear();
      else
        body += line + '\n';
    check();
  }
}

TEST_CASE("functions with reserved names give code that compiles") {
  const temporary_folder folder;
  folder.write("a.toml", algebra_of_words());
  std::string kernels;
  for (std::size_t i = 0; i < words.size(); ++i)
    kernels += fmt::format("{0}'use{1}(vec, vec)', 'square{1}(vec, vec)'", i ? ", " : "", i + 2);
  folder.write("s.toml",
               fmt::format("[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nbackends = ['cpp', 'c', 'python', 'glsl', "
                           "'wgsl']\nrungs = ['fp32']\nkernels = [{}]\n",
                           kernels));
  const outcome o = run_meetc("generate s.toml -o out", folder.path());
  INFO(o.err);
  REQUIRE(o.code == 0);
  const fs::path out = folder.path() / "out";
  const std::string all = read(out / "k" / "k.h"), in = "-I" + out.string();
  std::size_t named = 0; // the test is of names that are used
  for (const std::string &word : words)
    named += all.find("const double " + word) != std::string::npos ||
             all.find("const double value_" + word) != std::string::npos;
  CHECK(named > words.size() / 2);
  folder.write("use.cpp", "#include <complex>\n#include <cmath>\n#include <k/k.hpp>\nint main() {}\n");
  folder.write("use.c", "#include <complex.h>\n#include <math.h>\n#include <k/k.h>\nint main(void) { return 0; }\n");
  const auto compiles = [&](const std::vector<std::string> &command) {
    const finished_process done = run_process(command);
    INFO(done.said);
    CHECK(done.code == 0);
  };
  compiles({"c++", "-std=c++20", "-Wall", "-Wextra", "-Wshadow", "-Werror", "-fsyntax-only", in,
            (folder.path() / "use.cpp").string()});
  compiles({"cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", in,
            (folder.path() / "use.c").string()});
  compiles({"python3", "-m", "py_compile", (out / "k" / "k.py").string()});
  if (run_process({"glslangValidator", "--version"}).code == 0) {
    folder.write("use.comp", "#version 460\n" + read(out / "k" / "k.glsl") + "void main() {}\n");
    compiles({"glslangValidator", (folder.path() / "use.comp").string()});
  }
}
