#!/usr/bin/env bash
# package.sh SOURCE BUILD PYTHON MEET SETS: compiles the package for Python in the folder BUILD, for these instruction sets
# beside the baseline, and runs its tests; MEET is the program with whose answers they compare.
set -euo pipefail
source=$1 build=$2 python=$3 meet=$4 sets=$5
launcher=()
! command -v ccache >/dev/null || launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S "$source" -B "$build" -G Ninja "${launcher[@]}" -DCMAKE_BUILD_TYPE=Release -DMEETC_WERROR=ON -DMEETC_CUDA=OFF \
  -DMEETC_BUILD_GENERATOR=OFF -DMEETC_BUILD_TESTS=OFF -DMEETC_BUILD_PYTHON=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  "-DMEETC_INSTRUCTION_SETS=$sets" "-DPython_EXECUTABLE=$python" "-DMEETC_MEET=$meet" >"$build.log" 2>&1 || {
  cat "$build.log"
  exit 1
}
cmake --build "$build" --target meetc_python
ctest --test-dir "$build" -L '^python$' --output-on-failure --no-tests=error
