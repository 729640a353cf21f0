#!/usr/bin/env bash
# package.sh BUILD MEET PYTHON [option of CMake ...]: compiles the package for Python in the folder BUILD, and runs its tests.
# MEET is the program in its own build, runtime/app/meet: that build's instruction sets are taken, and the program's answers
# are compared.
set -euo pipefail
build=$1 meet=$2 python=$3
source=$(cd "$(dirname "$0")/../.." && pwd)
sets=$(sed -n 's/^MEETC_INSTRUCTION_SETS:[A-Z]*=//p' "$(dirname "$meet")/../../CMakeCache.txt")
launcher=()
! command -v ccache >/dev/null || launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
mkdir -p "$build"
cmake -S "$source" -B "$build" -G Ninja "${launcher[@]}" -DCMAKE_BUILD_TYPE=Release -DMEETC_WERROR=ON -DMEETC_CUDA=OFF \
  -DMEETC_BUILD_GENERATOR=OFF -DMEETC_BUILD_TESTS=OFF -DMEETC_BUILD_PYTHON=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  "-DMEETC_INSTRUCTION_SETS=$sets" "-DPython_EXECUTABLE=$python" "-DMEETC_MEET=$meet" "${@:4}" \
  >"$build/configured" 2>&1 || {
  cat "$build/configured"
  exit 1
}
cmake --build "$build" --target meetc_python
ctest --test-dir "$build" -L '^python$' --output-on-failure --no-tests=error
