// Reading a spec: the order is that of the file where it matters, and nothing else changes the result.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

lang::algebra read_algebra(const std::string &text) {
  const temporary_folder folder;
  const fs::path path = folder.write("a.toml", text);
  lang::algebra a;
  std::vector<std::shared_ptr<const source_file>> files;
  lang::load_algebra(path.string(), a, files);
  return a;
}

// Files without their banners' content hash.
std::map<std::string, std::string> generated_from(const std::string &algebra, bool keep_hash) {
  const temporary_folder folder;
  folder.write("a.toml", algebra);
  compilation c = load(
      folder.write("s.toml", small_scene("'norm2(meet(sphere, sphere))', 'meet(sphere, segment)', 'touch'")).string());
  compile_all(c);
  std::map<std::string, std::string> out;
  for (target::file &f : emit_all(c)) {
    const std::size_t at = f.text.find("(content ");
    if (!keep_hash && at != std::string::npos)
      f.text.erase(at, f.text.find(')', at) - at);
    out[f.path] = std::move(f.text);
  }
  return out;
}

} // namespace

TEST_CASE("kinds, functions, constants and lets keep the order of the file") {
  // The names are not in alphabetical order, since the TOML library sorts its tables.
  const lang::algebra a = read_algebra(R"([algebra]
vectors = ['z', 'y']
squares = [1, '-3/4']
[constants]
w = 'z'
b = 'w + y'
a = 'b'
[kinds.zebra]
store = ['q: real', 'b: real', 'a: real']
blade = 'q*z + b*y'
from.twice.of    = ['x: real']
from.twice.blade = '2*x*z'
from.once.of     = ['x: real']
from.once.blade  = 'x*z'
parts.two = '[q]'
parts.one = '[b]'
[kinds.apple]
store = ['m: zebra', 'c: real']
blade = 'm'
[functions]
'v(x)' = 'x'
'c(y, x)' = 'x*y'
[predicates.p]
of = ['k: zebra', 'j: apple']
let.n = 'k.q'
let.d = 'n*k.b'
reject = ['d > 0', 'n > 0']
hit = 'k.a > 0'
)");
  CHECK(a.kind_names() == std::vector<std::string>{"zebra", "apple"});
  const lang::kind &zebra = *a.find_kind("zebra");
  CHECK((zebra.store[0].name == "q" && zebra.store[1].name == "b" && zebra.store[2].name == "a"));
  CHECK((zebra.from[0].name == "twice" && zebra.from[1].name == "once"));
  CHECK((zebra.parts[0].name == "two" && zebra.parts[1].name == "one"));
  CHECK((a.functions[0].name == "v" && a.functions[1].name == "c"));
  CHECK(a.functions[1].params == std::vector<std::string>{"y", "x"});
  CHECK((a.constants[0].name == "w" && a.constants[1].name == "b" && a.constants[2].name == "a"));
  CHECK((a.predicates[0].lets[0].name == "n" && a.predicates[0].lets[1].name == "d"));
  CHECK(lang::print(*a.predicates[0].reject[1]) == "n > 0");
  CHECK(a.metric[1][1] == "-3/4");
}

TEST_CASE("the shipped kinds come in the order of the file, imports after their importer") {
  const lang::algebra &a = default_scene().model->spec();
  CHECK(a.kind_names() == std::vector<std::string>{"point", "direction", "point_pair", "flat_point", "line", "circle",
                                                   "plane", "sphere", "segment", "triangle", "box", "triangle_pair"});
  std::vector<std::string> files;
  for (const auto &f : default_scene().scene->files)
    files.push_back(fs::path(f->path).filename().string());
  CHECK(files == std::vector<std::string>{"default.toml", "cga3.toml", "box.toml", "words.toml", "flat.toml",
                                          "order.toml", "round.toml"});
}

TEST_CASE("memory order is store order, depth first") {
  const lower::model &m = *default_scene().model;
  const auto paths = [&](const char *kind) {
    std::vector<std::string> out;
    for (const auto &r : m.layout(*m.spec().find_kind(kind)).reals)
      out.push_back(r.path);
    return join(out, " ");
  };
  CHECK(paths("sphere") == "c.x c.y c.z r");
  CHECK(paths("circle") == "c.x c.y c.z N.x N.y N.z r");
  CHECK(paths("triangle") == "a.x a.y a.z b.x b.y b.z c.x c.y c.z");
}

TEST_CASE("comments and blanks change the hash in the banner and nothing else") {
  const std::string base = small_algebra;
  const auto plain = generated_from(base, false), hashed = generated_from(base, true);
  CHECK(plain != hashed);
  CHECK(generated_from(base, true) == hashed);
  const std::string changes[] = {
      "# a comment\n" + base,
      edited(base, "squares = [1, 1, 1, 1, -1]", "squares   =   [ 1,1,1,1 , -1 ]  # ü"),
      edited(base, "[kinds.sphere]", "\n\n\n[ kinds . sphere ]"),
      edited(base, "store = ['c: point', 'r: real']", "store = [\n  'c :  point',\n\n  'r: real',  # radius\n]"),
  };
  for (const std::string &text : changes) {
    CHECK(generated_from(text, false) == plain);
    CHECK(generated_from(text, true) != hashed);
  }
  // The order of entries matters only where it is the order in memory.
  const std::string meaning = edited(base, "r*r*n", "2*r*r*n");
  CHECK(generated_from(meaning, false) != plain);
}

TEST_CASE("every table is strict: an unknown key is an error, and the message names the known ones") {
  const std::string base = small_algebra;
  const std::pair<std::string, std::string> places[] = {
      {"[algebra]\n", "vectors, squares, metric, null, order, import"},
      {"[kinds.point]\n", "store, blade, grades, from, parts, where, hull, pad, position"},
      {"[functions.'meet(X, Y)']\n", "is, where"},
      {"[predicates.touch]\n", "of, let, reject, hit, mode"},
  };
  for (const auto &[table, known] : places)
    CHECK_THROWS_WITH(read_algebra(edited(base, table, table + "colour = 'red'\n")),
                      contains("'colour'; it may have: " + known));
  CHECK_THROWS_WITH(read_algebra("colour = 'red'\n" + base), contains("an algebra has no 'colour'"));
}

TEST_CASE("the shipped specs are read without complaint") {
  for (const auto &entry : fs::directory_iterator(source_folder() / "algebra_spec" / "scenes")) {
    if (entry.path().extension() != ".toml")
      continue;
    INFO(entry.path());
    compilation c = load(entry.path().string());
    CHECK_NOTHROW(compile_all(c));
    CHECK_FALSE(c.kernels.empty());
  }
}
