# Installs the main build and then moves the result, so that all other tests use a relocated package.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")

file(REMOVE_RECURSE "${PREFIX}" "${RUNTIME_PREFIX}")
run(${CMAKE_COMMAND} --install "${BUILD}" --config "${CONFIG}" --prefix "${PREFIX}.first")
file(RENAME "${PREFIX}.first" "${PREFIX}")
foreach(component meetc_runtime meetc_config)
  run(${CMAKE_COMMAND} --install "${BUILD}" --config "${CONFIG}" --component ${component} --prefix "${RUNTIME_PREFIX}.first")
endforeach()
file(RENAME "${RUNTIME_PREFIX}.first" "${RUNTIME_PREFIX}")

# No package file may contain the path of the build or of the first installation.
file(GLOB_RECURSE files "${PREFIX}/${LIBDIR}/cmake/*" "${PREFIX}/include/*")
foreach(file IN LISTS files)
  file(READ "${file}" OUTPUT)
  expect_none("${SOURCE}" "${BUILD}" "${PREFIX}")
endforeach()

run("${MEETC}" --version)
expect("meetc ${VERSION}")
foreach(file IN ITEMS bin/meetc "${DATADIR}/meetc" "${LIBDIR}/cmake/meetc/meetc_generator_targets.cmake")
  if(NOT EXISTS "${PREFIX}/${file}")
    fail("not installed: ${file}")
  elseif(EXISTS "${RUNTIME_PREFIX}/${file}")
    fail("not of the runtime: ${file}")
  endif()
endforeach()
