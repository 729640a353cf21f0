# Headers of the standard library and of fmt, which most units include: they are parsed once. A unit that forgets to
# include what it uses compiles all the same, so that the sanitizers' build and clang-tidy do without.
option(MEETC_PRECOMPILED_HEADERS "Parse the headers of libraries once for all units" ${PROJECT_IS_TOP_LEVEL})

if(MEETC_PRECOMPILED_HEADERS)
  file(WRITE ${PROJECT_BINARY_DIR}/library_headers.cpp "")
  add_library(meetc_library_headers OBJECT ${PROJECT_BINARY_DIR}/library_headers.cpp)
  target_precompile_headers(meetc_library_headers PRIVATE <algorithm> <array> <chrono> <cmath> <filesystem> <fstream>
    <functional> <iostream> <limits> <map> <memory> <numeric> <optional> <random> <set> <span> <sstream> <stdexcept> <string>
    <string_view> <tuple> <unordered_map> <utility> <variant> <vector> <fmt/format.h>)
  target_link_libraries(meetc_library_headers PRIVATE meetc_flags fmt::fmt)
  target_compile_features(meetc_library_headers PRIVATE cxx_std_20)
endif()

# meetc_optimise_little(FILE ...): units that read a command line. Optimising what CLI11 puts into each takes most of their
# time.
function(meetc_optimise_little)
  set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS $<$<NOT:$<CONFIG:Debug>>:-O1>)
  set_property(SOURCE ${ARGN} PROPERTY SKIP_PRECOMPILE_HEADERS ON) # of other options
endfunction()

# meetc_use_library_headers(TARGET ...): of targets that link fmt::fmt and meetc_flags.
function(meetc_use_library_headers)
  if(MEETC_PRECOMPILED_HEADERS)
    foreach(target IN LISTS ARGN)
      target_precompile_headers(${target} REUSE_FROM meetc_library_headers)
    endforeach()
  endif()
endfunction()
