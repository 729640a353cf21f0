# Heavy tests: those that take minutes, and say the same again unless something has changed that they consist of. CTest
# runs a heavy test if its hash differs from the one in tests/heavy.txt (tests/heavy/heavy.py). They are not built before
# they are run, and each builds what it needs.
#
# meetc_add_heavy(NAME name COMMAND program [argument ...]
#   [TARGETS target ...]   # what is built for it, and thus all sources, headers and flags of these and of what they link
#   [EMITTED target ...]   # libraries of meetc_add_kernels, of whose emitted files some are among INPUTS
#   [INPUTS path ...]      # further files, or folders with all in them; the headers of sources are found, in INCLUDES
#   [INCLUDES folder ...]
#   [TOOLS program ...]    # their versions count; so do those of the compilers of TARGETS
#   [DATA folder]          # files outside the project, which it reads where the folder exists
#   [NATIVE]               # it depends on the instruction sets of this machine
#   [ASSUMES target ...]   # what it runs, which counts for nothing: not named in TARGETS, and built
#   [FIXTURE name] [TIMEOUT seconds] [PROCESSORS number])
# A path in COMMAND that lies in the source folder is an input too.
find_program(MEETC_PYTHON NAMES python3)
mark_as_advanced(MEETC_PYTHON)
set(MEETC_HEAVY_FOLDER ${PROJECT_BINARY_DIR}/heavy)
file(REMOVE_RECURSE ${MEETC_HEAVY_FOLDER}/declared)
file(MAKE_DIRECTORY ${MEETC_HEAVY_FOLDER}/declared)
file(TOUCH ${MEETC_HEAVY_FOLDER}/selected.cmake) # the tests that `heavy.py select` has chosen
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY TEST_INCLUDE_FILES ${MEETC_HEAVY_FOLDER}/selected.cmake)

function(meetc_add_heavy)
  cmake_parse_arguments(PARSE_ARGV 0 arg "NATIVE" "NAME;DATA;FIXTURE;TIMEOUT;PROCESSORS"
    "COMMAND;TARGETS;EMITTED;INPUTS;INCLUDES;TOOLS;ASSUMES")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_NAME OR NOT arg_COMMAND)
    message(FATAL_ERROR "meetc_add_heavy(${arg_NAME}): unknown or missing: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(MEETC_SANITIZE)
    string(PREPEND arg_NAME "sanitize.") # there is one list for both builds
  endif()
  get_property(declared GLOBAL PROPERTY MEETC_HEAVY_NAMES)
  if(arg_NAME IN_LIST declared)
    message(FATAL_ERROR "meetc_add_heavy(${arg_NAME}): the name is taken: under the sanitizers, a folder's program has its name")
  endif()
  set(lines "")
  foreach(word IN LISTS arg_COMMAND)
    if(TARGET "${word}")
      set(word "$<TARGET_FILE:${word}>")
    endif()
    string(APPEND lines "command ${word}\n")
  endforeach()
  foreach(target IN LISTS arg_TARGETS arg_ASSUMES)
    string(APPEND lines "build ${target}\n")
  endforeach()
  foreach(target IN LISTS arg_EMITTED)
    string(APPEND lines "prepare ${target}.files\n")
  endforeach()
  foreach(key INPUTS INCLUDES TOOLS)
    string(TOLOWER ${key} name)
    foreach(value IN LISTS arg_${key})
      if(NOT key STREQUAL TOOLS)
        cmake_path(ABSOLUTE_PATH value BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
      endif()
      string(APPEND lines "${name} ${value}\n")
    endforeach()
  endforeach()
  string(APPEND lines "inputs ${CMAKE_CURRENT_LIST_FILE}\nnative ${arg_NATIVE}\n")
  if(arg_DATA)
    file(REAL_PATH ${arg_DATA} folder)
    string(APPEND lines "data ${folder}\n")
  endif()
  foreach(key FIXTURE TIMEOUT PROCESSORS)
    string(TOLOWER ${key} name)
    string(APPEND lines "${name} ${arg_${key}}\n")
  endforeach()
  set_property(GLOBAL APPEND PROPERTY MEETC_HEAVY_NAMES ${arg_NAME})
  set_property(GLOBAL PROPERTY MEETC_HEAVY_LINES_${arg_NAME} "${lines}")
  set_property(GLOBAL PROPERTY MEETC_HEAVY_TARGETS_${arg_NAME} ${arg_TARGETS})
endfunction()

# Sets `out` to a line for the folder of objects of each target, and of all that they link or are said to depend on, and to
# lines for what is emitted among it. The objects for further instruction sets are of the same sources, and which ones there
# are depends on the machine: they are left out.
function(_meetc_objects_of out)
  set(todo ${ARGN})
  set(seen "")
  set(more "")
  while(todo)
    list(POP_FRONT todo target)
    get_target_property(aliased ${target} ALIASED_TARGET)
    if(aliased)
      set(target ${aliased})
    endif()
    get_target_property(imported ${target} IMPORTED)
    if(imported OR target IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${target})
    get_target_property(type ${target} TYPE)
    if(type STREQUAL UTILITY AND NOT target MATCHES "[.]files$")
      message(FATAL_ERROR "${target}: the inputs of its commands are not known: name them in INPUTS, and the target in ASSUMES")
    endif()
    get_target_property(emitted ${target} meetc_folder)
    if(emitted)
      string(APPEND more "prepare ${target}.files\n")
    endif()
    get_target_property(folder ${target} BINARY_DIR)
    file(RELATIVE_PATH folder ${PROJECT_BINARY_DIR} ${folder}/CMakeFiles/${target}.dir)
    string(APPEND more "objects ${folder}\n")
    foreach(property LINK_LIBRARIES INTERFACE_LINK_LIBRARIES MANUALLY_ADDED_DEPENDENCIES PRECOMPILE_HEADERS_REUSE_FROM)
      get_target_property(value ${target} ${property})
      string(REGEX MATCHALL "[A-Za-z0-9_]+(::[A-Za-z0-9_]+)?" words "${value}")
      foreach(word IN LISTS words)
        if(TARGET ${word})
          list(APPEND todo ${word})
        endif()
      endforeach()
    endforeach()
  endwhile()
  set(${out} "${more}" PARENT_SCOPE)
endfunction()

# Called when all targets are there: writes what heavy.py reads.
function(meetc_write_heavy)
  get_property(names GLOBAL PROPERTY MEETC_HEAVY_NAMES)
  foreach(name IN LISTS names)
    get_property(lines GLOBAL PROPERTY MEETC_HEAVY_LINES_${name})
    get_property(targets GLOBAL PROPERTY MEETC_HEAVY_TARGETS_${name})
    _meetc_objects_of(more ${targets})
    file(GENERATE OUTPUT ${MEETC_HEAVY_FOLDER}/declared/${name} CONTENT "source ${PROJECT_SOURCE_DIR}\n${lines}${more}")
  endforeach()
endfunction()
