# Headers of the standard library and of fmt, which most units include: they are parsed once. A unit that forgets to
# include what it uses compiles all the same, so that the sanitizers' build and clang-tidy do without.
option(MEETC_PRECOMPILED_HEADERS "Parse the headers of libraries once for all units" ${PROJECT_IS_TOP_LEVEL})

set(meetc_little_optimisation $<$<NOT:$<CONFIG:Debug>>:-O1>)

if(MEETC_PRECOMPILED_HEADERS)
  file(WRITE ${PROJECT_BINARY_DIR}/library_headers.cpp "")
  foreach(headers meetc_library_headers meetc_library_headers_little)
    add_library(${headers} OBJECT ${PROJECT_BINARY_DIR}/library_headers.cpp)
    target_precompile_headers(${headers} PRIVATE <algorithm> <array> <chrono> <cmath> <filesystem> <fstream>
      <functional> <iostream> <limits> <map> <memory> <numeric> <optional> <random> <set> <span> <sstream> <stdexcept> <string>
      <string_view> <tuple> <unordered_map> <utility> <variant> <vector> <fmt/format.h>)
    target_link_libraries(${headers} PRIVATE meetc_flags fmt::fmt)
    target_compile_features(${headers} PRIVATE cxx_std_20)
  endforeach()
  target_compile_options(meetc_library_headers_little PRIVATE ${meetc_little_optimisation})
endif()

# meetc_use_library_headers([LITTLE] TARGET ...): of targets that link fmt::fmt and meetc_flags. LITTLE: they are optimised
# little. That compiles faster, and generating, reading options and writing reports take no longer.
function(meetc_use_library_headers)
  set(headers meetc_library_headers)
  if("${ARGV0}" STREQUAL LITTLE)
    set(headers meetc_library_headers_little)
    list(POP_FRONT ARGN)
    foreach(target IN LISTS ARGN)
      target_compile_options(${target} PRIVATE ${meetc_little_optimisation})
    endforeach()
  endif()
  if(MEETC_PRECOMPILED_HEADERS)
    foreach(target IN LISTS ARGN)
      target_precompile_headers(${target} REUSE_FROM ${headers})
    endforeach()
  endif()
endfunction()

# meetc_only_drives(TARGET ...): of targets that read options, call others and write reports. The sanitizers add so much
# code to them that they are not optimised at all there.
function(meetc_only_drives)
  if(MEETC_SANITIZE)
    foreach(target IN LISTS ARGN)
      target_compile_options(${target} PRIVATE -O0)
    endforeach()
  endif()
endfunction()
