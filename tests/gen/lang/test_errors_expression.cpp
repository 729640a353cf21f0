// Expressions that cannot be read, or whose names are wrong.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

using namespace meetc::compiler_test;

namespace {
constexpr const char *blade = "'-I*(c - r*r*n)'"; // a.toml:19, its text from column 10

const broken syntax[] = {
    {blade, "'-I*(c - r*r*n'", "a.toml:19:22", "expected ')'", "n", ""},
    {blade, "'-I*(c - r*r*n))'", "a.toml:19:24", "expected the end of the expression, found ')'", ")", ""},
    {blade, "''", "a.toml:19:10", "expected a value", "'", ""},
    {blade, "'   '", "a.toml:19:12", "expected a value", " ", ""},
    {blade, "'c -'", "a.toml:19:12", "expected a value", "-", ""},
    {blade, "'c + * r'", "a.toml:19:14", "expected a value, found '*'", "*", ""},
    {blade, "'2c'", "a.toml:19:10", "a number runs into a name", "2c", ""},
    {blade, "'c $ r'", "a.toml:19:12", "'$' does not belong in an expression", "$", ""},
    {blade, "'c + é'", "a.toml:19:14", "'é' does not belong in an expression", "é", ""},
    {blade, "'c * \xe2\x88\x9e'", "a.toml:19:14", "'\xe2\x88\x9e' does not belong", "\xe2\x88\x9e", ""},
    {blade, "'c ^ n | c'", "a.toml:19:16", "'^' and '|' mixed without parentheses", "|", ""},
    {blade, "'c ^ n & c'", "a.toml:19:16", "'&' and '^' mixed without parentheses", "&", ""},
    {blade, "'c & n | c'", "a.toml:19:16", "'&' and '|' mixed without parentheses", "|", ""},
    {blade, "'c ~ n'", "a.toml:19:12", "expected the end of the expression, found '~'", "~", ""},
    {blade, "'c + ~'", "a.toml:19:14", "expected a value, found 'the end'", "~", ""},
    {blade, "'c & '", "a.toml:19:13", "expected a value, found 'the end'", " ", ""},
    {blade, "'c | n ^ c'", "a.toml:19:16", "'^' and '|' mixed without parentheses", "^", ""},
    {blade, "'c.3'", "a.toml:19:12", "expected a member's name after '.', found '3'", "3", ""},
    {blade, "'1..2'", "a.toml:19:12", "expected a member's name", ".", ""},
    {blade, "'1.'", "a.toml:19:11", "expected a member's name", ".", ""},
    {blade, "'r = 1'", "a.toml:19:12", "'=' does not belong in an expression", "=", ""},
    {blade, "'r ! 1'", "a.toml:19:12", "'!' does not belong in an expression", "!", ""},
    {blade, "'r # 1'", "a.toml:19:12", "'#' does not belong in an expression", "#", ""},
    {blade, "'a < b < c'", "a.toml:19:16", "comparisons do not chain; join them with 'and'", "<", ""},
    {blade, "'r > 0 == r'", "a.toml:19:16", "comparisons do not chain", "==", ""},
    {blade, "'if r > 0 then c'", "a.toml:19:24", "expected 'else'", "c", ""},
    {blade, "'if r > 0 else c'", "a.toml:19:19", "expected 'then', found 'else'", "else", ""},
    {blade, "'c if r'", "a.toml:19:12", "expected the end of the expression, found 'if'", "if", ""},
    {blade, "'then'", "a.toml:19:10", "expected a value, found 'then'", "then", ""},
    {blade, "'all(k axes: k)'", "a.toml:19:16", "expected 'in', found 'axes'", "axes", ""},
    {blade, "'all(k in axes, k)'", "a.toml:19:26", "expected 'in', found ')'", ")", ""},
    {blade, "'any(k in axes k)'", "a.toml:19:24", "expected ':', found 'k'", "k", ""},
    {blade, "'each(1 in axes: 1)'", "a.toml:19:15", "expected 'name in list', found '1'", "1", ""},
    {blade, "'[c, r'", "a.toml:19:14", "expected ']'", "r", ""},
    {blade, "'c[1'", "a.toml:19:12", "expected ']'", "1", ""},
    {blade, "'norm2(c'", "a.toml:19:16", "expected ')'", "c", ""},
    {blade, "'norm2(c,)'", "a.toml:19:18", "expected a value, found ')'", ")", ""},
};

const broken strings[] = {
    {blade, "\"-I*(c - r*r*n)\"", "a.toml:19:9", "kinds.sphere.blade must be a 'literal' string in single quotes",
     "\"-I*(c - r*r*n)\"", ""},
    {blade, "\"\"\"c\"\"\"", "a.toml:19:9", "'literal' string", "\"\"\"c\"\"\"", ""},
    {blade, "3", "a.toml:19:9", "kinds.sphere.blade must be a string", "3", ""},
    {blade, "['c']", "a.toml:19:9", "kinds.sphere.blade must be a string", "['c']", ""},
    // The first line break after the quotes is not part of the text; every later one counts.
    {blade, "'''\n  c -\n  r*q'''", "a.toml:21:5", "unknown name 'q'", "q", ""},
    {blade, "'''c\n  - q'''", "a.toml:20:5", "unknown name 'q'", "q", ""},
    {"blade = '-I*(c", "\tblade\t=\t'-I*(q", "a.toml:19:15", "unknown name 'q'", "q", ""},
};

const broken names[] = {
    {blade, "'q'", "a.toml:19:10", "unknown name 'q'", "q", ""},
    {blade, "'-I*(cc - axess*n)'", "a.toml:19:14", "unknown name 'cc'; did you mean 'c'?", "cc", ""},
    {blade, "'c*axess'", "a.toml:19:12", "unknown name 'axess'; did you mean 'axes'?", "axess", ""},
    {blade, "'f(c)'", "a.toml:19:10", "unknown function 'f'", "f(c)", ""},
    {blade, "'norm3(c)'", "a.toml:19:10", "unknown function 'norm3'; did you mean 'norm2'?", "norm3(c)", ""},
    {blade, "'c(r)'", "a.toml:19:10", "unknown function 'c'", "c(r)", ""},
    {blade, "'meet(c)'", "a.toml:19:10", "'meet' takes 2 arguments, not 1", "meet(c)", ""},
    {blade, "'norm2()'", "a.toml:19:10", "'norm2' takes 1 argument, not 0", "norm2()", ""},
    {blade, "'sign()'", "a.toml:19:10", "'sign' takes 1 argument, not 0", "sign()", ""},
    {blade, "'grade(c, 1, r)'", "a.toml:19:10", "'grade' takes 1 or 2 arguments, not 3", "grade(c, 1, r)", ""},
    {blade, "'grade()'", "a.toml:19:10", "'grade' takes 1 or 2 arguments, not 0", "grade()", ""},
    {blade, "'rev(c, c)'", "a.toml:19:10", "'rev' takes 1 argument, not 2", "rev(c, c)", ""},
    {blade, "'sandwich(c)'", "a.toml:19:10", "'sandwich' takes 2 arguments, not 1", "sandwich(c)", ""},
    {blade, "'commutater(c, n)'", "a.toml:19:10", "unknown function 'commutater'; did you mean 'commutator'?",
     "commutater(c, n)", ""},
    {blade, "'e14*c'", "a.toml:19:10", "unknown name 'e14'", "e14", ""},
    {blade, "'e11*c'", "a.toml:19:10", "'e11' has the vector e1 twice; a basis blade has different ones", "e11", ""},
    {blade, "'point(r, r)'", "a.toml:19:10", "'point' takes 3 arguments, not 2", "point(r, r)", ""},
    {"'sign(meet(H, p))'", "'sign(meet(H, q))'", "a.toml:32:30", "unknown name 'q'", "q", ""},
    {"'(I*X) | Y'", "'(I*X) | Z'", "a.toml:35:18", "unknown name 'Z'", "Z", ""},
    {"'e + eb'", "'e + ebb'", "a.toml:8:13", "unknown name 'ebb'; did you mean 'eb'?", "ebb", ""},
    {"'[p, q]'\nparts", "'[p, s]'\nparts", "a.toml:27:14", "unknown name 's'", "s", ""},
    {"ends = '[p, q]'", "ends = '[p, c]'", "a.toml:28:19", "unknown name 'c'", "c", ""},
    {"'r >= 0'", "'R >= 0'", "a.toml:20:10", "unknown name 'R'", "R", ""},
    {"hit = ", "reject = ['S.r > U.r']\nhit = ", "a.toml:40:18", "unknown name 'U'", "U", ""},
    {"hit = ", "let.a = 'b'\nlet.b = 'S.r'\nhit = ", "a.toml:40:10", "unknown name 'b'", "b", ""},
    {"'T: sphere'", "'T: spher'", "a.toml:39:21",
     "no kind 'spher'; kinds: point, sphere, segment; did you mean 'sphere'?", "'T: spher'", ""},
    {"'c: point'", "'c: Point'", "a.toml:18:10", "no kind 'Point'", "'c: Point'", ""},
    // A bound name lives in its body alone.
    {"'sign(norm2(meet(S, T))) >= 0'", "'all(k in axes: S.r > 0) and k > 0'", "a.toml:40:36", "unknown name 'k'", "k",
     ""},
};
} // namespace

TEST_CASE("expressions that cannot be read") {
  check_broken(syntax);
}
TEST_CASE("expressions that are not literal strings, and places inside multi-line strings") {
  check_broken(strings);
}
TEST_CASE("unknown names, and calls with too many or too few arguments") {
  check_broken(names);
}

TEST_CASE("columns are right after UTF-8, under a byte order mark and in CRLF files") {
  const auto with = [](const std::string &from, const std::string &to) { return edited(small_algebra, from, to); };
  const auto fails = [](const std::string &text, const broken &want) {
    const temporary_folder folder;
    folder.write("a.toml", text);
    folder.write("s.toml", small_scene(want.kernels));
    check_error(folder, "s.toml", want);
  };
  const auto crlf = [](const std::string &text) {
    std::string out;
    for (const char c : text)
      out += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return out;
  };
  const broken unknown{"", "", "a.toml:19:18", "unknown name 'q'", "q", ""};
  const std::string wrong = with("r*r*n", "q*r*n");
  fails(wrong, unknown);
  fails(crlf(wrong), unknown);
  const broken later{"", "", "a.toml:20:18", "unknown name 'q'", "q", ""};
  fails("# Zwölf Boxkämpfer, \xe2\x88\xa5x\xe2\x88\xa5\xc2\xb2 \xf0\x9f\x98\x80\n" + wrong, later);
  const std::string stored = "store = ['c: point', 'r: real']"; // on the line before, and behind the expression itself
  fails(edited(edited(wrong, stored, stored + " # Größe ü"), "- q*r*n)'", "- q*r*n)' # é"), unknown);
  // A string with UTF-8 earlier on the same line.
  fails(with("null ", "import = ['é.toml']\nnull "), {"", "", "a.toml:4:11", "cannot find 'é.toml'", "'é.toml'", ""});
  {
    const temporary_folder folder;
    folder.write("é.toml", "# nothing\n");
    folder.write("a.toml", with("null ", "import = ['é.toml', 'gone.toml']\nnull "));
    folder.write("s.toml", small_scene("'touch'"));
    check_error(folder, "s.toml", {"", "", "a.toml:4:22", "cannot find 'gone.toml'", "'gone.toml'", ""});
  }
  fails(with("hit = ", "reject = ['S.r > 0 # é', 'q']\nhit = "),
        {"", "", "a.toml:40:20", "'#' does not belong", "#", ""});
  const broken under_mark{"", "", "a.toml:19:18", "unknown name 'q'", "q", ""};
  fails("\xef\xbb\xbf" + wrong, under_mark);
  fails("\xef\xbb\xbf[algebrax]\n", {"", "", "a.toml:1:5", "an algebra has no 'algebrax'", "algebrax", ""});
  fails(crlf(with("'sign(norm2(meet(S, T))) >= 0'", "'''\n  S.r > 0\nand q'''")),
        {"", "", "a.toml:42:5", "unknown name 'q'", "q", ""});
}

TEST_CASE("CRLF files mean what LF files mean") {
  std::string crlf;
  for (const char *c = small_algebra; *c; ++c)
    crlf += *c == '\n' ? std::string("\r\n") : std::string(1, *c);
  const temporary_folder folder;
  folder.write("a.toml", crlf);
  folder.write("s.toml", small_scene("'norm2(meet(sphere, sphere))', 'touch'"));
  CHECK(run_meetc("generate s.toml -o out", folder.path()).code == 0);
}
