// Names of commands and options that `meetc` does not know.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

using namespace meetc::compiler_test;

TEST_CASE("a misspelt command or option names the nearest one") {
  const temporary_folder folder;
  const struct {
    const char *arguments, *what;
  } cases[] = {
      {"genrate a.toml -o x", "meetc: unknown command 'genrate'; did you mean 'generate'? (see meetc --help)\n"},
      {"generate a.toml -o x --chekc", "meetc: unknown option '--chekc'; did you mean '--check'? (see meetc --help)\n"},
      {"verify --hlep", "meetc: unknown option '--hlep'; did you mean '--help'? (see meetc --help)\n"},
      {"--verion", "meetc: unknown option '--verion'; did you mean '--version'? (see meetc --help)\n"},
      {"show a.toml --emmit=cpp", "meetc: unknown option '--emmit=cpp'; did you mean '--emit'? (see meetc --help)\n"},
      {"frobnicate", "meetc: unknown command 'frobnicate' (see meetc --help)\n"}};
  for (const auto &[arguments, what] : cases) {
    const outcome o = run_meetc(arguments, folder.path());
    INFO(arguments);
    CHECK(o.code == 2);
    CHECK(o.err == what);
    CHECK(o.out.empty());
  }
}
