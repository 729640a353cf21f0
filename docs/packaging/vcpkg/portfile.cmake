# vcpkg install meetc --overlay-ports=docs/packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
vcpkg_check_features(OUT_FEATURE_OPTIONS OPTIONS_OF_FEATURES FEATURES programs MEETC_BUILD_GENERATOR programs MEETC_BUILD_PROGRAM)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${OPTIONS_OF_FEATURES} -DMEETC_CUDA=OFF -DMEETC_BUILD_TESTS=OFF -DMEETC_INSTALL=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/meetc)
if("programs" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES meet meetc AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
