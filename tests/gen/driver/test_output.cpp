// Standard output that nobody reads, or that cannot be written.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <cstdlib>
#include <fmt/format.h>

using namespace meetc::compiler_test;

namespace {

// Runs `line` in the folder, with stderr in the file err, and the exit code in the file code.
outcome run_line(const temporary_folder &folder, const std::string &line) {
  for (const char *const left : {"gone", "code", "err"})
    fs::remove(folder.path() / left);
  CHECK(std::system(fmt::format("cd '{}' && {}", folder.path().string(), line).c_str()) == 0);
  return {std::stoi(read(folder.path() / "code")), "", read(folder.path() / "err")};
}

// With standard output into a pipe whose reader has gone. `first` is what the shell does before.
outcome run_unread(const temporary_folder &folder, const std::string &arguments, const std::string &first) {
  return run_line(folder,
                  fmt::format("{{ {}; until [ -e gone ]; do sleep 0.01; done; '{}' {} 2>err; echo $? >code; }} | "
                              "{{ exec <&-; : >gone; }}",
                              first, MEETC_PROGRAM, arguments));
}

} // namespace

TEST_CASE("a reader that leaves early is no fault, and a full disk is one") {
  const temporary_folder folder;
  folder.write("a.toml", small_algebra);
  folder.write("s.toml", small_scene("'touch'"));
  // Less than a buffer, which is written at the end; and more than one.
  const std::string little = "show s.toml touch --emit=spec";
  const std::string much = fmt::format("show '{}' segment_segment", default_scene_path().string());
  CHECK(run_meetc(little, folder.path()).out.size() < 4096);
  CHECK(run_meetc(much, folder.path()).out.size() > 4096);
  for (const std::string &arguments : {little, much}) {
    INFO(arguments);
    // As most programs are started, and as one is whose parent ignores the signal.
    for (const char *const first : {":", "trap '' PIPE"}) {
      const outcome o = run_unread(folder, arguments, first);
      CHECK(o.code == 0);
      CHECK(o.err == "");
    }
    const outcome full =
        run_line(folder, fmt::format("{{ '{}' {} >/dev/full 2>err; echo $? >code; }}", MEETC_PROGRAM, arguments));
    CHECK(full.code == 2);
    CHECK_THAT(full.err, contains("error: standard output cannot be written: No space"));
  }
  const outcome o = run_unread(folder, "generate s.toml -o absent --check", ":");
  CHECK(o.code == 1); // what the check found is kept
  CHECK(o.err == "");
}
