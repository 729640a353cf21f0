#include "tests/gen/fuzz/specs/campaign.hpp"

#include "gen/driver.hpp"
#include "gen/support/limits.hpp"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace meetc::fuzz {
namespace {

namespace fs = std::filesystem;

enum end : int { compiled = 0, refused = 2, internal = 3, without_place = 4, past_a_limit = 5 };

int compile_here() {
  try {
    compilation c = load("s.toml");
    compile_all(c);
    emit_all(c);
    return compiled;
  } catch (const spec_error &e) {
    fmt::print(stderr, "{}", e.render());
    return e.where() ? refused : without_place;
  } catch (const std::exception &e) {
    fmt::print(stderr, "error: internal: {}\n", e.what());
    return internal;
  }
}

void write(const fs::path &path, const std::string &text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read(const fs::path &path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

// The status of a process that compiles the spec in the folder; what it says goes to the file `said` there.
int compile_in_process(const fs::path &folder, const spec_plan &p) {
  const pid_t child = ::fork();
  if (child == 0) {
    const int out = ::open((folder / "said").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out < 0 || ::dup2(out, STDOUT_FILENO) < 0 || ::dup2(out, STDERR_FILENO) < 0 || ::chdir(folder.c_str()) != 0)
      ::_exit(internal);
    watch_limits({p.seconds, p.megabytes}, past_a_limit);
    ::_exit(compile_here());
  }
  int status = -1;
  while (child > 0 && ::waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      break;
  return status;
}

const char *what_failed(int status) {
  if (!WIFEXITED(status))
    return "a crash";
  switch (WEXITSTATUS(status)) {
  case compiled:
  case refused:
    return nullptr;
  case internal:
    return "an internal error";
  case without_place:
    return "an error without a place";
  case past_a_limit:
    return "no end within the limits";
  default:
    return "a crash"; // as the sanitizers end
  }
}

} // namespace

spec_tally run_specs(const spec_plan &p) {
  spec_tally out;
  const std::vector<spec_seed> seeds = read_spec_seeds(p.algebra_spec);
  const fs::path folder = fs::temp_directory_path() / fmt::format("fuzz_specs-{}", ::getpid());
  fs::create_directories(folder);
  for (std::uint64_t i = 0; i < p.count; ++i) {
    const drawn_spec s = draw_spec(seeds, p.seed, i);
    write(folder / "a.toml", s.algebra);
    write(folder / "s.toml", s.scene);
    const int status = compile_in_process(folder, p);
    const char *const failed = what_failed(status);
    if (!failed) {
      ++(WEXITSTATUS(status) == compiled ? out.compiled : out.refused);
      continue;
    }
    const std::string said = read(folder / "said");
    out.findings.push_back(
        fmt::format("{} at seed {}, index {}: {}", failed, p.seed, i, said.substr(0, said.find('\n'))));
    if (p.findings.empty())
      continue;
    const fs::path kept = fs::path(p.findings) / fmt::format("{}-{}", p.seed, i);
    fs::create_directories(kept);
    for (const char *name : {"a.toml", "s.toml", "said"})
      fs::copy_file(folder / name, kept / name, fs::copy_options::overwrite_existing);
  }
  fs::remove_all(folder);
  return out;
}

} // namespace meetc::fuzz
