# The CUDA backend, compiled and linked. Where there is a GPU, the engine tests itself on it, by way of PTX on a newer one.
include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")
fresh_room(cuda cuda_third)
get_filename_component(toolkit "${NVCC}" DIRECTORY)

configure("${ROOM}/cuda" "-DCMAKE_PREFIX_PATH=${PREFIX}" "-DCMAKE_CUDA_COMPILER=${NVCC}" -DCMAKE_CUDA_ARCHITECTURES=80
  -DCMAKE_CUDA_FLAGS=-Werror=all-warnings -DCMAKE_CUDA_STANDARD=17 -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
build("${ROOM}/cuda")
run("${ROOM}/cuda-build/app")
expect("launcher 0, hit 1")
run("${ROOM}/cuda-build/engine")
expect("device: " "memory: CUDA: asking for memory: ")
file(READ "${ROOM}/cuda-build/compile_commands.json" OUTPUT)
expect("--fmad=false" "sm_80")
expect_none("sm_90" "std=c++17")
build("${ROOM}/cuda")
expect_none("Generating" "Building")

# The headers in a user's kernel.
run("${NVCC}" -std=c++20 -arch=sm_80 --Werror all-warnings "-I${ROOM}/cuda-build/robot_cell.generated"
  -c "${ROOM}/cuda/kernel.cu" -o "${ROOM}/kernel.o")

# Installed and exported; the third project uses only C++.
run(${CMAKE_COMMAND} --install "${ROOM}/cuda-build" --prefix "${ROOM}/installed")
configure("${ROOM}/cuda_third" "-DCMAKE_PREFIX_PATH=${ROOM}/installed" "-DCUDAToolkit_ROOT=${toolkit}/..")
build("${ROOM}/cuda_third")
run("${ROOM}/cuda_third-build/third")
expect("launcher 0, hit 1")
