# Names that C++ reserves, two scenes in one program, and the user's warnings.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(cell names)

configure("${ROOM}/names" "-DCMAKE_PREFIX_PATH=${PREFIX}")
build("${ROOM}/names")
run("${ROOM}/names-build/app")
expect("2 2 2" "int of meet" "namespace of meet" "second 1")

# The support header is the same whichever folder comes first on the include path, also the runtime's.
set(generated "${ROOM}/names-build")
file(SHA256 "${PREFIX}/include/meetc/meetc/support.hpp" wanted)
foreach(target IN ITEMS robot_cell other_cell odd_cell)
  file(SHA256 "${generated}/${target}.generated/meetc/support.hpp" found)
  if(NOT found STREQUAL wanted)
    fail("the support header of ${target} is another one")
  endif()
endforeach()
