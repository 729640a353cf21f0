// Specs that run away: deep, long, exponential, huge. Each ends soon, with a clear error and without a crash.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <sys/resource.h>

using namespace meetc::compiler_test;

namespace {

std::string repeat(const std::string &text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i)
    out += text;
  return out;
}
// line(0) ... line(n - 1)
std::string lines(int n, const std::function<std::string(int)> &line) {
  std::string out;
  for (int i = 0; i < n; ++i)
    out += line(i) + '\n';
  return out;
}

double children_seconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

struct runaway {
  std::string what, from, to, message, kernels = "'norm2(meet(sphere, sphere))'";
};

void check_runaway(const runaway &r) {
  INFO(r.what);
  const temporary_folder folder;
  folder.write("a.toml", edited(small_algebra, r.from, r.to));
  folder.write("s.toml", small_scene(r.kernels));
  const double before = children_seconds();
  const outcome o = run_meetc("generate s.toml -o out", folder.path());
  const double seconds = children_seconds() - before;
  CHECK(o.code == 2);
  const std::string first = o.err.substr(0, o.err.find('\n'));
  CHECK_THAT(first, contains(": error: ") && contains(r.message));
  CHECK(first.find("internal") == std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "out"));
#if defined(__SANITIZE_ADDRESS__)
  CHECK(seconds < 60);
#else
  CHECK(seconds < 10); // a few tenths to three seconds here
#endif
}

const std::string blade = "-I*(c - r*r*n)", hit = "sign(norm2(meet(S, T))) >= 0", functions = "[functions]\n",
                  constants = "[constants]\n", touch = "'touch'";

} // namespace

TEST_CASE("expressions that are too deep or too long") {
  const std::string deep = "nested too deeply", longer = "longer than 4000 words and symbols";
  const runaway rows[] = {
      {"parentheses", blade, repeat("(", 5000) + 'c' + repeat(")", 5000), deep},
      {"brackets", blade, repeat("[", 5000) + 'c' + repeat("]", 5000), deep},
      {"minus", blade, repeat("-", 5000) + 'c', deep},
      {"not", hit, repeat("not ", 5000) + "S.r > 0", deep, touch},
      {"if", hit, repeat("if S.r > 0 then S.r > 0 else ", 5000) + "S.r > 0", deep, touch},
      {"calls", blade, repeat("norm2(", 5000) + 'c' + repeat(")", 5000), deep},
      {"a long sum", blade, 'c' + repeat(" + c", 20000), longer},
      {"a long product", blade, 'r' + repeat("*r", 20000), longer},
      {"a long wedge", blade, 'c' + repeat(" ^ c", 20000), longer},
      {"a long or", hit, "S.r > 0" + repeat(" or S.r > 0", 20000), longer, touch},
      {"many indices", blade, 'c' + repeat("[1]", 20000), longer},
      {"many members", blade, 'c' + repeat(".x", 20000), longer},
      {"a long list", "[p, q]'\nparts", "[p" + repeat(", q", 20000) + "]'\nparts", longer},
      {"a long number", blade, "c - " + repeat("9", 5000) + "*r*r*n", "this number has more than 300 digits"},
      {"a long fraction", blade, "c - 0." + repeat("1", 5000) + "*r*r*n", "this number has more than 300 digits"},
      {"the longest sum that is read", blade, 'c' + repeat(" + c", 1990), "more than 400 levels"},
      {"a hundred thousand parentheses", blade, repeat("(", 100000) + 'c' + repeat(")", 100000), deep},
      {"a power of ten by a power", blade, "c - 10^1000000000*r*r*n", "'^' is the outer product"},
      {"forty vectors", "'e1', 'e2', 'e3'",
       [] {
         std::string out = "'v0'";
         for (int i = 1; i < 40; ++i)
           out += fmt::format(", 'v{}'", i);
         return out;
       }(),
       "an algebra has 1 to 8 basis vectors, not 42"},
      {"a long square", "squares = [1,", "squares = ['" + repeat("9", 5000) + "',",
       "this number has more than 300 digits"},
      {"a file of megabytes", constants, repeat("# nothing\n", 500000) + constants,
       "this file has more than 4000000 bytes"},
      {"TOML arrays", "null ", "import = " + repeat("[", 5000) + repeat("]", 5000) + "\nnull ",
       "maximum nested value depth"},
      {"TOML keys", "[constants]", '[' + repeat("a.", 5000) + "a]\nb = 1\n[constants]", "an algebra has no 'a'"},
  };
  for (const runaway &r : rows)
    check_runaway(r);
}

TEST_CASE("definitions that double at every step, forty deep") {
  const auto chain = [](const char *form, const std::string &end) {
    return lines(40, [&](int i) { return fmt::format(fmt::runtime(form), i, i + 1); }) + end;
  };
  const std::string steps = "this expands to more than 2000000 steps";
  const runaway rows[] = {
      {"f1 calls f2 twice", functions, functions + chain("'f{0}(x)' = 'f{1}(x) + f{1}(x)'", "'f40(x)' = 'x'\n"), steps,
       "'f0(sphere)'"},
      {"f1 multiplies f2 by itself", functions,
       functions + chain("'f{0}(x)' = 'f{1}(x) * f{1}(x)'", "'f40(x)' = 'x'\n"), "this is of a degree above 100",
       "'f0(sphere)'"},
      {"f1 squares what it hands to f2", functions, functions + chain("'f{0}(x)' = 'f{1}(x*x)'", "'f40(x)' = 'x'\n"),
       "this is of a degree above 100", "'norm2(f0(sphere))'"},
      {"a polynomial that grows", functions, functions + chain("'f{0}(x)' = 'f{1}(x*x + x)'", "'f40(x)' = 'x'\n"),
       "this expands to more than", "'f0(sphere)'"},
      // A constant is computed once, however often it is named, and its size has a limit.
      {"constants that square", constants, constants + chain("k{0} = 'k{1}*k{1}'", "k40 = '10000'\n"),
       "this number has more than 4096 bits", "'norm2(k0*sphere)'"},
      {"predicates", "[predicates.touch]",
       chain("[predicates.p{0}]\nof = ['S: sphere', 'T: sphere']\nhit = 'p{1}(S, T) or p{1}(T, S)'",
             "[predicates.p40]\nof = ['S: sphere', 'T: sphere']\nhit = 'S.r > T.r'\n[predicates.touch]"),
       steps, "'p0'"},
      {"kinds", functions,
       chain("[kinds.k{0}]\nstore = ['a: k{1}', 'b: k{1}']\nblade = 'e1'",
             "[kinds.k40]\nstore = ['x: real']\nblade = 'e1'\n" + functions),
       "stores more than 1000 numbers"},
      {"lists of lists", hit,
       [] {
         std::string out = "all(";
         for (int i = 0; i < 6; ++i)
           out += fmt::format("{}a{} in [1{}]", i ? ", " : "", i, repeat(",1", 300));
         return out + ": S.r > 0)";
       }(),
       steps, touch},
  };
  for (const runaway &r : rows)
    check_runaway(r);
}

TEST_CASE("long chains of definitions") {
  const std::string nested = "definitions are nested more than 500 deep";
  const runaway rows[] = {
      {"functions", functions,
       functions + lines(600, [](int i) { return fmt::format("'f{}(x)' = 'f{}(x)'", i, i + 1); }) + "'f600(x)' = 'x'\n",
       nested},
      {"constants", constants,
       constants + lines(600, [](int i) { return fmt::format("k{} = 'k{}'", i, i + 1); }) + "k600 = '1'\n", nested},
      {"kinds", functions,
       lines(600, [](int i) { return fmt::format("[kinds.k{}]\nstore = ['a: k{}']\nblade = 'e1'", i, i + 1); }) +
           "[kinds.k600]\nstore = ['x: real']\nblade = 'e1'\n" + functions,
       nested},
      {"deep calls of deep expressions", functions,
       functions +
           lines(400,
                 [](int i) {
                   return fmt::format("'f{}(x)' = '{}f{}(x){}'", i, repeat("-(", 90), i + 1, repeat(")", 90));
                 }) +
           "'f400(x)' = 'x'\n",
       "this expands to more than 400 levels", "'f0(sphere)'"},
      {"deep calls at the far end of long sums", functions,
       functions +
           lines(400, [](int i) { return fmt::format("'f{}(x)' = 'f{}(x){}'", i, i + 1, repeat(" + x", 1900)); }) +
           "'f400(x)' = 'x'\n",
       "this expands to more than 400 levels", "'f0(sphere)'"},
  };
  for (const runaway &r : rows)
    check_runaway(r);
}
