# Shared by the scripts about flags: the checked-in headers, the compilers, and the hostile program.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(flags)
set(headers "-I${SOURCE}/generated/default" "-I${SOURCE}/runtime/kernel")
set(hostile "${ROOM}/flags/hostile.cpp")
set(strict -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
# Variants of the programs have one predicate of each sort, or all of them in the long mode.
set(few -DHOSTILE_FEW -DMIXED_FEW)
if(LONG)
  set(few "")
endif()
set(right " 0 certified wrong, 0 hits wrong")

find_program(GXX g++)
find_program(CLANGXX clang++)
if(NOT GXX AND NOT CLANGXX)
  fail("no compiler was tried")
endif()

# compile(COMPILER PROGRAM FLAGS ... SOURCES ...): COMPILER -std=c++20 ... -o PROGRAM, in the room.
macro(compile compiler program)
  run("${compiler}" -std=c++20 ${headers} ${ARGN} -o "${ROOM}/${program}")
endmacro()
# run_hostile(COMPILER [flag ...]): builds and runs the hostile program; its output is in OUTPUT.
macro(run_hostile compiler)
  compile("${compiler}" hostile ${strict} "${hostile}" ${ARGN})
  run("${ROOM}/hostile" words)
endmacro()
# Puts a pragma before all includes of a program, by ${under_pragma}.
function(write_pragma text)
  file(WRITE "${ROOM}/pragma.hpp" "#pragma ${text}\n")
endfunction()
set(under_pragma -include "${ROOM}/pragma.hpp")
