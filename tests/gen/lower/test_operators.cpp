// The operators of the language: against the oracle, and by identities that hold in every algebra.
#include "gen/lang/operators.hpp"
#include "gen/verify/verify.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

struct algebra_text {
  const char *name;
  std::vector<std::string> vectors;
  const char *rest; // metric, null vectors
  const char *constants;
  int square; // of I
};

const algebra_text algebras[] = {
    {"R(3)", {"e1", "e2", "e3"}, "squares = [1, 1, 1]", "", -1},
    {"R(1,3)", {"g0", "g1", "g2", "g3"}, "squares = [1, -1, -1, -1]", "", -1},
    {"R(2,2) in null vectors",
     {"e1", "e2", "e3", "e4"},
     "metric = [[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, '1/2'], [0, 0, '1/2', 0]]",
     "",
     1},
    {"R(1,1), lowered in null vectors, with an I of the other order",
     {"e1", "e2"},
     "squares = [1, -1]\nnull = ['n', 'm']",
     "n = 'e1 + e2'\nm = 'e1 - e2'\nI = 'e2 ^ e1'",
     1},
    {"R(3,1), lowered in null vectors",
     {"e1", "e2", "e3", "e4"},
     "squares = [1, 1, 1, -1]\nnull = ['n', 'nb']",
     "n = 'e3 + e4'\nnb = '3*e3 - 3*e4'\nI = 'e1 ^ e2 ^ e3 ^ e4'",
     -1},
    {"R(2,0,1)", {"e0", "e1", "e2"}, "squares = [0, 1, 1]", "I = 'e1 ^ e2 ^ e0'", 0},
    {"R(1,1,1) with another metric",
     {"a1", "a2", "a3"},
     "metric = [[1, 2, 3], [2, 3, 5], [3, 5, 8]]", // its rows are dependent
     "",
     0},
    {"R(0,0,2)", {"e1", "e2"}, "squares = [0, 0]", "", 0},
};

std::string blade_text(const algebra_text &a, std::size_t blade) {
  std::string out;
  for (std::size_t i = 0; i < a.vectors.size(); ++i)
    if (blade >> i & 1)
      out += (out.empty() ? "" : "^") + a.vectors[i];
  return out.empty() ? "1" : out;
}

// The algebra with the kinds vec, even, odd and full, by coefficients.
compilation load_in(const temporary_folder &folder, const algebra_text &a, const std::string &functions = "") {
  std::string names, kinds;
  for (const std::string &v : a.vectors)
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", v);
  const auto kind = [&](const char *name, const std::function<bool(int)> &grade) {
    std::string store, blade;
    for (std::size_t b = 0; b < std::size_t{1} << a.vectors.size(); ++b)
      if (grade(std::popcount(b))) {
        store += fmt::format("{}'c{}: real'", store.empty() ? "" : ", ", b);
        blade += fmt::format("{}c{}*({})", blade.empty() ? "" : " + ", b, blade_text(a, b));
      }
    kinds += fmt::format("[kinds.{}]\nstore = [{}]\nblade = '{}'\n", name, store, blade);
  };
  kind("vec", [](int g) { return g == 1; });
  kind("even", [](int g) { return g % 2 == 0; });
  kind("odd", [](int g) { return g % 2 == 1; });
  kind("full", [](int) { return true; });
  folder.write("a.toml",
               fmt::format("[algebra]\nvectors = [{}]\n{}\n[constants]\n{}\n{}[functions]\n'gp(A, B)' = 'A*B'\n{}",
                           names, a.rest, a.constants, kinds, functions));
  return load(folder.write("s.toml", small_scene("'gp(vec, vec)'")).string());
}

using operands = std::vector<std::pair<std::string, std::string>>;

bool is_zero(const compilation &c, const std::string &expression, const operands &with) {
  const lower::kernel k = compile_expression(c, expression, with);
  return k.value.is_expanded() && std::all_of(k.value.polynomials.begin(), k.value.polynomials.end(),
                                              [](const poly::poly &p) { return p.is_zero(); });
}

void check_zero(const compilation &c, const algebra_text &a, const std::vector<std::string> &expressions,
                const operands &with) {
  for (const std::string &e : expressions) {
    INFO(a.name << ": " << e);
    CHECK(is_zero(c, e, with));
  }
}

} // namespace

TEST_CASE("every operator has the value that the dense product gives") {
  for (const algebra_text &a : algebras) {
    const temporary_folder folder;
    const compilation c = load_in(folder, a);
    const auto agrees = [&](const std::string &expression, const operands &with) {
      INFO(a.name << ": " << expression);
      const verify::report r = verify::verify_formula(*c.model, compile_expression(c, expression, with), 12, 3);
      CHECK(r.wrong == 0);
      CHECK(r.cases > 12);
    };
    for (const lang::builtin &b : lang::builtins()) {
      if (b.name == "grade")
        for (std::size_t k = 0; k <= a.vectors.size(); ++k)
          agrees(fmt::format("grade(A, {})", k), {{"A", "full"}});
      else if (b.name == "inverse")
        agrees("inverse(2 - 1)*A", {{"A", "full"}});
      else if (b.does == lang::operation::of_versor)
        for (const char *versor : {"vec", "even", "odd"})
          agrees(b.name == "reflect" ? "reflect(A, V)" : b.name + "(V, A)", {{"V", versor}, {"A", "full"}});
      else
        agrees(b.params.size() == 1 ? b.name + "(A)" : b.name + "(A, B)",
               b.params.size() == 1 ? operands{{"A", "full"}} : operands{{"A", "full"}, {"B", "full"}});
    }
    agrees("~A & -~(B + A)", {{"A", "even"}, {"B", "full"}});
    agrees(fmt::format("{}{}*A & I", a.vectors[1], a.vectors[0].back()), {{"A", "full"}});
    if (a.square != 0) {
      agrees("inverse(3*I)*A", {{"A", "full"}});
      agrees("A/I", {{"A", "full"}});
    }
  }
}

TEST_CASE("identities of the operators, in algebras with I^2 of every sign and with null vectors") {
  for (const algebra_text &a : algebras) {
    const temporary_folder folder;
    const compilation c = load_in(folder, a);
    std::string grades;
    for (std::size_t k = 0; k <= a.vectors.size(); ++k)
      grades += fmt::format(" - grade(A, {})", k);
    const operands of_full{{"A", "full"}}, two{{"A", "full"}, {"B", "full"}},
        three{{"A", "vec"}, {"B", "even"}, {"C", "odd"}};
    check_zero(c, a,
               {"~A - rev(A)",
                "~~A - A",
                "involute(involute(A)) - A",
                "conj(A) - ~involute(A)",
                "conj(A) - involute(~A)",
                "A" + grades,
                "grade(A, 1) - grade(grade(A, 1), 1)",
                "grade(grade(A, 1), 2)",
                "scalar(A) - A[1]",
                "scalar(A) - grade(A, 0)",
                "rc(lc(A)) - A",
                "lc(rc(A)) - A",
                "dual(undual(A)) - A",
                "undual(dual(A)) - A",
                "(A & I) - A",
                "(I & A) - A",
                "rc(scalar(A)) - scalar(A)*I",
                "rnorm2(A) - rnorm2(~A)",
                "rnorm2(A) - (A*~A)[1]",
                "commutator(A, A)"},
               of_full);
    check_zero(c, a,
               {"~(A*B) - ~B*~A", "involute(A*B) - involute(A)*involute(B)", "conj(A*B) - conj(B)*conj(A)",
                "~(A ^ B) - (~B ^ ~A)", "rc(A & B) - (rc(A) ^ rc(B))", "lc(A & B) - (lc(A) ^ lc(B))",
                "rc(A ^ B) - (rc(A) & rc(B))", "regressive(A, B) - (A & B)", "scalar(A*B) - scalar(B*A)",
                "commutator(A, B) + commutator(B, A)", "A*B - B*A - 2*commutator(A, B)", "dot(A, B) - ~dot(~B, ~A)",
                "project(A, B) - dot(A, B)*~B", "rnorm2(A + B) - rnorm2(A) - rnorm2(B) - 2*scalar(A*~B)"},
               two);
    check_zero(c, a,
               {"(A & B) & C - (A & (B & C))",
                "commutator(A, commutator(B, C)) + commutator(B, commutator(C, A)) + commutator(C, commutator(A, B))",
                "commutator(A, B*C) - commutator(A, B)*C - B*commutator(A, C)", "sandwich(A, B) - A*B*~A",
                "sandwich(A, C) + A*C*~A", "sandwich(B, C) - B*C*~B", "reflect(C, A) - sandwich(A, C)"},
               three);
    check_zero(c, a,
               {"dot(A, B) - (A*B + B*A)/2", "dot(A, B) - (A | B)", "A*B - dot(A, B) - (A ^ B)",
                "project(project(A, B), B) - (B*B)*project(A, B)", "A*B*B - project(A, B) - (A ^ B)*B",
                "sandwich(A*B, C) - sandwich(A, sandwich(B, C))",
                "sandwich(A, B)*sandwich(A, C) - (A*A)*sandwich(A, B*C)", "reflect(reflect(C, A), A) - (A*A)*(A*A)*C",
                "commutator(A, B) - (A ^ B)"},
               {{"A", "vec"}, {"B", "vec"}, {"C", "vec"}});
    for (std::size_t b = 0; b < std::size_t{1} << a.vectors.size(); ++b) {
      const std::string blade = blade_text(a, b);
      if (b == 0) // a number has no outer product of this form
        check_zero(c, a, {"rc(1)*(A[1]) - A[1]*I", "lc(1)*A[1] - A[1]*I"}, of_full);
      else
        check_zero(c, a,
                   {fmt::format("(({0}) ^ rc({0}) - I)*A[1]", blade), fmt::format("(lc({0}) ^ ({0}) - I)*A[1]", blade)},
                   of_full);
    }
    const std::string first = a.vectors[0], second = a.vectors[1];
    check_zero(c, a,
               {fmt::format("({0}{2} - ({0} ^ {1}))*A", first, second, second.back()),
                fmt::format("({1}{2} - ({1} ^ {0}))*A", first, second, first.back())},
               of_full);
    if (a.square == 0)
      check_zero(c, a, {"dual(A) - rc(A)", "undual(A) - lc(A)", "scalar(A)*I*I"}, of_full);
    else
      check_zero(c, a,
                 {"dual(A) - A*inverse(I)", "undual(A) - A*I", "A/I - A*inverse(I)", "A*(inverse(I)*I) - A",
                  "A*I*I - scalar(I*I)*A"},
                 of_full);
    if (a.square != 0) {
      const lower::kernel squared = compile_expression(c, "scalar(I*I)*A[1]", of_full);
      CHECK(sgn(squared.value.polynomials.front().terms().front().coefficient) == a.square);
    }
    if (a.square != 0)
      check_zero(c, a, {"dual(A ^ B) - (A | dual(B))", "undual(A | B) - (A ^ undual(B))"},
                 {{"A", "vec"}, {"B", "full"}});
  }
}

TEST_CASE("a function of the algebra hides the operator of its name, and no operator's own definition changes by it") {
  const algebra_text &a = algebras[0];
  const temporary_folder plain, hidden;
  const compilation without = load_in(plain, a),
                    with =
                        load_in(hidden, a,
                                "'rev(A)' = '2*A'\n'rc(A)' = 'A'\n'dot(A, B)' = 'A*B'\n'grades(A)' = 'grade(A, 1)'\n");
  const operands two{{"A", "full"}, {"B", "full"}};
  for (const char *e : {"rev(A) - 2*A", "rc(A) - A", "dot(A, B) - A*B"}) {
    CHECK(is_zero(with, e, two));
    CHECK_FALSE(is_zero(without, e, two));
  }
  for (const char *e :
       {"~(A*B) - ~B*~A", "lc(A & B) - (lc(A) ^ lc(B))", "conj(A) - ~involute(A)", "grades(A) - grade(A, 1)"})
    CHECK(is_zero(with, e, two));
  CHECK(is_zero(with, "project(A, B) - (A | B)*B", {{"A", "vec"}, {"B", "vec"}}));
}

TEST_CASE("an I of the algebra that is no pseudoscalar, or another multiple of it, is refused where it is needed") {
  const auto refused = [](const char *constants, const char *expression, const char *message) {
    const algebra_text a{"R(2)", {"e1", "e2"}, "squares = [1, 1]", constants, -1};
    const temporary_folder folder;
    load_in(folder, a);
    const outcome o =
        run_meetc(fmt::format("show s.toml -e '{}' --with 'A: full' --emit=poly", expression), folder.path());
    INFO(o.err);
    CHECK(o.code == 2);
    CHECK_THAT(o.err, contains(message));
    CHECK_THAT(o.err, contains("-e:1:"));
  };
  refused("I = 'e1'", "dual(A)",
          "this needs the pseudoscalar, and the constant I, declared at a.toml:5:1, is no multiple of e1^e2");
  refused("I = '2*e12'", "A & A",
          "a complement needs I to be e1^e2 or -(e1^e2), and the constant I of this algebra is 2 times that");
  const temporary_folder folder;
  const algebra_text a{"R(2)", {"e1", "e2"}, "squares = [1, 1]", "I = '2*e12'", -1};
  const compilation c = load_in(folder, a);
  CHECK(is_zero(c, "dual(undual(A)) - A", {{"A", "full"}}));
  CHECK(is_zero(c, "dual(A) + A*I/4", {{"A", "full"}}));
  folder.write("a.toml", edited(read(folder.path() / "a.toml"), "'2*e12'", "'dual(e12)'"));
  const outcome o = run_meetc("show s.toml -e 'A' --with 'A: full'", folder.path());
  CHECK(o.code == 2);
  CHECK_THAT(o.err, contains("a.toml:5:1: error: constant 'I' is defined by itself"));
}

TEST_CASE("the table of operators in docs/spec.md is that of the compiler") {
  const std::string page = read(source_folder() / "docs" / "spec.md");
  std::string table;
  for (const lang::builtin &b : lang::builtins()) {
    std::string formula;
    for (const char c : b.formula)
      formula += c == '|' ? std::string("\\|") : std::string(1, c);
    table += fmt::format("| {} | {} |\n", b.form, formula);
  }
  CHECK_THAT(page, contains("| operator | value |\n|---|---|\n" + table + "\n"));
}
