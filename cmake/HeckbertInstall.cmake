# Installs the package files that let another project write find_package(heckbert COMPONENTS taxonomy ...).

include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/heckbert")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/heckbert-config.cmake.in"
  "${PROJECT_BINARY_DIR}/heckbert-config.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/heckbert-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/heckbert-config.cmake" "${PROJECT_BINARY_DIR}/heckbert-config-version.cmake"
  DESTINATION "${package_dir}" COMPONENT taxonomy)
