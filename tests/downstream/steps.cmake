# The steps of the test scripts. A step that fails stops the script with its command and complete output.
cmake_minimum_required(VERSION 3.25)

set(HERE "${CMAKE_CURRENT_LIST_DIR}")
set(PREFIX "${WORK}/prefix")          # the complete installation
set(RUNTIME_PREFIX "${WORK}/runtime") # only the runtime
set(ALGEBRA "${PREFIX}/${DATADIR}/meetc/algebra_spec")
set(MEETC "${PREFIX}/bin/meetc")
set(ROOM "${WORK}/room of ${NAME}")   # for this script only; the blanks are intended

function(fail text)
  message(FATAL_ERROR "${NAME}: ${text}")
endfunction()

# run(COMMAND ...): must succeed; the output of both streams is in OUTPUT.
macro(run)
  _run("${ARGN}")
  if(NOT RESULT EQUAL 0)
    fail("exit ${RESULT} of: ${ARGN}\n${OUTPUT}")
  endif()
endmacro()

# run_to_fail(COMMAND ...): must not succeed.
macro(run_to_fail)
  _run("${ARGN}")
  if(RESULT EQUAL 0)
    fail("should have failed: ${ARGN}\n${OUTPUT}")
  endif()
endmacro()

function(_run command)
  execute_process(COMMAND ${command} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(RESULT "${result}" PARENT_SCOPE)
  set(OUTPUT "${output}" PARENT_SCOPE)
endfunction()

# expect(TEXT ...): each text is in OUTPUT, however its lines are broken.
function(expect)
  string(REGEX REPLACE "[ \n]+" " " flat "${OUTPUT}")
  foreach(text IN LISTS ARGN)
    string(FIND "${flat}" "${text}" at)
    if(at EQUAL -1)
      fail("'${text}' is missing in:\n${OUTPUT}")
    endif()
  endforeach()
endfunction()

function(expect_none)
  foreach(text IN LISTS ARGN)
    string(FIND "${OUTPUT}" "${text}" at)
    if(NOT at EQUAL -1)
      fail("'${text}' should not be in:\n${OUTPUT}")
    endif()
  endforeach()
endfunction()

# fresh_room([FOLDER ...]): empties the script's folder and copies these projects into it.
function(fresh_room)
  file(REMOVE_RECURSE "${ROOM}")
  file(MAKE_DIRECTORY "${ROOM}")
  foreach(folder IN LISTS ARGN)
    file(COPY "${HERE}/${folder}" DESTINATION "${ROOM}")
  endforeach()
endfunction()

# configure_command(OUT FOLDER [option ...]): the command that configures FOLDER in FOLDER-build with the compiler and
# the generator of the main build. Except in the long mode, the compiler inlines what it likes and optimises nothing, which
# takes less than half the time.
function(configure_command out folder)
  set(quick "")
  if(NOT LONG)
    set(quick "-DCMAKE_CXX_FLAGS=-DMEETC_PLAIN_INLINE" "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG")
  endif()
  set(${out} ${CMAKE_COMMAND} -S "${folder}" -B "${folder}-build" -G "${GENERATOR}" "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
    "-DCMAKE_CXX_COMPILER=${CXX}" -DCMAKE_BUILD_TYPE=Release ${quick} ${ARGN} PARENT_SCOPE)
endfunction()
macro(configure folder)
  configure_command(_configure "${folder}" ${ARGN})
  run(${_configure})
endmacro()
macro(configure_to_fail folder)
  configure_command(_configure "${folder}" ${ARGN})
  run_to_fail(${_configure})
endmacro()
macro(build folder)
  run(${CMAKE_COMMAND} --build "${folder}-build" --parallel 2 ${ARGN})
endmacro()
