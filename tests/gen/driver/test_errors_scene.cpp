// Scenes, files and command lines that must fail.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>
#include <fstream>

using namespace meetc::compiler_test;

namespace {
// A request for one kernel; the error's place is in s.toml.
struct request {
  const char *kernels, *place, *message, *marked, *trail;
};
const request requests[] = {
    {"'tuch'", "s.toml:4:13", "no predicate 'tuch'; predicates: touch; a function is applied to kinds", "tuch", ""},
    {"'sphere'", "s.toml:4:13",
     "'sphere' is a kind; a kernel is a predicate's name, or an expression of kinds, as in 'rev(sphere)'", "sphere",
     ""},
    {"'1'", "s.toml:4:13", "a kernel is a predicate's name, or an expression of kinds with one value or one sign", "1",
     ""},
    {"'2*e12'", "s.toml:4:13",
     "'2*e12' names no kind, and so is one number or multivector for ever; meetc eval prints it", "2*e12", ""},
    {"'[sphere, sphere]'", "s.toml:4:13", "a kernel is a predicate's name, or an expression of kinds",
     "[sphere, sphere]", ""},
    {"'all(k in axes: sphere)'", "s.toml:4:13", "all else is said by a predicate of the algebra: [predicates.NAME]",
     "all(k in axes: sphere)", ""},
    {"'*'", "s.toml:4:13", "expected a value, found '*'", "*", ""},
    {"'meet(*, * )', 'meet(*, *'", "s.toml:4:36", "expected a value, found '*'", "*", ""},
    {"'meet(*)'", "s.toml:4:12", "'meet(*)' has no value for any kinds; meet(point): 'meet' takes 2 arguments, not 1",
     "'meet(*)'", ""},
    {"'meet(point, *)', 'meet(*, segment)', 'meet(point, meet(point, *))'", "s.toml:4:50",
     "'meet(point, meet(point, *))' has no value for any kinds; meet(point, meet(point, point)): meet(point, point) is "
     "not "
     "defined here",
     "'meet(point, meet(point, *))'", ""},
    {"'gp(*, *)'", "s.toml:4:12", "'gp(*, *)' has no value for any kinds; gp(point, point): no function 'gp'",
     "'gp(*, *)'", ""},
    {"'*(*, *)'", "s.toml:4:13", "expected a value, found '*'", "*", ""},
    {"'meet(*, *)*meet(*, *)*meet(*, *)*meet(*, *)*meet(*, *)*meet(*, *)'", "s.toml:4:12",
     "stands for more than 2000 kernels; name some of its kinds, or those that the scene wants: kinds = ['point', …]",
     "'meet(*, *)*meet(*, *)*meet(*, *)*meet(*, *)*meet(*, *)*meet(*, *)'", ""},
    {"'sphere*(sphere*sphere)', '(sphere*sphere)*sphere'", "s.toml:4:38",
     "'(sphere*sphere)*sphere' would have the name product_product_sphere_sphere_sphere as 'sphere*(sphere*sphere)' "
     "has; give "
     "one of them a name by a function of the algebra",
     "'(sphere*sphere)*sphere'", ""},
    {"'norm2(meet(sphere, sphere)) > 0'", "s.toml:4:13", "a kernel is a predicate's name, or an expression of kinds",
     "norm2(meet(sphere, sphere)) > 0", ""},
    {"'meet(sphere)'", "s.toml:4:13", "'meet' takes 2 arguments, not 1", "meet(sphere)",
     "in kernel meet(sphere), at s.toml:4:12"},
    {"'meet(sphere, sphere, point)'", "s.toml:4:13", "'meet' takes 2 arguments, not 3", "meet(sphere, sphere, point)",
     ""},
    {"'norm2(grade(sphere, point, point))'", "s.toml:4:19", "'grade' takes 1 or 2 arguments, not 3",
     "grade(sphere, point, point)", ""},
    {"'norm2(grade())'", "s.toml:4:13", "'norm2(grade())' names no kind", "norm2(grade())", ""},
    {"'meat(sphere, sphere)'", "s.toml:4:13", "no function 'meat'; functions: norm2, side, meet; did you mean 'meet'?",
     "meat(sphere, sphere)", ""},
    {"'touch(sphere, sphere)'", "s.toml:4:13", "'touch' is a predicate, whose kinds are its own; write 'touch'",
     "touch(sphere, sphere)", ""},
    {"'meet(sphere, spere)'", "s.toml:4:26", "no kind 'spere'; kinds: point, sphere, segment; did you mean 'sphere'?",
     "spere", ""},
    {"'meet(point, point)'", "s.toml:4:13",
     "meet(point, point) is not defined here: grade(X) + grade(Y) >= 5 does not hold, grade(X) = 1, grade(Y) "
     "= 1",
     "meet(point, point)", "in kernel meet(point, point), at s.toml:4:12"},
    {"'norm2(sphere.c)'", "s.toml:4:19", "a kernel takes kinds as wholes", "sphere.c", ""},
    {"'sign(sphere)'", "s.toml:4:18", "a multivector where a number is needed", "sphere", ""},
    {"'meet(sphere, sphere)', 'meet( sphere , sphere )'", "s.toml:4:36", "'meet( sphere , sphere )' is asked for twice",
     "'meet( sphere , sphere )'", ""},
    {"'touch', 'touch'", "s.toml:4:21", "'touch' is asked for twice", "'touch'", ""},
    {"'[sphere]'", "s.toml:4:13", "a kernel is a predicate's name, or an expression of kinds", "[sphere]", ""},
    {"\"touch\"", "s.toml:4:12", "each item of scene.kernels must be a 'literal' string in single quotes", "\"touch\"",
     ""},
    {"3", "s.toml:4:12", "each item of scene.kernels must be a string", "3", ""},
    {"''", "s.toml:4:13", "expected a value", "'", ""},
};

// Whole scenes, on a.toml as it is.
struct scene_row {
  const char *text, *place, *message, *marked;
};
const scene_row scenes[] = {
    {"", "s.toml:1:1", "s.toml has no [scene]", ""},
    {"# nothing\n", "s.toml:1:1", "s.toml has no [scene]", "#"},
    {"scene = 3\n", "s.toml:1:9", "scene must be a table", "3"},
    {"this is no toml\n", "s.toml:1:6", "expected '='", "i"},
    {"[scene\n", "s.toml:1:7", "in a table header: expected ']'", ""},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nkernel = []\n", "s.toml:5:1",
     "scene has no 'kernel'; it may have: algebra, namespace, kernels, zero, rungs, backends, box, tolerance, kinds, "
     "spec; did you "
     "mean "
     "'kernels'?",
     "kernel"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\n[scenes]\n", "s.toml:5:2",
     "a scene has no 'scenes'; it may have: scene; did you mean 'scene'?", "scenes"},
    {"[scene]\nalgebra = 'a.toml'\nkernels = []\n", "s.toml:1:1", "scene needs 'namespace'", "[scene]"},
    {"[scene]\nnamespace = 'x'\nkernels = []\n", "s.toml:1:1", "scene needs 'algebra'", "[scene]"},
    {"[scene]\nnamespace = 'x'\nalgebra = 'a.toml'\n", "s.toml:1:1", "scene needs 'kernels'", "[scene]"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = '1x'\nkernels = []\n", "s.toml:3:13",
     "'1x' is not a name for a namespace", "'1x'"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = '../x'\nkernels = []\n", "s.toml:3:13", "'../x' is not a name",
     "'../x'"},
    {"[scene]\nalgebra = 'b.toml'\nnamespace = 'x'\nkernels = []\n", "s.toml:2:11", "cannot find the algebra 'b.toml'",
     "'b.toml'"},
    {"[scene]\nalgebra = '.'\nnamespace = 'x'\nkernels = []\n", "s.toml:2:11", "cannot find the algebra '.'", "'.'"},
    {"[scene]\nalgebra = 's.toml'\nnamespace = 'x'\nkernels = []\n", "s.toml:1:2", "an algebra has no 'scene'",
     "scene"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = 'touch'\n", "s.toml:4:11",
     "scene.kernels must be an array", "'touch'"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nrungs = ['fp32', 'fp8']\n", "s.toml:5:18",
     "no 'fp8' in rungs; known: fp32, fp64, fp64x2, exact, certified", "'fp8'"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nbox = 0\n", "s.toml:5:7",
     "scene.box must be a number above 0", "0"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nbox = '1'\n", "s.toml:5:7",
     "scene.box must be a number above 0", "'1'"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nbox = inf\n", "s.toml:5:7",
     "scene.box must be a number above 0", "inf"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nbox = 1e39\n", "s.toml:5:7",
     "scene.box must be below 2^127", "1e39"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nbox = 1e-40\n", "s.toml:5:7",
     "scene.box must be at least 2^-126", "1e-40"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nbackends = ['opencl']\n", "s.toml:5:13",
     "no 'opencl' in backends; known: cpp, c, python, glsl, wgsl, cuda, every_pair", "'opencl'"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = []\nbackends = ['cpp', 'cpp']\n", "s.toml:5:20",
     "'cpp' is given twice", "'cpp'"},
    {"[scene]\nalgebra = 'a.toml'\nnamespace = 'touch'\nkernels = ['touch']\n", "s.toml:4:13",
     "'touch/touch.hpp' would be written twice", "touch"},
};

} // namespace

TEST_CASE("kernels that a scene cannot have") {
  for (const request &r : requests) {
    INFO(r.kernels);
    const temporary_folder folder;
    folder.write("a.toml", small_algebra);
    folder.write("s.toml", small_scene(r.kernels));
    check_error(folder, "s.toml", {"", "", r.place, r.message, r.marked, r.trail});
  }
}

TEST_CASE("scene files that are not scenes") {
  for (const scene_row &r : scenes) {
    INFO(r.text);
    const temporary_folder folder;
    folder.write("a.toml", small_algebra);
    folder.write("s.toml", r.text);
    check_error(folder, "s.toml", {"", "", r.place, r.message, r.marked, ""});
  }
}

TEST_CASE("missing files, and paths that are not files") {
  const temporary_folder folder;
  folder.write("a.toml", small_algebra);
  folder.write("s.toml", small_scene("'touch'"));
  check_error(folder, "gone.toml", {"", "", "", "gone.toml: cannot be read", "", ""});
  check_error(folder, ".", {"", "", "", ".: is a folder, not a file", "", ""});
  folder.write("a.toml", "");
  check_error(folder, "s.toml", {"", "", "a.toml:1:1", "a.toml declares no [algebra]", "", ""});
  folder.write("a.toml", edited(small_algebra, "r*r*n", std::string("r*\xff", 3)));
  check_error(folder, "s.toml", {"", "", "a.toml:19:19", "invalid utf-8", "*", ""});
}

TEST_CASE("imports: a missing file, a folder, another algebra, a scene, a broken file, and a cycle") {
  const auto fails = [](const std::string &import, const std::string &imported, const broken &want) {
    const temporary_folder folder;
    folder.write("a.toml", edited(small_algebra, "null ", "import = ['" + import + "']\nnull "));
    folder.write("b.toml", imported);
    folder.write("s.toml", small_scene("'touch'"));
    check_error(folder, "s.toml", want);
  };
  fails("gone.toml", "", {"", "", "a.toml:4:11", "cannot find 'gone.toml'", "'gone.toml'", ""});
  fails(".", "", {"", "", "a.toml:4:11", "cannot find '.'", "'.'", ""});
  fails("s.toml", "", {"", "", "s.toml:1:2", "an algebra has no 'scene'", "scene", ""});
  fails("b.toml", "[algebra]\nvectors = ['f']\nsquares = [1]\n",
        {"", "", "b.toml:1:1", "an imported file cannot declare an algebra of its own", "[algebra]", ""});
  fails("b.toml", "[functions]\n'f(x)' = 'x +'\n", {"", "", "b.toml:2:13", "expected a value", "+", ""});
  fails("b.toml", "[functions]\n'norm2(x)' = 'x'\n",
        {"", "", "b.toml:2:1", "function 'norm2' is already declared at a.toml:32:1", "'norm2(x)'", ""});
  const temporary_folder folder; // a circle ends, and its definitions are there once
  folder.write("a.toml", edited(small_algebra, "null ", "import = ['b.toml', './b.toml']\nnull "));
  folder.write("b.toml", "import = ['c.toml', 'b.toml']\n[functions]\n'b(x)' = 'c(x)'\n");
  folder.write("c.toml", "import = ['b.toml', 'a.toml']\n[functions]\n'c(x)' = 'norm2(x)'\n");
  folder.write("s.toml", small_scene("'b(sphere)'"));
  CHECK(run_meetc("generate s.toml -o out", folder.path()).code == 0);
}

TEST_CASE("command lines that must fail") {
  const temporary_folder folder;
  folder.write("a.toml", small_algebra);
  folder.write("s.toml", small_scene("'touch'"));
  folder.write("file", "mine");
  struct line {
    const char *arguments, *message;
  };
  const line lines[] = {
      {"", "subcommand"},
      {"frobnicate", "meetc: "},
      {"generate", "scene"},
      {"generate s.toml", "--out"},
      {"generate s.toml -o out --bogus", "--bogus"},
      {"generate s.toml -o file", "file: is not a folder"},
      {"generate s.toml -o file/under", "cannot be"},
      {"generate s.toml -o out --namespace '../up'", "'../up'"},
      {"generate s.toml -o out --namespace ''", ""},
      {"verify s.toml --cases 0", "--cases"},
      {"show s.toml --emit=poly", "nothing to show: name a kernel"},
      {"show s.toml meet sphere spere", "no kind 'spere'"},
      {"show s.toml meet sphere sphere --emit=assembly", "--emit"},
      {"show s.toml -e 'norm2(S)' --with 'S: sphere' --emit=separate", "'norm2(S)' has 1"},
      {"show s.toml meet 'sphere)('", "the command line:1:"},
      {"show s.toml -e 'norm2(S)' --with 'S sphere'", "expected 'name: kind'"},
      {"show s.toml -e 'norm2(S)' --with 'S: spere'", "no kind 'spere'"},
      {"show s.toml -e 'norm2(T)' --with 'S: sphere'", "unknown name 'T'"},
      {"show s.toml -e 'norm2(S, S)' --with 'S: sphere'", "'norm2' takes 1 argument, not 2"},
      {"show s.toml -e 'sign()' --with 'S: sphere'", "'sign' takes 1 argument, not 0"},
      {"show s.toml -e '(' --with 'S: sphere'", "-e:1:1: error: "},
  };
  for (const line &l : lines) {
    INFO(l.arguments);
    const outcome o = run_meetc(l.arguments, folder.path());
    INFO(o.err);
    const bool is_default_namespace = std::string_view(l.message).empty();
    CHECK(o.code == (is_default_namespace ? 0 : 2)); // an empty --namespace is the scene's own
    CHECK_THAT(o.err, contains(l.message));
    CHECK(o.err.find("internal") == std::string::npos);
  }
  CHECK(read(folder.path() / "file") == "mine");
  CHECK_FALSE(fs::exists(folder.path().parent_path() / "up"));
}

TEST_CASE("a predicate has one order") {
  const temporary_folder folder;
  fs::copy(source_folder() / "algebra_spec", folder.path(), fs::copy_options::recursive);
  std::ofstream(folder.path() / "predicates" / "order.toml", std::ios::app)
      << "[functions.'last_met(s, w)']\nis = 'sign(meet(w.t, s.p) - meet(w.u, s.p))'\norders = 'segment_triangle'\n";
  folder.write("s.toml", "[scene]\nalgebra = 'cga3.toml'\nnamespace = 'x'\nkernels = ['segment_triangle', "
                         "'first_met(segment, triangle_pair)', 'last_met(segment, triangle_pair)']\n");
  const outcome o = run_meetc("generate s.toml -o out", folder.path());
  CHECK(o.code == 2);
  CHECK_THAT(o.err, contains("s.toml:4:69: error: 'last_met(segment, triangle_pair)' orders segment_triangle as "
                             "'first_met(segment, triangle_pair)' does, and a predicate has one order"));
  CHECK_FALSE(fs::exists(folder.path() / "out"));
}
