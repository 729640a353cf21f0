#include "tests/gen/error_fixture.hpp"
#include "tests/catch.hpp"

#include <fmt/format.h>
#include <sstream>

namespace meetc::compiler_test {

const char *const small_algebra = R"([algebra]
vectors = ['e1', 'e2', 'e3', 'e', 'eb']
squares = [1, 1, 1, 1, -1]
null    = ['n', 'nb']

[constants]
I    = 'e1 ^ e2 ^ e3 ^ e ^ eb'
n    = 'e + eb'
nb   = 'e - eb'
axes = '[e1, e2, e3]'

[kinds.point]
store    = ['x: real', 'y: real', 'z: real']
position = true
blade    = '2*(x*e1 + y*e2 + z*e3) + (x*x + y*y + z*z)*n - nb'

[kinds.sphere]
store = ['c: point', 'r: real']
blade = '-I*(c - r*r*n)'
where = 'r >= 0'
hull  = '[c]'
pad   = 'r'

[kinds.segment]
store = ['p: point', 'q: point']
blade = 'p ^ q ^ n'
hull  = '[p, q]'
parts.ends = '[p, q]'

[functions]
'norm2(B)' = '(B*B)[1]'
'side(H, p)' = 'sign(meet(H, p))'

[functions.'meet(X, Y)']
is    = '(I*X) | Y'
where = 'grade(X) + grade(Y) >= 5'

[predicates.touch]
of  = ['S: sphere', 'T: sphere']
hit = 'sign(norm2(meet(S, T))) >= 0'
)";

std::string edited(std::string text, const std::string &from, const std::string &to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string small_scene(const std::string &kernels) {
  return fmt::format("[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = [{}]\n", kernels);
}

namespace {

std::vector<std::string> lines_of(const std::string &text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    out.push_back(line);
  return out;
}

// The text above the caret and its tildes, character by character.
std::string marked_text(const std::string &source, const std::string &caret) {
  std::vector<std::string> characters;
  for (const char c : source)
    if ((c & 0xc0) == 0x80 && !characters.empty())
      characters.back() += c;
    else
      characters.emplace_back(1, c);
  const std::size_t at = caret.find('^');
  if (at == characters.size() && caret.size() == at + 1)
    return ""; // at the end of the line
  if (at == std::string::npos || caret.size() > characters.size())
    return "(no caret)";
  std::string out;
  for (std::size_t i = at; i < caret.size(); ++i)
    out += characters[i];
  return out;
}

std::size_t files_in(const fs::path &folder) {
  return static_cast<std::size_t>(std::distance(fs::recursive_directory_iterator(folder), {}));
}

} // namespace

void check_error(const temporary_folder &folder, const std::string &scene, const broken &want) {
  const std::size_t before = files_in(folder.path());
  const outcome o = run_meetc(fmt::format("generate {} -o out", scene), folder.path());
  INFO(o.err);
  CHECK(o.code == 2);
  CHECK(o.out.empty());
  CHECK(files_in(folder.path()) == before);
  const std::vector<std::string> lines = lines_of(o.err);
  REQUIRE_FALSE(lines.empty());
  const std::string start = *want.place ? fmt::format("{}: error: ", want.place) : std::string("error: ");
  CHECK(lines[0].substr(0, start.size()) == start);
  CHECK_THAT(lines[0], contains(want.message));
  CHECK_FALSE(lines[0].find("internal") != std::string::npos);
  if (!*want.place) {
    CHECK(lines.size() == 1);
    return;
  }
  REQUIRE(lines.size() >= 3);
  CHECK(marked_text(lines[1], lines[2]) == want.marked);
  if (*want.trail)
    CHECK_THAT(o.err, contains(want.trail));
  for (std::size_t i = 3; i < lines.size(); ++i)
    CHECK(lines[i].substr(0, 5) == "  in ");
}

void check_broken(std::span<const broken> rows) {
  for (const broken &row : rows) {
    INFO("'" << row.from << "' to '" << row.to << "', kernels " << row.kernels);
    const temporary_folder folder;
    folder.write("a.toml", edited(small_algebra, row.from, row.to));
    folder.write("s.toml", small_scene(row.kernels));
    check_error(folder, "s.toml", row);
  }
}

} // namespace meetc::compiler_test
