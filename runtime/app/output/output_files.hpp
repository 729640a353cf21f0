// app/output/output_files.hpp: several files that are written together or not at all.
//
// Problem: a command may write a table, two meshes and a picture. If the last cannot be written, the first must not
// look as if all were well. A mistyped name must not cost a long computation, nor an input file.
// Method: names are checked before the work. Files are then written next to their targets under temporary names, and
// renamed when all are complete.
// Limits: a target that exists and is not a regular file (a terminal, a pipe) is written directly, after all others are
// ready. If a rename fails, the files renamed before it stay.
#ifndef MEETC_APP_OUTPUT_OUTPUT_FILES_HPP
#define MEETC_APP_OUTPUT_OUTPUT_FILES_HPP

#include "meet/io/files/error.hpp"

#include <filesystem>
#include <functional>
#include <vector>

namespace meetc::app {

class output_files {
public:
  using writer = std::function<void(const std::filesystem::path &to)>;

  // No output may be one of `inputs`.
  explicit output_files(std::vector<std::filesystem::path> inputs = {}) : inputs_(std::move(inputs)) {}
  ~output_files();
  output_files(const output_files &) = delete;
  output_files &operator=(const output_files &) = delete;

  // Throws io::error for a name that is refused or that cannot be written. `makes_folder` says that make_folder() will
  // be called for a folder that is missing.
  void expect(const std::filesystem::path &target, bool makes_folder = false);
  // Creates the folder and its missing ancestors.
  void make_folder(const std::filesystem::path &folder);
  // Calls `write` with the name to write to. Throws io::error that names the target.
  void write(const std::filesystem::path &target, const writer &write);
  void commit();

private:
  struct staged {
    std::filesystem::path at, target;
  };
  std::vector<std::filesystem::path> inputs_, expected_, folders_;
  std::vector<staged> staged_;
  std::vector<std::function<void()>> direct_;
};

} // namespace meetc::app

#endif
