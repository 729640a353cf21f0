# A separate project that finds the installed package.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(cell)

configure("${ROOM}/cell" "-DCMAKE_PREFIX_PATH=${PREFIX}")
build("${ROOM}/cell")
run("${ROOM}/cell-build/app")
expect("norm2 1024 1024, off the axis 0" "hit 1 0" "2 predicates of cell")
run("${ROOM}/cell-build/frame")
expect("2 pairs")
# Only what was asked for is compiled.
expect_none("avx2: runs here, but is not compiled" "avx512: compiled")

# A missing component is named, and another minor version is not accepted.
file(MAKE_DIRECTORY "${ROOM}/wrong")
file(WRITE "${ROOM}/wrong/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(wrong LANGUAGES CXX)\n"
  "find_package(meetc \${WANT} REQUIRED CONFIG COMPONENTS \${PARTS})\n")
configure_to_fail("${ROOM}/wrong" "-DCMAKE_PREFIX_PATH=${RUNTIME_PREFIX}" -DWANT=0.2 -DPARTS=generator)
expect("the component 'generator' is not installed in" "installed: runtime")
configure_to_fail("${ROOM}/wrong" "-DCMAKE_PREFIX_PATH=${RUNTIME_PREFIX}" -DWANT=0.7 -DPARTS=runtime)
expect("requested version")
configure("${ROOM}/wrong" "-DCMAKE_PREFIX_PATH=${RUNTIME_PREFIX}" -DWANT=0.2 "-DPARTS=runtime\;io" --fresh)
