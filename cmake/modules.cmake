# Warnings for every target of this project, and the recipe of its library modules.

add_library(pcl_rgbd_planes_warnings INTERFACE)
target_compile_options(pcl_rgbd_planes_warnings INTERFACE
  -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Wunused
  $<$<BOOL:${PCL_RGBD_PLANES_WARNINGS_AS_ERRORS}>:-Werror>)

# pcl_rgbd_planes_add_module(NAME SOURCES... LINK targets...): the library pcl_rgbd_planes_NAME,
# static with BUILD_SHARED_LIBS=OFF, with the alias pcl_rgbd_planes::NAME and headers under include/.
function(pcl_rgbd_planes_add_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  set(target pcl_rgbd_planes_${name})
  add_library(${target} ${arg_SOURCES})
  add_library(pcl_rgbd_planes::${name} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_definitions(${target} PRIVATE
    $<$<BOOL:${PCL_RGBD_PLANES_ONLY_CORE_POINT_TYPES}>:PCL_RGBD_PLANES_ONLY_CORE_POINT_TYPES>)
  # Nobody replaces functions of the library from outside: those in one file can be inlined.
  target_compile_options(${target} PRIVATE
    -fno-semantic-interposition ${PCL_RGBD_PLANES_LIBRARY_OPTIONS})
  target_link_options(${target} PRIVATE ${PCL_RGBD_PLANES_LIBRARY_OPTIONS})
  target_link_libraries(${target} PUBLIC ${arg_LINK}
                        PRIVATE $<BUILD_INTERFACE:pcl_rgbd_planes_warnings>)
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    CXX_EXTENSIONS OFF
    # Static libraries as well: they may end up in shared ones.
    POSITION_INDEPENDENT_CODE ON
    # The modules find each other wherever they are installed.
    INSTALL_RPATH "$ORIGIN"
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(TARGETS ${target} EXPORT pcl_rgbd_planesTargets
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
                  COMPONENT runtime NAMELINK_COMPONENT development
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endfunction()
