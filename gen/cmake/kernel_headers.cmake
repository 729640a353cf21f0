# The kernel headers: MEETC_KERNEL_HEADER_FILES. meetc packs them, and an install has them.
#
# A build knows beforehand of support.hpp alone that meetc writes it (meetc_add_kernels.cmake). A line with the content of all
# of them makes it change whenever one does, so that a build compiles what includes them in the same run.
block(PROPAGATE MEETC_KERNEL_HEADER_FILES)
  set(folder ${PROJECT_SOURCE_DIR}/runtime/kernel/meetc)
  file(GLOB MEETC_KERNEL_HEADER_FILES ${folder}/*.hpp ${folder}/every_pair/*.hpp)
  # A folder is newer than what was configured from it when a file has come or gone.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder} ${folder}/every_pair
    ${MEETC_KERNEL_HEADER_FILES})
  set(all "")
  foreach(header IN LISTS MEETC_KERNEL_HEADER_FILES)
    file(READ ${header} text)
    string(APPEND all "${text}")
  endforeach()
  string(SHA256 content "${all}")
  string(SUBSTRING ${content} 0 16 content)
  file(READ ${PROJECT_SOURCE_DIR}/runtime/kernel/meetc/support.hpp text)
  set(support ${PROJECT_BINARY_DIR}/kernel_headers/support.hpp)
  file(CONFIGURE OUTPUT ${support} @ONLY
    CONTENT "${text}// The headers in this folder have the content ${content}.\n")
  list(REMOVE_ITEM MEETC_KERNEL_HEADER_FILES ${PROJECT_SOURCE_DIR}/runtime/kernel/meetc/support.hpp)
  list(APPEND MEETC_KERNEL_HEADER_FILES ${support})
endblock()
