# Checked-in files: they are compiled as they are, regenerated on demand, and compared by a test.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(cell checked_in)
set(project "${ROOM}/checked_in")
file(COPY "${ALGEBRA}" DESTINATION "${project}")

# At first there are no files.
configure("${project}" "-DCMAKE_PREFIX_PATH=${PREFIX}" -DFIND_MEETC=ON)
expect("not there yet; run: cmake --build" "--target robot_cell.update")
run_to_fail(${CMAKE_COMMAND} --build "${project}-build" --target app)
build("${project}" --target robot_cell.update)
build("${project}")
expect_none("Generating")
run("${project}-build/app")
expect("norm2 1024 1024, off the axis 0" "hit 1 0")
run(${CMAKE_CTEST_COMMAND} --test-dir "${project}-build")

# The build does not read the scene; the test does.
file(APPEND "${project}/robot_cell.toml" "# a remark\n")
build("${project}")
expect_none("Generating" "Building")
run_to_fail(${CMAKE_CTEST_COMMAND} --test-dir "${project}-build" --output-on-failure)
expect("robot_cell.up_to_date" "differs from what the spec gives")
build("${project}" --target robot_cell.update)
run(${CMAKE_CTEST_COMMAND} --test-dir "${project}-build")

# A byte changed by hand is found; so are a missing and a stray file.
file(APPEND "${project}/generated/cell/kinds.hpp" " ")
run_to_fail(${CMAKE_CTEST_COMMAND} --test-dir "${project}-build" --output-on-failure)
expect("cell/kinds.hpp: differs")
file(WRITE "${project}/generated/cell/mine.hpp" "\n")
file(REMOVE "${project}/generated/cell/ball_ball.hpp")
run_to_fail(${CMAKE_CTEST_COMMAND} --test-dir "${project}-build" --output-on-failure)
expect("cell/mine.hpp: stray" "cell/ball_ball.hpp: missing")
file(REMOVE "${project}/generated/cell/mine.hpp")
build("${project}" --target robot_cell.update)
run(${CMAKE_CTEST_COMMAND} --test-dir "${project}-build")
