# Checked-in files without a generator: with the package of the runtime, and without any part of meetc; and the runtime
# itself, built without the generator and its dependencies.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(cell checked_in)
set(project "${ROOM}/checked_in")
file(COPY "${ALGEBRA}" DESTINATION "${project}")

configure_to_fail("${project}" "-DCMAKE_PREFIX_PATH=${RUNTIME_PREFIX}" -DFIND_MEETC=ON)
expect("cell_runtime.cpp and 8 more: not there, and it cannot be generated: there is no meetc")
run("${MEETC}" generate "${project}/robot_cell.toml" -o "${project}/generated")
file(REMOVE_RECURSE "${project}/algebra_spec") # not read

configure("${project}" "-DCMAKE_PREFIX_PATH=${RUNTIME_PREFIX}" -DFIND_MEETC=ON --fresh)
expect("compiles what is checked in; no robot_cell.update")
build("${project}")
run("${project}-build/app")
expect("norm2 1024 1024, off the axis 0" "hit 1 0")
run("${project}-build/frame")
expect("2 pairs")

configure("${project}" "-DMEETC_FUNCTIONS=${SOURCE}/gen/cmake/meetc_add_kernels.cmake" -DFIND_MEETC=OFF --fresh)
build("${project}" --target app)

# The build of the runtime does not search for the generator's libraries and has none of its targets.
configure_command(command "${SOURCE}" -DMEETC_BUILD_GENERATOR=OFF -DMEETC_BUILD_TESTS=OFF -DMEETC_CUDA=OFF
  -DFLINT_LIBRARY=FLINT_LIBRARY-NOTFOUND)
list(APPEND command -B "${ROOM}/meetc-build")
run(${command})
run(${CMAKE_COMMAND} --build "${ROOM}/meetc-build" --parallel 2 --target meet_core)
run(${CMAKE_COMMAND} --build "${ROOM}/meetc-build" --target help)
expect_none("gen_poly")

# Parts whose libraries are missing are left out, unless they are asked for.
function(configure_without package)
  configure_command(command "${SOURCE}" -DMEETC_CUDA=OFF -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON ${ARGN})
  file(REMOVE_RECURSE "${ROOM}/meetc-without")
  list(APPEND command -B "${ROOM}/meetc-without")
  _run("${command}")
  set(RESULT "${RESULT}" PARENT_SCOPE)
  set(OUTPUT "${OUTPUT}" PARENT_SCOPE)
endfunction()
configure_without(CLI11)
expect("MEETC_BUILD_GENERATOR is OFF, since there is no CLI11" "MEETC_BUILD_PROGRAM is OFF, since there is no CLI11"
  "Generating done")
configure_without(tinyxml2)
expect("MEETC_BUILD_PROGRAM is OFF, since there is no tinyxml2" "Generating done")
expect_none("MEETC_BUILD_GENERATOR is OFF")
configure_without(tinyxml2 -DMEETC_BUILD_PROGRAM=ON)
if(RESULT EQUAL 0)
  fail("a program that was asked for is left out:\n${OUTPUT}")
endif()
