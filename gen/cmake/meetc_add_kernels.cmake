# meetc_add_kernels: a library from a scene, in a user's own project.
#
#   meetc_add_kernels(robot_cell
#     SCENE robot_cell.toml        # what to generate
#     NAMESPACE cell               # its C++ namespace; #include <cell/cell.hpp>
#     [BACKENDS cpp cuda c]        # what to compile; the scene must emit it. Default: cpp. cuda has the launchers of queries;
#                                  # that of every pair as a product of matrices is every_pair, which brings cuda along
#     [INSTRUCTION_SETS avx2 avx512] # compile the kernels for these as well; the program chooses when it starts
#     [CHECKED_IN generated])      # compile the files of this folder instead; nothing is generated at build time
#
# makes the static library robot_cell, an ordinary target with its include path. Once built it needs nothing of meetc;
# with cuda it needs CUDA's runtime library.
#
# CHECKED_IN adds the target robot_cell.update, which regenerates the folder in place, and the test
# robot_cell.up_to_date, which fails if the folder differs from what the scene generates. Both are left out if there is
# no generator; the library is built all the same.
#
#   meetc_install_kernels(robot_cell EXPORT cell_targets [DESTINATION include/robot_cell])
#
# installs the library with its headers and adds it to an export set, like install(TARGETS). With cuda, the package's
# config file has to say find_dependency(CUDAToolkit).
#
# The generator is MEETC_EXECUTABLE if that is set (a cross build needs one for the host), or else the target
# meetc::meetc of find_package(meetc) or add_subdirectory.

# A function keeps the policies in force where it was defined, whatever its caller sets. CMP0116, paths in a depfile, is
# one of them.
cmake_policy(PUSH)
cmake_policy(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/instruction_sets.cmake")

set(MEETC_EXECUTABLE "" CACHE FILEPATH "The meetc to run instead of the package's; a cross build needs one that runs here")

# Sets `out` to the command that runs meetc, and `out`_depends to the dependencies of a rule that runs it. Both are empty
# if there is none, and then `out`_why says why.
function(_meetc_find_generator out)
  set(command "")
  set(why "")
  if(MEETC_EXECUTABLE)
    if(NOT EXISTS "${MEETC_EXECUTABLE}")
      message(FATAL_ERROR "MEETC_EXECUTABLE is '${MEETC_EXECUTABLE}', which is not there")
    endif()
    set(command "${MEETC_EXECUTABLE}")
    set(depends "${MEETC_EXECUTABLE}")
  elseif(TARGET meetc::meetc)
    get_target_property(imported meetc::meetc IMPORTED)
    if(CMAKE_CROSSCOMPILING AND NOT imported AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
      set(why "this is a cross build, and its own meetc does not run here: set MEETC_EXECUTABLE to one that does")
    else()
      set(command "$<TARGET_FILE:meetc::meetc>")
      set(depends meetc::meetc)
    endif()
  else()
    set(why "there is no meetc: say find_package(meetc REQUIRED COMPONENTS generator) in this folder or above, or set \
MEETC_EXECUTABLE")
  endif()
  set(${out} "${command}" PARENT_SCOPE)
  set(${out}_depends "${depends}" PARENT_SCOPE)
  set(${out}_why "${why}" PARENT_SCOPE)
endfunction()

function(meetc_add_kernels target)
  set(me "meetc_add_kernels(${target})")
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SCENE;NAMESPACE;CHECKED_IN" "BACKENDS;INSTRUCTION_SETS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${me}: unknown: ${arg_UNPARSED_ARGUMENTS}; known: SCENE, NAMESPACE, BACKENDS, INSTRUCTION_SETS, "
      "CHECKED_IN")
  endif()
  foreach(key SCENE NAMESPACE)
    if(NOT arg_${key})
      message(FATAL_ERROR "${me}: ${key} is missing, as in: meetc_add_kernels(${target} SCENE ${target}.toml NAMESPACE cell)")
    endif()
  endforeach()
  if(arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "${me}: ${arg_KEYWORDS_MISSING_VALUES} has no value")
  endif()
  # The namespace names the files, so it must be one that meetc leaves unchanged (meetc refuses reserved words).
  if(NOT arg_NAMESPACE MATCHES "^[A-Za-z]([A-Za-z0-9]|_[A-Za-z0-9])*$" OR arg_NAMESPACE MATCHES "^(meetc|std|cuda|every_pair)$")
    message(FATAL_ERROR "${me}: '${arg_NAMESPACE}' cannot be the NAMESPACE: letters, digits and single '_' inside, "
      "not meetc, std, cuda or every_pair")
  endif()
  set(space "${arg_NAMESPACE}")

  cmake_path(ABSOLUTE_PATH arg_SCENE BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE OUTPUT_VARIABLE scene)
  get_source_file_property(made_by_a_rule "${scene}" GENERATED)
  if(NOT EXISTS "${scene}" AND NOT made_by_a_rule)
    message(FATAL_ERROR "${me}: the scene '${scene}' is not there")
  endif()

  foreach(backend IN LISTS arg_BACKENDS)
    if(NOT backend MATCHES "^(cpp|cuda|every_pair|c)$")
      message(FATAL_ERROR "${me}: no backend '${backend}'; known: cpp, cuda, every_pair, c")
    endif()
  endforeach()
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  set(device_backend cuda) # as it was asked for
  if("every_pair" IN_LIST arg_BACKENDS AND NOT "cuda" IN_LIST arg_BACKENDS)
    list(APPEND arg_BACKENDS cuda) # whose launchers decide what that leaves
    set(device_backend every_pair)
  endif()
  if("cuda" IN_LIST arg_BACKENDS)
    set(cuda ON)
    if(NOT "CUDA" IN_LIST languages)
      message(FATAL_ERROR "${me}: BACKENDS ${device_backend} needs the language CUDA; say enable_language(CUDA) before this call, or "
        "project(${PROJECT_NAME} LANGUAGES CXX CUDA)")
    endif()
    if(CMAKE_CUDA_COMPILER_ID STREQUAL "NVIDIA" AND CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 12)
      message(FATAL_ERROR "${me}: BACKENDS ${device_backend} needs CUDA 12 or later (C++20); this is ${CMAKE_CUDA_COMPILER_VERSION}")
    endif()
  else()
    set(cuda OFF)
  endif()
  if(NOT "CXX" IN_LIST languages)
    message(FATAL_ERROR "${me}: needs the language CXX; say project(${PROJECT_NAME} LANGUAGES CXX)")
  endif()

  # ---- where the files are, and what writes them ----
  _meetc_find_generator(meetc)
  if(arg_CHECKED_IN)
    cmake_path(ABSOLUTE_PATH arg_CHECKED_IN BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE OUTPUT_VARIABLE folder)
  else()
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/${target}.generated")
  endif()
  # Each predicate has a source, whose name only the scene knows. meetc also writes a fixed number of units that include
  # these sources, and the units are compiled, in parallel.
  set(units 8)
  set(sources "${folder}/${space}/${space}_runtime.cpp")
  foreach(i RANGE 1 ${units})
    list(APPEND sources "${folder}/${space}/units/unit_${i}.cpp")
  endforeach()
  set(headers "${folder}/meetc/environment/version.hpp" "${folder}/${space}/${space}.hpp" "${folder}/${space}/kinds.hpp"
    "${folder}/${space}/${space}_runtime.hpp")
  set(generate ${meetc} generate "${scene}" --out "${folder}" --namespace "${space}" --units ${units})
  if("c" IN_LIST arg_BACKENDS)
    list(APPEND sources "${folder}/${space}/${space}_c.cpp")
    list(APPEND headers "${folder}/${space}/${space}.h")
    list(APPEND generate --require-backend c)
  endif()
  if(cuda)
    list(APPEND sources "${folder}/${space}/${space}_cuda.cu")
    foreach(i RANGE 1 ${units})
      list(APPEND sources "${folder}/${space}/units/unit_${i}.cu")
    endforeach()
    list(APPEND headers "${folder}/${space}/${space}_cuda.hpp")
    list(APPEND generate --require-backend cuda)
  endif()
  if("every_pair" IN_LIST arg_BACKENDS)
    list(APPEND sources "${folder}/${space}/${space}_every_pair.cu")
    list(APPEND headers "${folder}/${space}/${space}_every_pair.hpp" "${folder}/${space}/ball_form.hpp")
    list(APPEND generate --require-backend every_pair)
  endif()

  # Files that were written by a plain `meetc generate` have no units; without meetc, each predicate's source is compiled.
  if(arg_CHECKED_IN AND NOT meetc AND NOT EXISTS "${folder}/${space}/units")
    file(GLOB by_predicate "${folder}/${space}/src/*.cpp")
    if(cuda)
      file(GLOB cuda_by_predicate "${folder}/${space}/src/*.cu")
      list(APPEND by_predicate ${cuda_by_predicate})
    endif()
    if(by_predicate)
      list(FILTER sources EXCLUDE REGEX "/units/unit_[0-9]+[.]c(pp|u)$")
      list(APPEND sources ${by_predicate})
    endif()
  endif()

  if(arg_CHECKED_IN)
    set(missing "")
    foreach(file IN LISTS sources)
      if(NOT EXISTS "${file}")
        list(APPEND missing "${file}")
      endif()
    endforeach()
    list(LENGTH missing count)
    if(count GREATER 1)
      list(GET missing 0 first)
      math(EXPR count "${count} - 1")
      set(what "${first} and ${count} more")
    else()
      set(what "${missing}")
    endif()
    if(missing AND NOT meetc)
      message(FATAL_ERROR "${me}: ${what}: not there, and it cannot be generated: ${meetc_why}")
    elseif(missing)
      # Without this property CMake would stop, and there would be no target to make the files.
      set_source_files_properties(${missing} PROPERTIES GENERATED ON)
      message(WARNING "${me}: ${what}: not there yet; run: cmake --build ${CMAKE_BINARY_DIR} --target ${target}.update")
    endif()
    if(meetc)
      add_custom_target(${target}.update COMMAND ${generate}
        DEPENDS ${meetc_depends}
        COMMENT "Generating ${arg_CHECKED_IN} from ${arg_SCENE}" VERBATIM)
      # Does nothing in a project without enable_testing().
      add_test(NAME ${target}.up_to_date COMMAND ${generate} --check)
    else()
      message(STATUS "${me}: compiles what is checked in; no ${target}.update: ${meetc_why}")
    endif()
  else()
    if(NOT meetc)
      message(FATAL_ERROR "${me}: ${meetc_why}, or compile generated files with CHECKED_IN")
    endif()
    # The stamp is the OUTPUT: every run touches it, while unchanged files keep their time, so a changed comment elsewhere
    # recompiles nothing. With the files as OUTPUT, Make would regenerate at every build. Ninja must know, before it
    # starts, a file that changes with the scene and that every user of the headers includes. kinds.hpp is that file (its
    # first line has a hash of the whole spec), so the headers of the kernels, whose names are not known here, need not
    # be listed.
    set(stamp "${CMAKE_CURRENT_BINARY_DIR}/${target}.stamp")
    set(depfile "${CMAKE_CURRENT_BINARY_DIR}/${target}.stamp.d")
    add_custom_command(OUTPUT "${stamp}" BYPRODUCTS ${sources} ${headers}
      COMMAND ${generate} --stamp "${stamp}" --depfile "${depfile}" --quiet
      DEPENDS "${scene}" ${meetc_depends}
      DEPFILE "${depfile}"
      COMMENT "Generating ${target} from ${arg_SCENE}" VERBATIM)
    list(APPEND sources "${stamp}")
    # The objects for further instruction sets are targets of their own, and one of them all runs meetc.
    add_custom_target(${target}.files DEPENDS "${stamp}")
  endif()

  # ---- the library ----
  add_library(${target} STATIC ${sources})
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${folder}>")
  target_compile_features(${target} PUBLIC cxx_std_20)
  if(NOT DEFINED CMAKE_POSITION_INDEPENDENT_CODE)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON) # so that it can go into a shared library
  endif()
  # Certified answers do not need these flags: a contracted a*b + c has one rounding less than the error bounds count, and
  # error-free transforms stand behind barriers that no compiler sees through. But it rounds differently, and the plain
  # rungs would give other answers. The flags are passed on to users of the headers, because the linker keeps one copy of
  # an inline function, whoever compiled it.
  target_compile_options(${target} PUBLIC
    "$<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>"
    "$<$<COMPILE_LANG_AND_ID:CUDA,NVIDIA>:--fmad=false;-Xcompiler=-ffp-contract=off>"
    "$<$<COMPILE_LANG_AND_ID:CUDA,Clang>:-ffp-contract=off>")
  if(arg_INSTRUCTION_SETS)
    set(compiled ${sources})
    list(FILTER compiled INCLUDE REGEX "/(units|src)/[^/]+[.]cpp$")
    meetc_add_instruction_sets(${target} "${arg_INSTRUCTION_SETS}" "${folder}/${space}/${space}_runtime.cpp" ${compiled})
    if(TARGET ${target}.files)
      foreach(part IN ITEMS "" _avx2 _avx512)
        if(TARGET ${target}${part})
          add_dependencies(${target}${part} ${target}.files)
        endif()
      endforeach()
    endif()
  endif()
  if(cuda)
    # CMake 3.25 does not know CUDA20, and a second -std would be an error. The project chooses the architectures.
    set_property(TARGET ${target} PROPERTY CUDA_STANDARD)
    target_compile_options(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CUDA>:-std=c++20>")
    # This is the runtime that CMake itself links with CUDA code, so that there is only one, even in a C++ project.
    find_package(CUDAToolkit 12 REQUIRED)
    string(TOLOWER "${CMAKE_CUDA_RUNTIME_LIBRARY}" runtime)
    if(runtime STREQUAL "shared")
      target_link_libraries(${target} PUBLIC CUDA::cudart)
    else()
      target_link_libraries(${target} PUBLIC CUDA::cudart_static)
    endif()
  endif()
  set_target_properties(${target} PROPERTIES meetc_folder "${folder}" meetc_cuda ${cuda})
endfunction()

function(meetc_install_kernels target)
  set(me "meetc_install_kernels(${target})")
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "EXPORT;DESTINATION" "")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${me}: unknown: ${arg_UNPARSED_ARGUMENTS}; known: EXPORT, DESTINATION")
  endif()
  if(NOT arg_EXPORT)
    message(FATAL_ERROR "${me}: EXPORT is missing: the export set that the library joins")
  endif()
  set(folder "")
  if(TARGET ${target})
    get_target_property(folder ${target} meetc_folder)
  endif()
  if(NOT folder)
    message(FATAL_ERROR "${me}: no target of meetc_add_kernels has this name")
  endif()
  include(GNUInstallDirs)
  if(NOT arg_DESTINATION)
    # In a separate folder, since another package may bring another version of meetc/support.hpp.
    set(arg_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${target}")
  endif()
  set(leave_out "")
  get_target_property(cuda ${target} meetc_cuda)
  if(NOT cuda) # the scene may emit launchers that this library does not hold
    set(leave_out PATTERN "*_cuda.hpp" EXCLUDE PATTERN "*_every_pair.hpp" EXCLUDE)
  endif()
  install(TARGETS ${target} EXPORT ${arg_EXPORT}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    INCLUDES DESTINATION "${arg_DESTINATION}")
  install(DIRECTORY "${folder}/" DESTINATION "${arg_DESTINATION}" FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h"
    PATTERN "proofs" EXCLUDE ${leave_out})
endfunction()

cmake_policy(POP)
