# A user's library is installed and exported; a third project uses it, without meetc.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(cell exporter third)

configure("${ROOM}/exporter" "-DCMAKE_PREFIX_PATH=${PREFIX}")
build("${ROOM}/exporter")
run(${CMAKE_COMMAND} --install "${ROOM}/exporter-build" --prefix "${ROOM}/first")
file(RENAME "${ROOM}/first" "${ROOM}/robot")
file(REMOVE_RECURSE "${ROOM}/exporter" "${ROOM}/exporter-build" "${ROOM}/cell")
file(GLOB_RECURSE files "${ROOM}/robot/*.cmake" "${ROOM}/robot/*.hpp")
foreach(file IN LISTS files)
  file(READ "${file}" OUTPUT)
  expect_none("${WORK}" "meetc::meetc" "meet::core")
endforeach()

configure("${ROOM}/third" "-DCMAKE_PREFIX_PATH=${ROOM}/robot")
build("${ROOM}/third")
run("${ROOM}/third-build/third")
expect("arm 1 0, here 1, 2 predicates")
