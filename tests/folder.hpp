// A folder for a test's files, which goes with the process.
#ifndef MEETC_TESTS_FOLDER_HPP
#define MEETC_TESTS_FOLDER_HPP

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <unistd.h>

namespace test_files {

namespace fs = std::filesystem;

inline const fs::path &folder() {
  struct guard {
    fs::path path = fs::temp_directory_path() / ("meet-test-" + std::to_string(::getpid()));
    guard() { fs::create_directories(path); }
    ~guard() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  };
  static const guard g;
  return g.path;
}

inline fs::path put(const std::string &name, std::string_view content) {
  const fs::path path = folder() / name;
  std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
  return path;
}

inline std::string get(const fs::path &path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace test_files

#endif
