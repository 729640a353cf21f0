# The parts that are built where no option says otherwise: the generator, and in a project of its own the program, if the
# libraries that they need are there, and with the program the tests. CMake says what is missing for a part that its option
# asks for.
#
# meetc_missing(OUT [PACKAGES name ...] [LIBRARIES name ...] [HEADERS name ...]): those that are not found.
function(meetc_missing out)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "PACKAGES;LIBRARIES;HEADERS")
  set(missing "")
  foreach(name IN LISTS arg_PACKAGES)
    find_package(${name} QUIET)
    if(NOT ${name}_FOUND)
      list(APPEND missing ${name})
    endif()
  endforeach()
  foreach(name IN LISTS arg_LIBRARIES)
    string(TOUPPER ${name} variable) # under which the generator's folders look for it
    find_library(${variable}_LIBRARY ${name})
    if(NOT ${variable}_LIBRARY)
      list(APPEND missing ${name})
    endif()
  endforeach()
  foreach(name IN LISTS arg_HEADERS)
    string(MAKE_C_IDENTIFIER "MEETC_FOUND_${name}" variable)
    find_path(${variable} ${name})
    mark_as_advanced(${variable})
    if(NOT ${variable})
      list(APPEND missing ${name})
    endif()
  endforeach()
  set(${out} ${missing} PARENT_SCOPE)
endfunction()

# meetc_part(OPTION TEXT WANTED [PACKAGES ...] [LIBRARIES ...] [HEADERS ...]): the option, which is WANTED unless it is given
# or something is missing.
function(meetc_part name text wanted)
  if(NOT DEFINED ${name} AND wanted)
    meetc_missing(missing ${ARGN})
    if(missing)
      list(JOIN missing ", " missing)
      message(STATUS "meetc: ${name} is OFF, since there is no ${missing}")
      set(${name} OFF PARENT_SCOPE) # not for good: what is missing may be installed
      return()
    endif()
  endif()
  option(${name} "${text}" ${wanted})
endfunction()

meetc_part(MEETC_BUILD_GENERATOR "Build meetc, the generator (needs FLINT, GMP, toml++ and CLI11)" ON
  PACKAGES CLI11 LIBRARIES flint gmp gmpxx HEADERS toml++/toml.h)
meetc_part(MEETC_BUILD_PROGRAM
  "Build meet with the runtime (needs CLI11, nlohmann-json, tinyxml2, libpng, zlib, freetype and fontconfig)" ${PROJECT_IS_TOP_LEVEL}
  PACKAGES CLI11 nlohmann_json tinyxml2 PNG ZLIB Freetype Fontconfig)
set(tested ${PROJECT_IS_TOP_LEVEL})
if(MEETC_BUILD_RUNTIME AND NOT MEETC_BUILD_PROGRAM)
  set(tested OFF)
endif()
option(MEETC_BUILD_TESTS "Build the tests (needs Catch2)" ${tested})
