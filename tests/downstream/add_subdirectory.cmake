# A project that has meetc as a subfolder. The generator's build is only configured here, since the main build has
# made it; the project uses the finished one.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(cell)

configure("${ROOM}/cell" "-DMEETC_SOURCE=${SOURCE}" -DMEETC_CUDA=OFF)
if(GENERATOR STREQUAL "Ninja")
  run("${MAKE_PROGRAM}" -C "${ROOM}/cell-build" -n app)
  expect("Linking CXX executable meetc/gen/meetc" "Generating robot_cell from")
  string(FIND "${OUTPUT}" "executable meetc/gen/meetc" linked)
  string(FIND "${OUTPUT}" "Generating robot_cell" generated)
  if(generated LESS linked)
    fail("generates before there is a generator:\n${OUTPUT}")
  endif()
endif()
# A subproject adds no tests and installs nothing.
run(${CMAKE_COMMAND} --install "${ROOM}/cell-build" --prefix "${ROOM}/none")
if(EXISTS "${ROOM}/none")
  fail("the subproject installs itself")
endif()

configure("${ROOM}/cell" "-DMEETC_EXECUTABLE=${MEETC}" -DMEETC_BUILD_GENERATOR=OFF)
build("${ROOM}/cell" --target app)
run("${ROOM}/cell-build/app")
expect("norm2 1024 1024, off the axis 0" "hit 1 0" "2 predicates of cell")
