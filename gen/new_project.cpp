// The command that writes a first project: an algebra, a scene, and a program in CMake that uses what is generated.
#include "gen/driver.hpp"
#include "gen/support/output.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace meetc {
namespace {

namespace fs = std::filesystem;

struct project_file {
  const char *name, *text;
};

constexpr std::array files{
    project_file{"first.toml", R"toml(# first.toml: the geometry of space with planes as vectors, R(3,0,1).
[algebra]
spec    = 1
vectors = ['e0', 'e1', 'e2', 'e3']
squares = [0, 1, 1, 1]

[kinds.point]                            # what is stored, and the blade that it stands for
store    = ['x: real', 'y: real', 'z: real']
position = true
blade    = 'e123 - x*e023 - y*e031 - z*e012'

[kinds.plane]                            # the points with a x + b y + c z + d = 0
store = ['a: real', 'b: real', 'c: real', 'd: real']
blade = 'a*e1 + b*e2 + c*e3 + d*e0'

[kinds.line]                             # its direction and its moment
store = ['a: real', 'b: real', 'c: real', 'd: real', 'e: real', 'f: real']
blade = 'a*e23 + b*e31 + c*e12 + d*e01 + e*e02 + f*e03'

[kinds.motor]                            # a rotation and a translation, as a product of two or four planes
store = ['s: real', 'a: real', 'b: real', 'c: real', 'd: real', 'e: real', 'f: real', 'p: real']
blade = 's + a*e23 + b*e31 + c*e12 + d*e01 + e*e02 + f*e03 + p*e0123'

[functions]
'join(X, Y)' = 'X & Y'                   # the line through two points, the plane through a line and a point
'meet(X, Y)' = 'X ^ Y'                   # the line in two planes, the point on a line and a plane
'move(M, X)' = 'sandwich(M, X)'          # M X ~M
)toml"},
    project_file{"scene.toml", R"toml(# scene.toml: what the program wants of the algebra. Nothing else is generated.
[scene]
spec      = 1
algebra   = 'first.toml'
namespace = 'first'
kernels   = ['join(point, point)', 'meet(line, plane)', 'move(motor, point)', 'motor*motor']
backends  = ['cpp']
)toml"},
    project_file{"CMakeLists.txt", R"cmake(cmake_minimum_required(VERSION 3.25)
project(first LANGUAGES CXX)
find_package(meetc REQUIRED CONFIG COMPONENTS generator)

meetc_add_kernels(first_kernels SCENE scene.toml NAMESPACE first)
add_executable(first main.cpp)
target_link_libraries(first PRIVATE first_kernels)
)cmake"},
    project_file{"main.cpp", R"cpp(// Joins two points, turns the line's foot on a plane by a quarter, and prints it.
#include <first/first.hpp>

#include <cstdio>

int main() {
  const first::point<double> a{1, 2, 0}, b{1, 2, 5};
  const first::plane<double> ground{0, 0, 1, -3}; // z = 3
  const auto line = first::join(a, b);
  const auto foot = first::meet(line, blade(ground));

  // A quarter turn about the z axis: s + c e12 with s = cos 45°, c = -sin 45°. The movement is scaled by s*s + c*c.
  const first::motor<double> turn{1, 0, 0, -1, 0, 0, 0, 0};
  const auto moved = first::move(blade(turn), foot);
  const double w = moved.e1_e2_e3;
  std::printf("%g %g %g\n", -moved.e0_e2_e3 / w, moved.e0_e1_e3 / w, -moved.e0_e1_e2 / w);
  return 0;
}
)cpp"},
};

} // namespace

int new_project(const std::string &folder) {
  std::error_code error;
  const fs::path to = folder;
  if (fs::exists(to, error) && (!fs::is_directory(to, error) || !fs::is_empty(to, error)))
    throw spec_error({}, fmt::format("{}: is there already, and not an empty folder", folder));
  const bool was_there = fs::exists(to, error);
  fs::create_directories(to, error);
  for (const project_file &f : files) {
    std::ofstream out(to / f.name, std::ios::binary);
    out << f.text;
    out.close();
    if (out)
      continue;
    for (const project_file &written : files)
      fs::remove(to / written.name, error);
    if (!was_there)
      fs::remove(to, error);
    throw spec_error({}, fmt::format("{}: cannot be written", (to / f.name).generic_string()));
  }
  say(fmt::format("wrote first.toml, scene.toml, CMakeLists.txt and main.cpp to {0}\n"
                  "  meetc show {0}/scene.toml\n"
                  "  meetc eval {0}/scene.toml -e 'A & B' --with 'A: point = 1,2,0; B: point = 1,2,5'\n"
                  "  meetc verify {0}/scene.toml\n"
                  "  cmake -S {0} -B {0}/build && cmake --build {0}/build && {0}/build/first\n",
                  to.generic_string()));
  return 0;
}

} // namespace meetc
