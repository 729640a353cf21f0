// Tables of a spec with contents that they may not have.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

using namespace meetc::compiler_test;

namespace {
constexpr const char *squares = "squares = [1, 1, 1, 1, -1]";
constexpr const char *vectors = "vectors = ['e1', 'e2', 'e3', 'e', 'eb']";
constexpr const char *null = "null    = ['n', 'nb']";
constexpr const char *of = "of  = ['S: sphere', 'T: sphere']";

const broken keys[] = {
    {"pad   =", "pads  =", "a.toml:22:1",
     "kinds.sphere has no 'pads'; it may have: store, blade, grades, from, parts, where, hull, pad, position, "
     "relations, "
     "samples; did "
     "you mean 'pad'?",
     "pads", ""},
    {"hit =", "hits =", "a.toml:40:1",
     "predicates.touch has no 'hits'; it may have: of, let, reject, hit, mode, means, common", "hits", ""},
    {"is    =", "os    =", "a.toml:35:1",
     "functions.meet has no 'os'; it may have: is, where, orders; did you mean 'is'?", "os", ""},
    {"null    =", "nulls   =", "a.toml:4:1", "algebra has no 'nulls'", "nulls", ""},
    {"[constants]", "[constant]", "a.toml:6:2", "an algebra has no 'constant'", "constant", ""},
    {"hull  = '[c]'", "from.four.off = 1\nhull  = '[c]'", "a.toml:21:11", "kinds.sphere.from.four has no 'off'", "off",
     ""},
    {"hull  = '[c]'", "from.four.of = ['r: real']\nhull  = '[c]'", "a.toml:21:6",
     "kinds.sphere.from.four needs 'of' and 'blade'", "four", ""},
    {"store = ['c: point', 'r: real']\n", "", "a.toml:17:8", "kinds.sphere needs 'store'", "sphere", ""},
    {"blade = '-I*(c - r*r*n)'\n", "", "a.toml:17:8", "kinds.sphere needs 'blade'", "sphere", ""},
    {"is    = '(I*X) | Y'\n", "", "a.toml:34:12", "functions.meet needs 'is'", "'meet(X, Y)'", ""},
    {"hit = 'sign(norm2(meet(S, T))) >= 0'", "", "a.toml:38:13", "predicates.touch needs 'of' and 'hit'", "touch", ""},
    {"hit =", "mode = 'hollow'\nhit =", "a.toml:40:8", "predicates.touch.mode is 'solid' or 'surface'", "'hollow'", ""},
    {"hit =", "means = 'overlaps'\nhit =", "a.toml:40:9",
     "predicates.touch.means is 'touch', 'beyond', 'overlap' or 'contains'; did you mean 'overlap'?", "'overlaps'", ""},
    {"hit =", "means = 3\nhit =", "a.toml:40:9", "predicates.touch.means must be a string", "3", ""},
    {"hit =", "means = 'beyond'\nhit =", "a.toml:40:9",
     "'beyond' is a meaning of hulls, and the kind sphere of S has a pad; leave out 'means'", "'beyond'", ""},
    {"hit =", "mode = 'surface'\nmeans = 'overlap'\nhit =", "a.toml:41:9",
     "the elements of mode = 'surface' can only touch; leave out means = 'overlap', or write mode = 'solid'",
     "'overlap'", ""},
    {"hit =", "common = 1\nhit =", "a.toml:40:10", "predicates.touch.common goes with means = 'beyond' alone", "1", ""},
    {"hit =", "means = 'beyond'\ncommon = 0\nhit =", "a.toml:41:10",
     "predicates.touch.common must be a whole number from 1 to 16", "0", ""},
    {of, "of  = ['S: segment', 'T: segment']\nmeans = 'beyond'\ncommon = 3", "a.toml:41:10",
     "3 common points, but the hull of S, of kind segment, has 2; write at most that many", "3", ""},
    {"hit =", "reject = 'S.r > 0'\nhit =", "a.toml:40:10", "predicates.touch.reject must be an array", "'S.r > 0'", ""},
    {"position = true", "position = 'yes'", "a.toml:14:12", "kinds.point.position must be true or false", "'yes'", ""},
    {"parts.ends =", "position = true\nparts.ends =", "a.toml:24:8",
     "a kind with 'position' stores only reals, one for each spatial axis", "segment", ""},
    {"[e1, e2, e3]", "[e1, e2]", "a.toml:12:8",
     "kind 'point' stores 3 coordinates, but 'axes' has 2: a kind with 'position' has one for each spatial axis",
     "point", ""},
    {"axes = '[e1, e2, e3]'\n\n[kinds.point]",
     "\n[kinds.flat]\nstore = ['x: real', 'y: real']\nposition = true\nblade = 'x*e1 + y*e2'\n[kinds.point]",
     "a.toml:15:8", "kind 'point' stores 3 coordinates, but 'flat' has 2: a kind with 'position' has one for each",
     "point", ""},
    {"[kinds.segment]", "[kinds]\nsegment = 3\n[other]", "a.toml:26:2", "an algebra has no 'other'", "other", ""},
    {vectors, "", "a.toml:1:1", "algebra needs 'vectors'", "[algebra]", ""},
    {"where = 'grade", "orders = 3\nwhere = 'grade", "a.toml:36:10", "functions.meet.orders must be a string", "3", ""},
    {"where = 'grade", "orders = 'touches'\nwhere = 'grade", "a.toml:36:10",
     "no predicate 'touches'; predicates: touch; did you mean 'touch'?", "'touches'", ""},
    {"'(B*B)[1]'", "{is = '(B*B)[1]', orders = 'touch'}", "a.toml:31:41",
     "'norm2' orders touch and needs two arguments: an element, and a pair of those that it meets", "'touch'", ""},
    {"hit =", "contacts = 3\nhit =", "a.toml:40:12", "predicates.touch.contacts must be a string", "3", ""},
    {"hit =", "contacts = 'sides'\nhit =", "a.toml:40:12",
     "no function 'sides'; functions: norm2, side, meet; did you mean 'side'?", "'sides'", ""},
    {"hit =", "contacts = 'norm2'\nhit =", "a.toml:40:12",
     "'norm2' tells the contacts of touch and needs two arguments: an operand, and a point", "'norm2'", ""},
};

const broken names[] = {
    {"'r: real']", "'e1: real']", "a.toml:18:22",
     "'e1' would hide the vector of that name, declared at a.toml:1:1; choose another name", "'e1: real'", ""},
    {"'r: real']", "'n: real']", "a.toml:18:22",
     "'n' would hide the vector of that name, declared at a.toml:8:1; choose another name", "'n: real'", ""},
    {"hull  = '[c]'", "from.two.of = ['eb: real']\nfrom.two.blade = 'eb*e1'\nhull  = '[c]'", "a.toml:21:16",
     "'eb' would hide the vector of that name", "'eb: real'", ""},
    {"[kinds.segment]", "[kinds.sphere]", "a.toml:24:1", "[kinds.sphere] is given twice", "[kinds.sphere]", ""},
    {"[kinds.segment]", "[kinds.n]", "a.toml:24:8", "kind 'n' is already declared at a.toml:8:1", "n", ""},
    {"[kinds.segment]", "[kinds.e1]", "a.toml:24:8", "kind 'e1' is already declared at a.toml:1:1", "e1", ""},
    {"[functions]\n", "[functions]\n'norm2(A)' = 'A'\n", "a.toml:32:1",
     "function 'norm2' is already declared at a.toml:31:1", "'norm2(B)'", ""},
    {"[predicates.touch]", "[predicates.meet]", "a.toml:38:13", "predicate 'meet' is already declared at a.toml:34:12",
     "meet", ""},
    {"nb   = 'e - eb'", "nb   = 'e - eb'\nsphere = 'e'", "a.toml:18:8", "kind 'sphere' is already declared", "sphere",
     ""},
    {"n    = 'e + eb'", "n    = 'e + eb'\nn    = 'e'", "a.toml:9:1", "n is given twice", "n", ""},
    {"'e3', 'e',", "'e3', 'e3',", "a.toml:2:11", "vector 'e3' is given twice", "['e1', 'e2', 'e3', 'e3', 'eb']", ""},
    {"'z: real'", "'x: real'", "a.toml:13:35", "'x' is given twice", "'x: real'", ""},
    {of, "of  = ['S: sphere', 'S: sphere']", "a.toml:39:21", "'S' is given twice", "'S: sphere'", ""},
    {"hit =", "let.S = 'T.r'\nhit =", "a.toml:40:5", "'S' is given twice", "S", ""},
    {"parts.ends =", "parts.p =", "a.toml:28:7", "'p' is stored already", "p", ""},
    {"'r: real'", "'r real'", "a.toml:18:22", "expected 'name: type', as in 'x: real'", "'r real'", ""},
    {"'r: real'", "'2r: real'", "a.toml:18:22", "'2r' is not a name for a stored number", "'2r: real'", ""},
    {"'r: real'", "'r: number'", "a.toml:18:22", "no kind 'number'; kinds: point, sphere, segment", "'r: number'", ""},
    {"store = ['c: point', 'r: real']", "store = []", "a.toml:18:9", "kinds.sphere.store is empty", "[]", ""},
    {of, "of  = ['S: sphere']", "a.toml:39:7", "predicates.touch.of names two operands", "['S: sphere']", ""},
    {of, "of  = ['S: sphere', 'T: sphere', 'U: sphere']", "a.toml:39:7", "names two operands",
     "['S: sphere', 'T: sphere', 'U: sphere']", ""},
    {"'side(H, p)'", "'side'", "a.toml:32:1", "a function's key is its name and parameters, as in 'meet(X, Y)'",
     "'side'", ""},
    {"'side(H, p)'", "'side(H, H)'", "a.toml:32:1", "parameter 'H' is given twice", "'side(H, H)'", ""},
    {"'side(H, p)'", "'side(H, )'", "a.toml:32:1", "'' is not a name for a parameter", "'side(H, )'", ""},
    {"'side(H, p)'", "'sign(H)'", "a.toml:32:1", "'sign' is a keyword of the language", "'sign(H)'", ""},
    {"'e1', 'e2'", "'e1', 'e 2'", "a.toml:2:11", "'e 2' is not a name for a basis vector",
     "['e1', 'e 2', 'e3', 'e', 'eb']", ""},
};

const broken circles[] = {
    {"'c: point', 'r: real'", "'c: sphere', 'r: real'", "a.toml:17:8", "kind 'sphere' contains itself", "sphere", ""},
    {"'x: real', 'y: real', 'z: real'", "'x: segment'", "a.toml:12:8", "kind 'point' contains itself", "point", ""},
    {"'e + eb'", "'n + eb'", "a.toml:8:1", "constant 'n' is defined by itself", "n", ""},
    {"'e + eb'", "'e - k'\nk    = 'n'", "a.toml:8:1", "constant 'n' is defined by itself", "n", ""},
    {"'sign(meet(H, p))'", "'other(H, p)'\n'other(H, p)' = 'side(H, p)'", "a.toml:33:18",
     "'side' calls itself; there is no recursion", "side(H, p)", ""},
    {"'(B*B)[1]'", "'norm2(B)'", "a.toml:31:15", "'norm2' calls itself", "norm2(B)", ""},
    {"'sign(norm2(meet(S, T))) >= 0'", "'touch(T, S)'", "a.toml:40:8", "'touch' calls itself", "touch(T, S)", ""},
    {"hit =", "reject = ['touch(T, S)']\nhit =", "a.toml:40:12", "'touch' calls itself", "touch(T, S)", ""},
};

const broken metrics[] = {
    {squares, "squares = [1, 1, 1, 1]", "a.toml:3:11", "4 squares for 5 vectors", "[1, 1, 1, 1]", ""},
    {squares, "squares = [1, 1, 1, 1, 0.5]", "a.toml:3:24", "a metric's entry is a whole number or a 'p/q' string",
     "0.5", ""},
    {squares, "squares = [1, 1, 1, 1, '1/0']", "a.toml:3:24", "a whole number or a 'p/q' string", "'1/0'", ""},
    {squares, "squares = [1, 1, 1, 1, 'one']", "a.toml:3:24", "a whole number or a 'p/q' string", "'one'", ""},
    {squares, "squares = 1", "a.toml:3:11", "algebra.squares must be an array", "1", ""},
    {squares, "metric = [[1, 0], [0, 1]]", "a.toml:3:10", "2 rows for 5 vectors", "[[1, 0], [0, 1]]", ""},
    {squares, "metric = [[1,0,0,0,0],[0,1,0,0,0],[0,0,1,0],[0,0,0,1,0],[0,0,0,0,-1]]", "a.toml:3:35",
     "4 entries for 5 vectors", "[0,0,1,0]", ""},
    {squares, "metric = [[1,0,0,0,0],[0,1,0,0,0],[0,0,1,0,0],[0,0,0,1,2],[0,0,0,0,-1]]", "a.toml:3:10",
     "the metric is not symmetric at row 5, column 4", "[[1,0,0,0,0],[0,1,0,0,0],[0,0,1,0,0],[0,0,0,1,2],[0,0,0,0,-1]]",
     ""},
    {squares, "", "a.toml:1:1", "algebra needs either 'squares' or 'metric'", "[algebra]", ""},
    {squares, "squares = [1, 1, 1, 1, -1]\nmetric = []", "a.toml:1:1", "either 'squares' or 'metric'", "[algebra]", ""},
    {vectors, "vectors = []", "a.toml:2:11", "an algebra has 1 to 8 basis vectors, not 0", "[]", ""},
    {vectors, "vectors = ['a', 'b', 'c', 'd', 'f', 'g', 'h', 'i', 'j']", "a.toml:2:11",
     "an algebra has 1 to 8 basis vectors, not 9", "['a', 'b', 'c', 'd', 'f', 'g', 'h', 'i', 'j']", ""},
    {null, "null    = ['n', 'no']", "a.toml:4:17", "null vector 'no' is not a constant", "'no'", ""},
    {null, "null    = ['n', 'n']", "a.toml:4:12", "the null vectors and the vectors that they leave are not a basis",
     "'n'", ""},
    {null, "null    = ['n']", "a.toml:4:12", "are not a basis", "'n'", ""},
    {"'e - eb'", "'2*e + 2*eb'", "a.toml:4:12", "are not a basis", "'n'", ""},
    {"'e - eb'", "'e - e'", "a.toml:4:12", "are not a basis", "'n'", ""},
    {"'e - eb'", "'e ^ eb'", "a.toml:4:17", "null vector 'nb' is not a vector", "'nb'", ""},
    {"'e - eb'", "'3'", "a.toml:4:17", "null vector 'nb' is not a vector", "'nb'", ""},
    {"'e - eb'", "'[e]'", "a.toml:4:18", "a list where a number or a multivector is needed", "nb", ""},
};

const broken bounds[] = {
    {"hull  = '[c]'", "hull  = '[r]'", "a.toml:21:10", "a hull is a list of points, as in '[p, q]'", "[r]", ""},
    {"hull  = '[c]'", "hull  = 'c'", "a.toml:21:10", "a hull is a list of points", "c", ""},
    {"pad   = 'r'", "pad   = 'r*r'", "a.toml:22:10", "a pad must be a stored number", "r*r", ""},
    {"where = 'r >= 0'", "where = 'r*r >= 0'", "a.toml:20:10", "what a rule compares must be a stored number", "r*r",
     ""},
    {"where = 'r >= 0'", "where = 'r >= 1'", "a.toml:20:10", "compares a stored number with 0, as in 'r >= 0'",
     "r >= 1", ""},
    {"where = 'r >= 0'", "where = 'c != r'", "a.toml:20:10", "or two points, as in 'p != q'", "c != r", ""},
    {"where = 'r >= 0'", "where = 'r'", "a.toml:20:10", "compares a stored number with 0", "r", ""},
};
} // namespace

TEST_CASE("unknown keys, and missing ones") {
  check_broken(keys);
}
TEST_CASE("duplicate names, and strings that are not names") {
  check_broken(names);
}
TEST_CASE("definitions that refer to themselves") {
  check_broken(circles);
}
TEST_CASE("metrics and null vectors") {
  check_broken(metrics);
}
TEST_CASE("hulls, pads and rules") {
  check_broken(bounds);
}

TEST_CASE("equal fractions make a symmetric metric") {
  const char *const metric = "metric = [[1,'1/2',0,0,0],['2/4',1,0,0,0],[0,0,1,0,0],[0,0,0,1,'-0'],[0,0,0,0,'-7/7']]";
  const temporary_folder folder;
  folder.write("a.toml", edited(small_algebra, squares, metric));
  folder.write("s.toml", small_scene("'norm2(meet(sphere, sphere))'"));
  CHECK(run_meetc("verify s.toml --cases 40", folder.path()).code == 0);
}
