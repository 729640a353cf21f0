#!/usr/bin/env bash
# debian.sh CPACK build=BUILD folder=FOLDER COMPILER: makes the packages of a build, unpacks them and uses them as an install.
set -euo pipefail
cpack=$1 build=${2#build=} folder=${3#folder=} compiler=$4
fail() {
  echo "debian.sh: $*"
  exit 1
}
rm -rf "$folder"
mkdir -p "$folder/root"
"$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$folder/made" >"$folder/cpack.log" 2>&1 || {
  cat "$folder/cpack.log"
  exit 1
}
cd "$folder"
shopt -s nullglob
programs=(made/meetc_*.deb) development=(made/libmeetc-dev_*.deb)
[ ${#programs[@]} -eq 1 ] && [ ${#development[@]} -eq 1 ] || fail "made: $(ls made)"

# No file is in two packages.
twice=$(for package in made/*.deb; do dpkg-deb --fsys-tarfile "$package" | tar -t | grep -v '/$'; done | sort | uniq -d)
[ -z "$twice" ] || fail "files of two packages: $twice"
depends=$(dpkg-deb -f "${programs[0]}" Depends)
[[ $depends == *libfmt* && $depends == *libc6* ]] || fail "meetc depends on: $depends"
[[ $(dpkg-deb -f "${development[0]}" Depends) == *"meetc (= "* ]] || fail "libmeetc-dev does not depend on meetc"
for package in made/*.deb; do dpkg-deb -x "$package" root; done
usr=$PWD/root/usr

"$usr/bin/meet" demo -o demo >demo.log
"$usr/bin/meet" collide demo/animal.ply demo/figure.ply --json >collide.log
grep -q '"pairs":' collide.log || fail "$(cat collide.log)"
"$usr/bin/meetc" new cell >new.log || fail "$(cat new.log)"
[ -s "$usr/share/bash-completion/completions/meet" ] || fail "no completion"
[ -s "$usr/share/doc/meetc/copyright" ] || fail "no licence"

cat >program.cpp <<'CPP'
#include <cga/cga_runtime.hpp>
#include <cstdio>
#include <meet/core/query/collide.hpp>
#include <meet/core/query/find.hpp>

int main() {
  const meetc::predicate_info &p = meetc::find_predicate(cga::catalogue(), "triangle_triangle");
  const float a[] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, b[] = {0, 0, -1, 0, 0, 1, 1, 1, 0};
  const auto set = [&](const float *rows) { return meetc::prepare({rows, 0, 0, nullptr, 1}, *p.a); };
  std::printf("%llu\n", static_cast<unsigned long long>(meetc::collide(set(a), set(b), p, meetc::rung::certified).count));
}
CPP
pc=("$usr"/lib/*/pkgconfig/meetc.pc "$usr"/lib/pkgconfig/meetc.pc)
PKG_CONFIG_PATH=$(dirname "${pc[0]}")
export PKG_CONFIG_PATH
read -ra flags < <(pkg-config --cflags meetc)
read -ra libraries < <(pkg-config --libs meetc)
"$compiler" -std=c++20 -O1 program.cpp "${flags[@]}" "${libraries[@]}" -o by_pkg_config
[ "$(./by_pkg_config)" = 1 ] || fail "by pkg-config: $(./by_pkg_config)"
cat >CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(uses LANGUAGES CXX)
find_package(meetc REQUIRED CONFIG)
add_executable(by_cmake program.cpp)
target_link_libraries(by_cmake PRIVATE meet::runtime meet::kernels)
CMAKE
cmake -S . -B uses -DCMAKE_PREFIX_PATH="$usr" -DCMAKE_CXX_COMPILER="$compiler" >cmake.log 2>&1 && cmake --build uses >>cmake.log 2>&1 ||
  fail "$(cat cmake.log)"
[ "$(uses/by_cmake)" = 1 ] || fail "by CMake: $(uses/by_cmake)"
echo "$(ls made/*.deb | wc -l) packages"
