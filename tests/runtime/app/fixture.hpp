// Shared by the tests of `meet`: a separate folder, and the program run as a user runs it, with its output.
#ifndef MEETC_TESTS_APP_FIXTURE_HPP
#define MEETC_TESTS_APP_FIXTURE_HPP

#include "tests/catch.hpp"
#include "tests/folder.hpp"

#include "meet/bodies/meshes.hpp"
#include "meet/io/write.hpp"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace fixture {

namespace fs = std::filesystem;
using nlohmann::json;

using test_files::folder, test_files::get;

inline std::string at(const std::string &name) {
  return (folder() / name).string();
}

inline std::string put(const std::string &name, std::string_view content) {
  return test_files::put(name, content).string();
}

inline std::string put_mesh(const std::string &name, const meetc::bodies::mesh &m) {
  meetc::io::write_ply(folder() / name, m.xyz, m.index);
  return at(name);
}

struct said {
  int code; // of exit; -1: a signal
  std::string out, err;
};

// Runs the program through the shell, in the tests' folder, with each argument passed unchanged. `around` may redirect.
inline said run_program(const fs::path &program, const std::vector<std::string> &arguments,
                        const std::string &around = "") {
  std::string words;
  for (const std::string &a : arguments)
    words += fmt::format(" '{}'", a);
  const std::string out = at("stdout.txt"), err = at("stderr.txt");
  fs::remove(out);
  const std::string command =
      fmt::format("cd '{}' && '{}'{} >'{}' 2>'{}' {}", folder().string(), program.string(), words, out, err, around);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, get(out), get(err)};
}
inline said run(const std::vector<std::string> &arguments, const std::string &around = "") {
  return run_program(MEETC_MEET, arguments, around);
}

// A run that must succeed. Returns its JSON, which is all that it prints.
inline json answer(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "collide");
  arguments.emplace_back("--json");
  const said s = run(arguments);
  INFO(s.err);
  REQUIRE(s.code == 0);
  CHECK(s.err.empty());
  return json::parse(s.out);
}

// The rows of a table in the JSON of a command that measures.
inline const json &table(const json &all, std::string_view name) {
  for (const json &t : all["tables"])
    if (t["name"] == name)
      return t["rows"];
  throw std::logic_error("no such table");
}

// A run that must fail: checks the exit code and that there is one line. Returns that line without "meet: ".
inline std::string complaint(const std::vector<std::string> &arguments, int code = 2) {
  const said s = run(arguments);
  INFO(s.err);
  CHECK(s.code == code);
  CHECK(s.out.empty());
  REQUIRE(s.err.rfind("meet: ", 0) == 0);
  CHECK(s.err.find('\n') == s.err.size() - 1);
  return s.err.substr(6, s.err.size() - 7);
}

inline bool has(const std::string &text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

using pair_list = std::vector<std::pair<unsigned, unsigned>>;

// The rows of a pairs file, whose header is checked.
inline pair_list pairs_in(const fs::path &path) {
  std::ifstream in(path);
  std::string line;
  REQUIRE(std::getline(in, line));
  CHECK(line == "a,b");
  pair_list out;
  unsigned a = 0, b = 0;
  for (char comma = 0; in >> a >> comma >> b;)
    out.emplace_back(a, b);
  return out;
}

// The pairs of a run that must succeed.
inline pair_list pairs_of(std::vector<std::string> arguments) {
  const json counts = answer(arguments);
  arguments.insert(arguments.end(), {"--pairs", at("pairs.csv")});
  const json j = answer(arguments);
  pair_list p = pairs_in(at("pairs.csv"));
  CHECK(j["pairs"] == p.size());
  for (const char *const count : {"pairs", "touched_a", "touched_b"})
    CHECK(counts[count] == j[count]); // the same where no list is asked for
  CHECK(std::is_sorted(p.begin(), p.end()));
  std::set<unsigned> a, b;
  for (const auto &[i, k] : p) {
    a.insert(i);
    b.insert(k);
  }
  CHECK(j["touched_a"] == a.size());
  CHECK(j["touched_b"] == b.size());
  return p;
}

inline std::size_t files_in(const fs::path &path) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
}

} // namespace fixture

#endif
