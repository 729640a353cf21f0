# The packages that `cpack` makes in a build: an archive of all, and for Debian `meetc` (the programs), `libmeetc-dev`, and
# `python3-meetc` where MEETC_BUILD_PYTHON is on. gen/cmake/package.cmake includes this file after its install rules.
set(CPACK_PACKAGE_NAME meetc)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_VENDOR "The meetc authors")
set(CPACK_PACKAGE_CONTACT "The meetc authors <none@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Exact collisions of meshes, and a compiler of geometric algebra")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGE_DIRECTORY packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

# The groups' names are those of the packages; CPack asks for them in capitals.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME meetc)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmeetc-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "meetc (= ${PROJECT_VERSION}), libfmt-dev")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-meetc)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)

set(CPACK_COMPONENTS_ALL meetc_program meetc_generator meetc_runtime meetc_config meetc_pages)
set(python_files "")
if(TARGET meetc_python)
  list(APPEND CPACK_COMPONENTS_ALL meetc_debian_python)
  # A module belongs to one version of Python, whose variables are those of the folder that found it.
  find_package(Python REQUIRED COMPONENTS Interpreter)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(python "lib/python3/dist-packages/meetc")
  install(TARGETS meetc_python LIBRARY DESTINATION ${python} COMPONENT meetc_debian_python EXCLUDE_FROM_ALL)
  get_property(files GLOBAL PROPERTY MEETC_PYTHON_FILES)
  install(FILES ${files} DESTINATION ${python} COMPONENT meetc_debian_python EXCLUDE_FROM_ALL)
endif()

# Pages of the manual are made of what the programs say of themselves.
find_program(MEETC_HELP2MAN help2man)
if(TARGET meet AND TARGET meetc AND MEETC_HELP2MAN)
  set(pages ${PROJECT_BINARY_DIR}/package/man)
  add_custom_command(OUTPUT ${pages}/meet.1
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/man_pages.sh ${MEETC_HELP2MAN} $<TARGET_FILE:meet> $<TARGET_FILE:meetc> ${pages}
    DEPENDS meet meetc ${CMAKE_CURRENT_LIST_DIR}/man_pages.sh VERBATIM)
  add_custom_target(meetc_man_pages ALL DEPENDS ${pages}/meet.1)
  install(DIRECTORY ${pages}/ DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT meetc_pages FILES_MATCHING PATTERN "*.1")
endif()
foreach(program meet meetc)
  if(TARGET ${program})
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/completion.bash RENAME ${program}
      DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT meetc_pages)
  endif()
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/meetc" COMPONENT meetc_pages)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/meetc"
  COMPONENT meetc_pages)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/meetc" COMPONENT meetc_pages
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "examples/*" PATTERN "packaging" EXCLUDE)

include(CPack)
cpack_add_component_group(programs DESCRIPTION "meet collides files of meshes, segments and spheres, exactly.
 meetc generates kernels of geometric algebra, with proved error bounds.")
cpack_add_component_group(development DESCRIPTION "Headers and static libraries of meetc: exact predicates and collisions.")
cpack_add_component_group(python DESCRIPTION "Exact collisions of meshes in Python.")
foreach(component meetc_program meetc_generator meetc_pages)
  cpack_add_component(${component} GROUP programs)
endforeach()
foreach(component meetc_runtime meetc_config)
  cpack_add_component(${component} GROUP development)
endforeach()
cpack_add_component(meetc_debian_python GROUP python DISABLED)
