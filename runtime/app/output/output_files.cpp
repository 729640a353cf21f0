#include "meet/app/output/output_files.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/io/files/atomic_file.hpp"

#include <cerrno>
#include <fmt/format.h>

#include <string>
#include <system_error>
#include <unistd.h>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

// Whether both names lead to one file, through links as well. Names of files that do not exist are compared as paths.
bool same_file(const fs::path &x, const fs::path &y) {
  std::error_code code;
  if (fs::exists(x, code) && fs::exists(y, code))
    return fs::equivalent(x, y, code);
  return fs::weakly_canonical(fs::absolute(x, code), code) == fs::weakly_canonical(fs::absolute(y, code), code);
}

bool special(const fs::path &target) {
  std::error_code code;
  const fs::file_status s = fs::status(target, code);
  return fs::exists(s) && !fs::is_regular_file(s) && !fs::is_directory(s);
}

std::string replace_all(std::string text, const std::string &from, const std::string &to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// Files can be created in the folder or, if it is missing, in its nearest existing ancestor.
void check_folder(const fs::path &folder) {
  fs::path at = folder.empty() ? fs::path(".") : folder;
  std::error_code code;
  while (!fs::exists(at, code) && at.has_relative_path())
    at = at.has_parent_path() ? at.parent_path() : fs::path(".");
  if (!fs::is_directory(at, code))
    throw failure(fmt::format("{}: is not a folder", at.string()));
  if (::access(at.c_str(), W_OK | X_OK) != 0)
    throw failure(fmt::format("{}: cannot be written: {}", at.string(), std::generic_category().message(errno)));
}

} // namespace

output_files::~output_files() {
  std::error_code ignored;
  for (const staged &s : staged_)
    fs::remove(s.at, ignored);
  for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder)
    ::rmdir(folder->c_str()); // succeeds only if it is still empty
}

void output_files::expect(const fs::path &target, bool makes_folder) {
  if (target.filename().empty())
    throw failure(fmt::format("'{}': is not the name of a file to write", target.string()));
  for (const fs::path &input : inputs_)
    if (same_file(input, target))
      throw failure(
          fmt::format("{}: is an input and would be overwritten; choose another name for the output", target.string()));
  if (special(target))
    return;
  for (const fs::path &other : expected_)
    if (same_file(other, target))
      throw failure(fmt::format("{}: two outputs have the same name", target.string()));
  expected_.push_back(target);
  std::error_code code;
  if (makes_folder && !fs::is_directory(target.parent_path(), code))
    check_folder(target.parent_path());
  else
    const io::atomic_file probe(target); // leaves no trace
}

void output_files::make_folder(const fs::path &folder) {
  std::error_code code;
  if (folder.empty() || fs::is_directory(folder, code))
    return;
  if (folder.has_parent_path() && folder.parent_path() != folder)
    make_folder(folder.parent_path());
  if (!fs::create_directory(folder, code) && !fs::is_directory(folder))
    throw failure(fmt::format("{}: cannot be made: {}", folder.string(), code.message()));
  folders_.push_back(folder);
}

void output_files::write(const fs::path &target, const writer &write) {
  if (special(target)) {
    direct_.emplace_back([target, write] { write(target); });
    return;
  }
  std::error_code code;
  const fs::path real = fs::is_symlink(target, code) ? fs::weakly_canonical(target, code) : target;
  staged s{real.parent_path() / fmt::format(".meet-{}-{}.part", ::getpid(), staged_.size()), real};
  staged_.push_back(s);
  try {
    write(s.at);
  } catch (const io::error &e) {
    throw failure(replace_all(e.what(), s.at.string(), target.string()));
  }
  if (const fs::file_status old = fs::status(real, code); fs::exists(old))
    fs::permissions(s.at, old.permissions(), code); // a replaced file keeps its mode
}

void output_files::commit() {
  for (const auto &write : direct_)
    write();
  direct_.clear();
  for (const staged &s : staged_) {
    std::error_code code;
    fs::rename(s.at, s.target, code);
    if (code)
      throw failure(fmt::format("{}: cannot be written: {}", s.target.string(), code.message()));
  }
  staged_.clear();
  folders_.clear();
}

} // namespace meetc::app
