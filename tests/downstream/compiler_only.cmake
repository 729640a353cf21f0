# Generated files copied into a folder, and nothing but a compiler: no library, no CMake.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(plain)
set(MEETC_ALGEBRA_DIR "${ALGEBRA}")
configure_file("${HERE}/cell/robot_cell.toml.in" "${ROOM}/robot_cell.toml" @ONLY)
run("${MEETC}" generate "${ROOM}/robot_cell.toml" -o "${ROOM}/generated")

find_program(GXX g++)
find_program(CLANGXX clang++)
set(found "")
foreach(compiler IN ITEMS ${GXX} ${CLANGXX})
  # The user's flags may be any: what is certified must not depend on them.
  foreach(flags IN ITEMS "-O0" "-O3;-march=native")
    run("${compiler}" -std=c++20 ${flags} -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
      "-I${ROOM}/generated" "${ROOM}/plain/app.cpp" -o "${ROOM}/app")
    run("${ROOM}/app")
    expect("norm2 1024, 0 wrong of 20000")
    list(APPEND found "${compiler}")
  endforeach()
endforeach()
if(NOT found)
  fail("no compiler was tried")
endif()
