# Installation: the library, its headers and the package that finds them (find_package(preshape)).
include(CMakePackageConfigHelpers)

install(TARGETS preshape_core EXPORT preshape_targets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/preshape DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_BINARY_DIR}/core/include/preshape DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT preshape_targets NAMESPACE preshape:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/preshape)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/preshape-config.cmake.in
  ${PROJECT_BINARY_DIR}/cmake/preshape-config.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/preshape)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/preshape-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/cmake/preshape-config.cmake
  ${PROJECT_BINARY_DIR}/cmake/preshape-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/preshape_plugin.cmake
  ${CMAKE_CURRENT_LIST_DIR}/preshape_plugin.map
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/preshape)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
