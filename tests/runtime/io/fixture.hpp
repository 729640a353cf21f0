// Shared by the tests of meetc::io: kinds of element, a separate folder, and checks of messages.
#ifndef MEETC_TESTS_IO_FIXTURE_HPP
#define MEETC_TESTS_IO_FIXTURE_HPP

#include "tests/catch.hpp"
#include "tests/folder.hpp"

#include "meet/io/files/endian.hpp"
#include "meet/io/read.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace fixture {

using meetc::test::contains;

using meetc::role;
namespace fs = std::filesystem;

inline constexpr role xyz[] = {role::x, role::y, role::z, role::x, role::y, role::z, role::x, role::y, role::z};
inline constexpr role ball[] = {role::x, role::y, role::z, role::length};
inline constexpr role plane[] = {role::other, role::other, role::other, role::other};

inline const char *negative_radius(const float *row) {
  return row[3] < 0 ? "r < 0" : nullptr;
}

inline constexpr meetc::kind_info triangle{"triangle", "x0,y0,z0,x1,y1,z1,x2,y2,z2", 9, xyz, 3, nullptr, nullptr};
inline constexpr meetc::kind_info segment{"segment", "x0,y0,z0,x1,y1,z1", 6, xyz, 2, nullptr, nullptr};
inline constexpr meetc::kind_info point{"point", "x,y,z", 3, xyz, 1, nullptr, nullptr};
inline constexpr meetc::kind_info sphere{"sphere", "x,y,z,r", 4, ball, 0, nullptr, negative_radius};
inline constexpr meetc::kind_info half_space{"half_space", "nx,ny,nz,d", 4, plane, 0, nullptr, nullptr};
inline constexpr const meetc::kind_info *kinds[] = {&triangle, &segment, &point, &sphere, &half_space};

using test_files::folder, test_files::get, test_files::put;

inline meetc::io::element_set read(const std::string &name, std::string_view content,
                                   const meetc::io::read_options &how = {}) {
  return meetc::io::read(put(name, content), kinds, how);
}
inline meetc::io::element_set read(const std::string &name, std::string_view content,
                                   const meetc::io::transform &move) {
  return read(name, content, meetc::io::read_options{move});
}

// The message of the reader for a bad file, without the folder. The test fails where there is none.
inline std::string complaint(const std::string &name, std::string_view content,
                             const meetc::io::read_options &how = {}) {
  try {
    read(name, content, how);
  } catch (const meetc::io::error &e) {
    const std::string what = e.what(), prefix = folder().string() + "/";
    CHECK(what.find('\n') == std::string::npos);
    REQUIRE(what.rfind(prefix, 0) == 0);
    return what.substr(prefix.size());
  }
  FAIL("accepted: " << name);
  return {};
}

inline std::string complaint(const std::string &name, std::string_view content, const meetc::io::transform &move) {
  return complaint(name, content, meetc::io::read_options{move});
}

template <class T> void append(std::string &out, T value, std::endian order = std::endian::little) {
  const auto bytes = meetc::io::store(value, order);
  out.append(bytes.data(), bytes.size());
}

inline int files_in(const fs::path &path) {
  return static_cast<int>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
}

} // namespace fixture

#endif
