# cpack -G DEB: the library, what it takes to build with it, and the applications.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the pcl_rgbd_planes authors")
set(CPACK_PACKAGE_VENDOR "the pcl_rgbd_planes authors")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

# The packages of the shared libraries that the files need, found by dpkg-shlibdeps.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
    ${PROJECT_BINARY_DIR}/features ${PROJECT_BINARY_DIR}/filters
    ${PROJECT_BINARY_DIR}/segmentation)

set(runtime_package libpcl-rgbd-planes${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(same_version "${runtime_package} (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME ${runtime_package})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}: the shared libraries.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpcl-rgbd-planes-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# libopenmpi-dev: VTK's CMake files look for it.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "${same_version}, libpcl-dev (>= 1.12), libopenmpi-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "${PROJECT_DESCRIPTION}: headers, CMake package and pkg-config file.")
if(PCL_RGBD_PLANES_BUILD_APPS)
  list(APPEND CPACK_COMPONENTS_ALL applications)
  set(CPACK_DEBIAN_APPLICATIONS_PACKAGE_NAME pcl-rgbd-planes-apps)
  set(CPACK_DEBIAN_APPLICATIONS_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_APPLICATIONS_PACKAGE_DEPENDS "${same_version}")
  # pcl_plane_viewer --screenshot without a display
  set(CPACK_DEBIAN_APPLICATIONS_PACKAGE_SUGGESTS xvfb)
  set(CPACK_COMPONENT_APPLICATIONS_DESCRIPTION
      "${PROJECT_DESCRIPTION}: command-line applications.")
endif()
include(CPack)
