#!/usr/bin/env bash
# options.sh SOURCE: no command leaves an option in the cache that another one then takes for its own: what `./dev demo` and
# `./dev test` set, the README's preset sets too.
set -euo pipefail
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$source"

# The options that ./dev gives to the preset.
mapfile -t given < <(grep -oE -- '-D(MEETC_(CUDA|INSTRUCTION_SETS|WERROR))\b' dev | sort -u)
[ ${#given[@]} -eq 3 ] || {
  echo "FAILED: ./dev gives ${given[*]}"
  exit 1
}
cached() { sed -nE "s/^$1:[A-Z]+=//p" "$folder/build/CMakeCache.txt"; }
cmake --preset release -B "$folder/build" -DMEETC_CUDA=OFF -DMEETC_BUILD_TESTS=OFF -DMEETC_INSTRUCTION_SETS=avx2 \
  -DMEETC_WERROR=ON >/dev/null
[ "$(cached MEETC_CUDA) $(cached MEETC_INSTRUCTION_SETS) $(cached MEETC_WERROR)" = "OFF avx2 ON" ] || {
  echo "FAILED: a given option has no effect"
  exit 1
}
grep -q 'MEETC_CUDA was off' "$folder/build/compile_commands.json" || {
  echo "FAILED: the program does not know why it has no CUDA kernels"
  exit 1
}
cmake --preset release -B "$folder/build" -DMEETC_BUILD_TESTS=OFF >/dev/null
[ "$(cached MEETC_CUDA) $(cached MEETC_INSTRUCTION_SETS) $(cached MEETC_WERROR)" = "ON avx2;avx512 OFF" ] || {
  echo "FAILED: the preset keeps MEETC_CUDA=$(cached MEETC_CUDA), MEETC_INSTRUCTION_SETS=$(cached MEETC_INSTRUCTION_SETS)," \
    "MEETC_WERROR=$(cached MEETC_WERROR)"
  exit 1
}

# A subproject without a build type is told that it is slow, and one with a build type is not.
mkdir "$folder/project"
printf 'cmake_minimum_required(VERSION 3.25)\nproject(p CXX)\nadd_subdirectory("%s" meetc EXCLUDE_FROM_ALL)\n' "$source" \
  >"$folder/project/CMakeLists.txt"
options=(-S "$folder/project" -B "$folder/subproject" -DMEETC_CUDA=OFF -DMEETC_BUILD_GENERATOR=OFF)
said=$(cmake "${options[@]}" 2>&1)
[[ $said == *'meetc is compiled without optimisation'* ]] || {
  echo "FAILED: a subproject without a build type is not told: $said"
  exit 1
}
said=$(cmake "${options[@]}" -DCMAKE_BUILD_TYPE=Release 2>&1)
[[ $said != *'without optimisation'* ]] || {
  echo "FAILED: a subproject with a build type is told that it has none"
  exit 1
}
