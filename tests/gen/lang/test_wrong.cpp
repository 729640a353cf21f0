// Wrong specs as new users write them, through the program: each row of wrong/*.toml replaces a piece of the small algebra
// (`from`, `to`), asks for `kernels`, or is another `scene`; and says at which place which message stands, and above which
// text its caret.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

using namespace meetc::compiler_test;

namespace {

toml::table read_rows(const std::string &theme) {
  return toml::parse_file((source_folder() / "tests/gen/lang/wrong" / (theme + ".toml")).string());
}

std::string text(const toml::table &row, const char *key, const char *unless_said = "") {
  return row[key].value_or(std::string(unless_said));
}

void check_rows(const std::string &theme) {
  const toml::table all = read_rows(theme);
  const toml::array &rows = *all["wrong"].as_array();
  REQUIRE_FALSE(rows.empty());
  for (const toml::node &node : rows) {
    const toml::table &row = *node.as_table();
    const std::string from = text(row, "from"), kernels = text(row, "kernels", broken{}.kernels);
    INFO(theme << ": '" << from << "' to '" << text(row, "to") << "', kernels " << kernels << text(row, "scene"));
    const temporary_folder folder;
    folder.write("a.toml", from.empty() ? small_algebra : edited(small_algebra, from, text(row, "to")));
    folder.write("s.toml", row.contains("scene") ? text(row, "scene") : small_scene(kernels));
    const std::string place = text(row, "place"), message = text(row, "message"), marked = text(row, "marked");
    REQUIRE_FALSE(place.empty());
    REQUIRE_FALSE(message.empty());
    check_error(folder, "s.toml", {"", "", place.c_str(), message.c_str(), marked.c_str(), ""});
  }
}

} // namespace

TEST_CASE("wrong specs: names") {
  check_rows("names");
}
TEST_CASE("wrong specs: numbers of arguments") {
  check_rows("arity");
}
TEST_CASE("wrong specs: grades and products") {
  check_rows("grades");
}
TEST_CASE("wrong specs: syntax") {
  check_rows("syntax");
}
TEST_CASE("wrong specs: types of TOML") {
  check_rows("types");
}
TEST_CASE("wrong specs: what is there twice") {
  check_rows("twice");
}
TEST_CASE("wrong specs: signs") {
  check_rows("signs");
}
TEST_CASE("wrong specs: relations, and what is read back") {
  check_rows("relations");
}
TEST_CASE("wrong specs: the order of blades") {
  check_rows("order");
}
TEST_CASE("wrong specs: scenes") {
  check_rows("scene");
}

TEST_CASE("a corpus of at least 150 wrong specs") {
  std::size_t rows = 0;
  for (const auto &file : fs::directory_iterator(source_folder() / "tests/gen/lang/wrong"))
    rows += read_rows(file.path().stem().string())["wrong"].as_array()->size();
  CHECK(rows >= 150);
}
