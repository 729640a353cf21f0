# The examples of docs/library.md and the README are built and run with the installed package. As a subfolder and by
# FetchContent, the library's targets have the same names.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room()
file(COPY "${SOURCE}/docs/examples/library" DESTINATION "${ROOM}")
file(READ "${ROOM}/library/CMakeLists.txt" lists)
set(find "find_package(meetc 0.2 REQUIRED CONFIG COMPONENTS runtime io)\n")

configure("${ROOM}/library" "-DCMAKE_PREFIX_PATH=${RUNTIME_PREFIX}")
build("${ROOM}/library")
run("${ROOM}/library-build/library")
expect("2 pairs at height 0 floor triangle 0, spike triangle 0 floor triangle 1, spike triangle 0 0 pairs at height 1e-30")
run("${ROOM}/library-build/pair")
expect("they touch")
run("${ROOM}/library-build/values")
expect("B^2 = 256: two points B^2 = 0: one point B^2 = -320: none")
file(WRITE "${ROOM}/dart.obj" "v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nv 2.00000001 0.25 0\nf 1 2 3 4\nf 1 5 3\n")
run("${ROOM}/library-build/read" "${ROOM}/dart.obj")
expect("2 faces, 3 triangles; float32 moved 1 numbers the ball touches face 1")

file(COPY "${SOURCE}/docs/examples/geometry" DESTINATION "${ROOM}")
configure("${ROOM}/geometry" "-DCMAKE_PREFIX_PATH=${PREFIX}")
build("${ROOM}/geometry")
run("${ROOM}/geometry-build/geometry")
expect("square 1024, coefficient of e1^n 16 hit 1")

# Everything that is installed lies in one folder of its own, and adds four names to a program's path.
file(GLOB headers RELATIVE "${RUNTIME_PREFIX}/include" "${RUNTIME_PREFIX}/include/*" "${RUNTIME_PREFIX}/include/meetc/*")
list(SORT headers)
if(NOT headers STREQUAL "meetc;meetc/cga;meetc/meet;meetc/meetc;meetc/neighbours")
  fail("installed: ${headers}")
endif()

# The same project with meetc added in other ways. It is only configured, since the main build has compiled the same code. A
# subproject builds no program, and looks for none of the program's libraries.
function(plan how text)
  string(REPLACE "${find}" "${text}\n" changed "${lists}")
  if(changed STREQUAL lists)
    fail("docs/examples/library/CMakeLists.txt does not have the line: ${find}")
  endif()
  file(MAKE_DIRECTORY "${ROOM}/${how}")
  file(COPY "${ROOM}/library/library.cpp" "${ROOM}/library/pair.cpp" "${ROOM}/library/read.cpp" "${ROOM}/library/values.cpp"
    DESTINATION "${ROOM}/${how}")
  file(WRITE "${ROOM}/${how}/CMakeLists.txt" "${changed}")
  configure("${ROOM}/${how}" -DMEETC_CUDA=OFF -DMEETC_BUILD_GENERATOR=OFF -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON
    -DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON)
  if(GENERATOR STREQUAL "Ninja")
    run("${MAKE_PROGRAM}" -C "${ROOM}/${how}-build" -n library)
    expect("libmeet_kernels" "Linking CXX executable library")
  endif()
endfunction()
plan(subfolder "add_subdirectory(\"${SOURCE}\" meetc EXCLUDE_FROM_ALL)")
plan(fetched "include(FetchContent)\nFetchContent_Declare(meetc SOURCE_DIR \"${SOURCE}\")\nFetchContent_MakeAvailable(meetc)")
