# The installed package: find_package(pcl_rgbd_planes) and pkg-config.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_rgbd_planes)
configure_package_config_file(
  cmake/pcl_rgbd_planesConfig.cmake.in ${PROJECT_BINARY_DIR}/pcl_rgbd_planesConfig.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pcl_rgbd_planesConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pcl_rgbd_planesConfig.cmake
              ${PROJECT_BINARY_DIR}/pcl_rgbd_planesConfigVersion.cmake
        DESTINATION ${config_dir} COMPONENT development)
install(EXPORT pcl_rgbd_planesTargets NAMESPACE pcl_rgbd_planes:: DESTINATION ${config_dir}
        COMPONENT development)

# Who gets the library gets its licence. CMAKE_INSTALL_DOCDIR is that of the project around it.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${PROJECT_NAME}
        COMPONENT runtime)
# Links between these stay as they are.
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
        DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${PROJECT_NAME} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc
        DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${PROJECT_NAME} COMPONENT development
        REGEX "/doc/(CMakeLists.txt|Doxyfile.in|main_page.dox)$" EXCLUDE)

file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
set(pc_includedir ${CMAKE_INSTALL_INCLUDEDIR})
if(NOT IS_ABSOLUTE ${CMAKE_INSTALL_INCLUDEDIR})
  string(PREPEND pc_includedir "\${prefix}/")
endif()
if(NOT BUILD_SHARED_LIBS)
  set(pc_static_libs " -lhwy ${OpenMP_CXX_FLAGS}") # in Libs: there are no shared libraries to take
endif()
configure_file(cmake/pcl_rgbd_planes.pc.in ${PROJECT_BINARY_DIR}/pcl_rgbd_planes.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/pcl_rgbd_planes.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
