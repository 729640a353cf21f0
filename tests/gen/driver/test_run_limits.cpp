// --limit-seconds and --limit-megabytes: one line, exit code 2, nothing written.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc::compiler_test;

namespace {

const std::string scenes = (source_folder() / "algebra_spec/scenes").string();

void check_stopped(const std::string &arguments, const std::string &message) {
  INFO(arguments);
  const temporary_folder folder;
  const outcome o = run_meetc(arguments, folder.path());
  CHECK(o.code == 2);
  CHECK(o.err == "error: " + message + '\n');
  CHECK(fs::is_empty(folder.path()));
}

} // namespace

TEST_CASE("a run ends at its limit of time") {
  const std::string too_long = "this takes longer than 0.2 seconds, the --limit-seconds";
  check_stopped(fmt::format("verify {}/default.toml --cases 100000000 --limit-seconds 0.2", scenes), too_long);
  check_stopped(fmt::format("compare {0}/default.toml {0}/general.toml --limit-seconds 0.2", scenes), too_long);
}

TEST_CASE("a run ends at its limit of memory, and writes nothing") {
  // A process of this size ends at its first look.
  for (const char *command : {"generate {}/general.toml -o out", "show {}/general.toml --emit=counts",
                              "verify {}/general.toml", "compare {}/general.toml"})
    check_stopped(fmt::format(fmt::runtime(command), scenes) + " --limit-megabytes 1",
                  "this takes more memory than 1 megabytes, the --limit-megabytes");
}

TEST_CASE("limits that are wide enough change nothing") {
  const temporary_folder folder;
  folder.write("a.toml", small_algebra);
  folder.write("s.toml", small_scene("'touch'"));
  const outcome o = run_meetc("generate s.toml -o out --limit-seconds 600 --limit-megabytes 100000", folder.path());
  CHECK(o.code == 0);
  CHECK(o.err.empty());
  CHECK(fs::exists(folder.path() / "out"));
  const outcome none = run_meetc("eval s.toml -e 1 --limit-seconds 0", folder.path());
  CHECK(none.code == 2);
  CHECK_THAT(none.err, contains("--limit-seconds"));
}

TEST_CASE("a limit or a folder that is none is refused") {
  const temporary_folder folder;
  for (const char *const seconds : {"nan", "inf", "0", "-1"}) {
    const outcome o = run_meetc(fmt::format("show s.toml --limit-seconds {}", seconds), folder.path());
    INFO(seconds << ": " << o.err);
    CHECK(o.code == 2);
    CHECK_THAT(o.err, contains("--limit-seconds"));
  }
  CHECK_THAT(run_meetc("generate s.toml -o ''", folder.path()).err, contains("--out: its name is empty"));
}
