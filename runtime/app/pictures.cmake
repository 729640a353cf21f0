# The built-in meshes and the pictures of `meet`.
find_package(PNG REQUIRED)

add_library(meet_pictures STATIC
  ${CMAKE_CURRENT_LIST_DIR}/meshes.cpp
  ${CMAKE_CURRENT_LIST_DIR}/meshes.implicit.cpp
  ${CMAKE_CURRENT_LIST_DIR}/picture.cpp
  ${CMAKE_CURRENT_LIST_DIR}/picture_camera.cpp
  ${CMAKE_CURRENT_LIST_DIR}/picture_panels.cpp
  ${CMAKE_CURRENT_LIST_DIR}/picture_png.cpp
  ${CMAKE_CURRENT_LIST_DIR}/picture_raster.cpp
  ${CMAKE_CURRENT_LIST_DIR}/picture_text.cpp)
target_include_directories(meet_pictures PUBLIC ${CMAKE_CURRENT_LIST_DIR}/..) # "app/picture.hpp"
target_compile_features(meet_pictures PUBLIC cxx_std_20)
target_link_libraries(meet_pictures PRIVATE PNG::PNG meetc_flags)
