// Algebras that extend others, the folders where these are looked for, and the version of the language.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

const char *const extension = "[algebra]\nspec = 1\nextends = '{}'\n[functions]\n'twice(X)' = '2*norm2(X)'\n"
                              "[kinds.vec]\nstore = ['a: real', 'b: real']\nblade = 'a*e1 + b*n'\n";

std::string scene_of(const std::string &algebra, const std::string &kernels) {
  return fmt::format("[scene]\nspec = 1\nalgebra = '{}'\nnamespace = 'x'\nkernels = [{}]\n", algebra, kernels);
}

} // namespace

TEST_CASE("an algebra extends another one, from any folder") {
  const temporary_folder folder;
  folder.write("base/a.toml", small_algebra);
  folder.write("own/b.toml", fmt::format(fmt::runtime(extension), "../base/a.toml"));
  folder.write("own/c.toml", "[algebra]\nextends = 'b.toml'\n[functions]\n'thrice(X)' = 'twice(X) + norm2(X)'\n");
  folder.write("s.toml", scene_of("own/c.toml", "'thrice(vec)', 'meet(sphere, vec)', 'meet(sphere, sphere)'"));
  compilation c = load((folder.path() / "s.toml").string());
  compile_all(c);
  CHECK(c.scene->in.name == "c");
  CHECK(c.scene->in.vectors == std::vector<std::string>{"e1", "e2", "e3", "e", "eb"});
  CHECK(c.scene->in.kind_names() == std::vector<std::string>{"point", "sphere", "segment", "vec"});
  CHECK(c.scene->files.size() == 4); // so that a build knows all of them
  CHECK(c.kernels[0].value.polynomials[0].text() == "3*X.e1^2");
  CHECK(run_meetc("verify s.toml --cases 200", folder.path()).code == 0);
  // A shipped algebra needs no path.
  folder.write("own/d.toml", fmt::format(fmt::runtime(extension), "cga3.toml"));
  folder.write("t.toml", scene_of("own/d.toml", "'twice(vec)', 'meet(sphere, vec)'"));
  CHECK(run_meetc("verify t.toml --cases 200", folder.path()).code == 0);
}

TEST_CASE("the option --algebra-path names folders where algebras are looked for, by every command") {
  const temporary_folder folder;
  folder.write("one/a.toml", small_algebra);
  folder.write("two/b.toml", fmt::format(fmt::runtime(extension), "a.toml"));
  folder.write("s.toml", scene_of("b.toml", "'twice(vec)'"));
  const std::string path = "--algebra-path one --algebra-path two";
  for (const char *command : {"generate s.toml -o out", "verify s.toml", "show s.toml",
                              "show s.toml twice vec --emit=poly", "compare s.toml", "eval s.toml -e 1"}) {
    INFO(command);
    CHECK(run_meetc(fmt::format("{} {}", command, path), folder.path()).code == 0);
    const outcome o = run_meetc(fmt::format("{} --algebra-path two", command), folder.path());
    CHECK(o.code == 2);
    CHECK_THAT(o.err,
               contains("two/b.toml:3:11: error: cannot find the algebra 'a.toml'; there is no two/a.toml, no "));
  }
  // The folder of the file that names it comes first.
  folder.write("two/a.toml", edited(small_algebra, "squares = [1, 1, 1, 1, -1]", "squares = [2, 1, 1, 1, -1]"));
  CHECK_THAT(run_meetc("show s.toml twice vec --emit=poly " + path, folder.path()).out, contains("4*X.e1^2"));
}

TEST_CASE("extensions that are none, and versions that this program does not read") {
  const auto fails = [](const std::string &b, const broken &want, const char *name = "b.toml") {
    const temporary_folder folder;
    folder.write("a.toml", small_algebra);
    folder.write("kinds.toml", "[functions]\n'f(X)' = 'X'\n");
    folder.write("loop.toml", "[algebra]\nextends = 'b.toml'\n");
    folder.write("b.toml", b);
    folder.write("s.toml", scene_of(name, "'norm2(sphere)'"));
    check_error(folder, "s.toml", want);
  };
  const std::string start = "[algebra]\nextends = 'a.toml'\n";
  fails(start + "vectors = ['e1']\n",
        {"", "", "b.toml:3:11", "an algebra that extends another one has that one's 'vectors', and none of its own",
         "['e1']", ""});
  fails(start + "squares = [1]\n", {"", "", "b.toml:3:11", "that one's 'squares', and none of its own", "[1]", ""});
  fails(start + "null = ['n']\n", {"", "", "b.toml:3:8", "that one's 'null'", "['n']", ""});
  fails(start + "[constants]\nn = 'e'\n",
        {"", "", "b.toml:4:1", "constant 'n' is already declared at a.toml:8:1", "n", ""});
  fails("[algebra]\nextends = 'kinds.toml'\n", {"", "", "b.toml:2:11",
                                                "kinds.toml declares no [algebra], so there is nothing to extend; to "
                                                "take its kinds and functions, write import = "
                                                "['kinds.toml']",
                                                "'kinds.toml'", ""});
  fails("[algebra]\nextends = 'loop.toml'\n", {"", "", "loop.toml:2:11", "b.toml extends itself", "'b.toml'", ""});
  fails("[algebra]\nextends = 'b.toml'\n", {"", "", "b.toml:2:11", "b.toml extends itself", "'b.toml'", ""});
  fails("[algebra]\nextends = 'gone.toml'\n",
        {"", "", "b.toml:2:11", "cannot find the algebra 'gone.toml'; there is no gone.toml, no ", "'gone.toml'", ""});
  fails("[algebra]\nextends = 3\n", {"", "", "b.toml:2:11", "algebra.extends must be a string", "3", ""});
  fails(start + "spec = 2\n", {"", "", "b.toml:3:8", "this program reads the language 'spec = 1'", "2", ""});
  fails(start + "spec = '1'\n", {"", "", "b.toml:3:8", "this program reads the language 'spec = 1'", "'1'", ""});
  const temporary_folder folder;
  folder.write("a.toml", small_algebra);
  folder.write("s.toml", edited(scene_of("a.toml", "'touch'"), "spec = 1", "spec = 3"));
  check_error(folder, "s.toml", {"", "", "s.toml:2:8", "this program reads the language 'spec = 1'", "3", ""});
  folder.write("s.toml", scene_of("a.toml", "'touch'") + "kinds = ['sphere', 'spere']\n");
  check_error(
      folder, "s.toml",
      {"", "", "s.toml:6:20", "no kind 'spere'; kinds: point, sphere, segment; did you mean 'sphere'?", "'spere'", ""});
}
