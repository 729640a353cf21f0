# The kernel headers: MEETC_KERNEL_HEADERS, their names below meetc/, and the file of each, by meetc_kernel_header(). meetc
# packs them, and an install has them.
#
# A build knows beforehand of version.hpp alone that meetc writes it (meetc_add_kernels.cmake); support.hpp and every emitted
# header include it. A line with the content of all of them makes it change whenever one does, so that a build compiles what
# includes them in the same run.
set(MEETC_KERNEL_FOLDER ${PROJECT_SOURCE_DIR}/runtime/kernel/meetc)
set(MEETC_VERSION_HEADER ${PROJECT_BINARY_DIR}/kernel_headers/version.hpp)

# meetc_kernel_header(OUT NAME): the file with the header of that name, as "decide/exact.hpp".
function(meetc_kernel_header out name)
  set(${out} ${MEETC_KERNEL_FOLDER}/${name} PARENT_SCOPE)
  if(name STREQUAL "environment/version.hpp")
    set(${out} ${MEETC_VERSION_HEADER} PARENT_SCOPE)
  endif()
endfunction()

block(PROPAGATE MEETC_KERNEL_HEADERS)
  # A folder is newer than what was configured from it when a file has come or gone.
  file(GLOB_RECURSE MEETC_KERNEL_HEADERS LIST_DIRECTORIES true RELATIVE ${MEETC_KERNEL_FOLDER} ${MEETC_KERNEL_FOLDER}/*)
  list(TRANSFORM MEETC_KERNEL_HEADERS PREPEND ${MEETC_KERNEL_FOLDER}/ OUTPUT_VARIABLE read)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${MEETC_KERNEL_FOLDER} ${read})
  list(FILTER MEETC_KERNEL_HEADERS INCLUDE REGEX "[.]hpp$")
  set(all "")
  foreach(name IN LISTS MEETC_KERNEL_HEADERS)
    file(READ ${MEETC_KERNEL_FOLDER}/${name} text)
    string(APPEND all "${text}")
  endforeach()
  string(SHA256 content "${all}")
  string(SUBSTRING ${content} 0 16 content)
  file(READ ${MEETC_KERNEL_FOLDER}/environment/version.hpp text)
  file(CONFIGURE OUTPUT ${MEETC_VERSION_HEADER} @ONLY
    CONTENT "${text}// The headers in this folder have the content ${content}.\n")
endblock()
