# Calls that cannot work give the reason in one line.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(errors)
file(COPY "${ALGEBRA}" DESTINATION "${ROOM}/errors")

# refuse(CALL TEXT ...): the call stops the configuration with a message that contains TEXT.
function(refuse call)
  configure_command(command "${ROOM}/errors" "-DMEETC_FUNCTIONS=${SOURCE}/gen/cmake/meetc_add_kernels.cmake"
    "-DCALL=${call}" "-DMEETC_EXECUTABLE=${MEETC_EXECUTABLE}")
  run_to_fail(${command})
  expect(${ARGN})
endfunction()

set(MEETC_EXECUTABLE "${MEETC}")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE cell BACKEND cpp)" "meetc_add_kernels(k): unknown: BACKEND" "BACKENDS")
refuse("meetc_add_kernels(k NAMESPACE cell)" "SCENE is missing")
refuse("meetc_add_kernels(k SCENE scene.toml)" "NAMESPACE is missing")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE cell CHECKED_IN)" "CHECKED_IN has no value")
refuse("meetc_add_kernels(k SCENE other.toml NAMESPACE cell)" "other.toml' is not there")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE a::b)" "'a::b' cannot be the NAMESPACE")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE meetc)" "'meetc' cannot be the NAMESPACE")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE cell BACKENDS opencl)" "no backend 'opencl'; known: cpp, cuda, every_pair, c")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE cell BACKENDS cpp cuda)" "BACKENDS cuda needs the language CUDA; say enable_language(CUDA)")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE cell BACKENDS every_pair)" "BACKENDS every_pair needs the language CUDA")
refuse("meetc_install_kernels(k)" "EXPORT is missing")
refuse("meetc_install_kernels(k EXPORT set)" "no target of meetc_add_kernels")
set(MEETC_EXECUTABLE "${ROOM}/none")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE cell)" "none', which is not there")
set(MEETC_EXECUTABLE "")
refuse("meetc_add_kernels(k SCENE scene.toml NAMESPACE cell)" "there is no meetc: say find_package(meetc" "CHECKED_IN")

# Errors that only meetc can find are reported at build time.
run_to_fail("${MEETC}" generate "${ROOM}/errors/scene.toml" -o "${ROOM}/out" --namespace class)
expect("'class' cannot be the namespace")
run_to_fail("${MEETC}" generate "${ROOM}/errors/scene.toml" -o "${ROOM}/out" --require-backend cuda)
expect("scene.backends does not list it")
if(EXISTS "${ROOM}/out")
  fail("something was written")
endif()
