# The target names for users, and the files that `cmake --install` installs. The top CMakeLists.txt includes this file
# after all targets exist.
#
# Install components: meetc_generator (the program, the algebras), meetc_runtime (libraries and their headers), meetc_program
# (meet), and meetc_config, which find_package reads for either of the first two.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

if(TARGET meetc)
  add_executable(meetc::meetc ALIAS meetc)
endif()
if(TARGET meet_core)
  add_library(meet_runtime INTERFACE)
  target_link_libraries(meet_runtime INTERFACE meet_core)
  add_library(meet::kernel ALIAS meet_kernel)
  add_library(meet::core ALIAS meet_core)
  add_library(meet::runtime ALIAS meet_runtime)
endif()
if(TARGET meet_kernels)
  add_library(meet::kernels ALIAS meet_kernels)
endif()
if(TARGET meet_kernels_cuda)
  add_library(meet::kernels_cuda ALIAS meet_kernels_cuda)
  add_library(meet::neighbours_cuda ALIAS meet_neighbours_cuda)
endif()
if(TARGET meet_io)
  add_library(meet::io ALIAS meet_io)
endif()
if(TARGET meet_device)
  add_library(meet::device ALIAS meet_device)
endif()
# Where a project with meetc as a subfolder finds the algebras. The config file of the package sets it as well.
set(MEETC_ALGEBRA_DIR "${PROJECT_SOURCE_DIR}/algebra_spec" CACHE INTERNAL "Folder of the algebras that come with meetc")

# The headers for users, below runtime/. Headers that only others of the runtime include are not installed.
set(MEETC_CORE_HEADERS answers/answers.hpp query/ask.hpp query/chunks.hpp query/collide.hpp query/evaluate.hpp query/find.hpp
  query/pairs.hpp sets/moving_set.hpp sets/prepared.hpp threads/cancelled.hpp threads/execution.hpp views/check.hpp
  views/memory.hpp views/pose.hpp views/status.hpp views/usage_error.hpp views/view.hpp)
set(MEETC_WORLD_HEADERS contacts/contacts.hpp query/fitting.hpp query/self_pairs.hpp world/world.hpp)
set(MEETC_FRONT_HEADERS front/rounded.hpp front/row_of.hpp front/rows.hpp meet.hpp)
set(MEETC_DEVICE_HEADERS answers/device_result.hpp collide.hpp contacts.hpp evaluate.hpp every_pair/engine.hpp group.hpp
  memory/device.hpp memory/memory.hpp self_pairs.hpp set/device_set.hpp set/fours.hpp set/given.hpp set/rows.hpp
  set/tree.hpp world.hpp)
set(MEETC_IO_HEADERS elements/element_set.hpp elements/transform.hpp files/atomic_file.hpp files/error.hpp read.hpp
  text/rounded.hpp write.hpp)

option(MEETC_INSTALL "Make install rules for meetc" ${PROJECT_IS_TOP_LEVEL})
if(NOT MEETC_INSTALL)
  return()
endif()

set(MEETC_INSTALL_CMAKE "${CMAKE_INSTALL_LIBDIR}/cmake/meetc")
set(MEETC_INSTALL_ALGEBRA "${CMAKE_INSTALL_DATADIR}/meetc/algebra_spec")
# All headers are below one folder, which has four: the kernels' are <meetc/...>, the runtime's <meet/...>, and the shipped
# predicates' <cga/...> and <neighbours/...>.
set(MEETC_INSTALL_HEADERS "${CMAKE_INSTALL_INCLUDEDIR}/meetc")

# meetc_install_headers(FROM TO NAME ...): headers below the folder FROM, into the folder TO.
function(meetc_install_headers from to)
  foreach(name IN LISTS ARGN)
    cmake_path(GET name PARENT_PATH folder)
    install(FILES "${from}/${name}" DESTINATION "${MEETC_INSTALL_HEADERS}/${to}/${folder}" COMPONENT meetc_runtime)
  endforeach()
endfunction()

if(TARGET meetc)
  install(TARGETS meetc EXPORT meetc_generator_targets
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT meetc_generator)
  install(EXPORT meetc_generator_targets NAMESPACE meetc::
    DESTINATION "${MEETC_INSTALL_CMAKE}" COMPONENT meetc_generator)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/algebra_spec/"
    DESTINATION "${MEETC_INSTALL_ALGEBRA}" COMPONENT meetc_generator)
endif()

if(TARGET meet_core)
  set_target_properties(meet_core PROPERTIES EXPORT_NAME core)
  set_target_properties(meet_runtime PROPERTIES EXPORT_NAME runtime)
  set_target_properties(meet_kernel PROPERTIES EXPORT_NAME kernel)
  install(TARGETS meet_core meet_kernel meet_runtime EXPORT meetc_runtime_targets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT meetc_runtime
    INCLUDES DESTINATION "${MEETC_INSTALL_HEADERS}")
  install(EXPORT meetc_runtime_targets NAMESPACE meet::
    DESTINATION "${MEETC_INSTALL_CMAKE}" COMPONENT meetc_runtime)
  set(rooms ${MEETC_KERNEL_HEADERS})
  list(REMOVE_ITEM rooms environment/version.hpp)
  meetc_install_headers("${MEETC_KERNEL_FOLDER}" meetc ${rooms})
  install(FILES "${MEETC_VERSION_HEADER}" DESTINATION "${MEETC_INSTALL_HEADERS}/meetc/environment" COMPONENT meetc_runtime)
  meetc_install_headers("${PROJECT_SOURCE_DIR}/runtime/core" meet/core ${MEETC_CORE_HEADERS} ${MEETC_WORLD_HEADERS})
endif()

# The predicates of the shipped scenes, compiled: the namespace cga, by <cga/cga.hpp> and <cga/cga_runtime.hpp>, and those of
# neighbours in a mesh by <neighbours/neighbours_runtime.hpp>.
if(TARGET meet_core AND TARGET meet_kernels)
  set_target_properties(meet_kernels PROPERTIES EXPORT_NAME kernels)
  set_target_properties(meet_neighbours PROPERTIES EXPORT_NAME neighbours)
  install(TARGETS meet_kernels meet_neighbours EXPORT meetc_runtime_targets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT meetc_runtime
    INCLUDES DESTINATION "${MEETC_INSTALL_HEADERS}")
  set(launchers "")
  if(NOT TARGET meet_kernels_cuda) # the headers of launchers that no installed library holds
    set(launchers PATTERN "*_cuda.hpp" EXCLUDE PATTERN "*_every_pair.hpp" EXCLUDE)
  endif()
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/generated/default/cga" "${PROJECT_SOURCE_DIR}/generated/neighbours/neighbours"
    DESTINATION "${MEETC_INSTALL_HEADERS}" COMPONENT meetc_runtime FILES_MATCHING PATTERN "*.hpp"
    PATTERN "proofs" EXCLUDE ${launchers})
  meetc_install_headers("${PROJECT_SOURCE_DIR}/runtime" meet ${MEETC_FRONT_HEADERS})
endif()

# A separate export set, so that the runtime is found without fmt.
if(TARGET meet_io)
  set_target_properties(meet_io PROPERTIES EXPORT_NAME io)
  install(TARGETS meet_io EXPORT meetc_io_targets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT meetc_runtime
    INCLUDES DESTINATION "${MEETC_INSTALL_HEADERS}")
  install(EXPORT meetc_io_targets NAMESPACE meet::
    DESTINATION "${MEETC_INSTALL_CMAKE}" COMPONENT meetc_runtime)
  meetc_install_headers("${PROJECT_SOURCE_DIR}/runtime/io" meet/io ${MEETC_IO_HEADERS})
endif()

# A separate export set, so that the runtime is found without CUDA.
if(TARGET meet_device)
  set_target_properties(meet_device PROPERTIES EXPORT_NAME device)
  set(libraries meet_device)
  if(TARGET meet_kernels_cuda)
    set_target_properties(meet_kernels_cuda PROPERTIES EXPORT_NAME kernels_cuda)
    set_target_properties(meet_neighbours_cuda PROPERTIES EXPORT_NAME neighbours_cuda)
    list(APPEND libraries meet_kernels_cuda meet_neighbours_cuda)
  endif()
  install(TARGETS ${libraries} EXPORT meetc_device_targets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT meetc_runtime
    INCLUDES DESTINATION "${MEETC_INSTALL_HEADERS}")
  meetc_install_headers("${PROJECT_SOURCE_DIR}/runtime/core/device" meet/core/device ${MEETC_DEVICE_HEADERS})
  install(EXPORT meetc_device_targets NAMESPACE meet::
    DESTINATION "${MEETC_INSTALL_CMAKE}" COMPONENT meetc_runtime)
endif()

if(TARGET meet)
  install(TARGETS meet RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT meetc_program)
endif()

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/meetcConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/package/meetcConfig.cmake"
  INSTALL_DESTINATION "${MEETC_INSTALL_CMAKE}")
# Below 1.0 a new minor version may change anything.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/package/meetcConfigVersion.cmake"
  VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/package/meetcConfig.cmake" "${PROJECT_BINARY_DIR}/package/meetcConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/meetc_add_kernels.cmake" "${CMAKE_CURRENT_LIST_DIR}/instruction_sets.cmake"
  DESTINATION "${MEETC_INSTALL_CMAKE}" COMPONENT meetc_config)

# For projects without CMake: `pkg-config --cflags --libs meetc`, of whatever is installed, with fmt for the readers.
if(TARGET meet_core)
  set(MEETC_PC_LIBRARIES -lmeet_core)
  if(TARGET meet_kernels)
    string(PREPEND MEETC_PC_LIBRARIES "-lmeet_kernels -lmeet_neighbours ")
  endif()
  if(TARGET meet_io)
    string(PREPEND MEETC_PC_LIBRARIES "-lmeet_io ")
    string(APPEND MEETC_PC_LIBRARIES " -lfmt")
  endif()
  set(MEETC_PC_FOLDER "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
  file(RELATIVE_PATH MEETC_PC_TO_PREFIX "/${MEETC_PC_FOLDER}" "/")
  string(REGEX REPLACE "/$" "" MEETC_PC_TO_PREFIX "${MEETC_PC_TO_PREFIX}")
  configure_file("${CMAKE_CURRENT_LIST_DIR}/meetc.pc.in" "${PROJECT_BINARY_DIR}/package/meetc.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/package/meetc.pc" DESTINATION "${MEETC_PC_FOLDER}" COMPONENT meetc_config)
endif()

if(PROJECT_IS_TOP_LEVEL)
  include("${CMAKE_CURRENT_LIST_DIR}/packages.cmake")
endif()
