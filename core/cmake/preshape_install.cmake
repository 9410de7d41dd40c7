# Installation: the library, its headers, the command and the packages that find them (find_package(preshape),
# pkg-config preshape). Every path in them is relative, so an installation can be moved as a whole.
include(CMakePackageConfigHelpers)

install(TARGETS preshape_core preshape_command EXPORT preshape_targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
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

file(RELATIVE_PATH PRESHAPE_PC_PREFIX /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" PRESHAPE_PC_PREFIX "${PRESHAPE_PC_PREFIX}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/preshape.pc.in ${PROJECT_BINARY_DIR}/cmake/preshape.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cmake/preshape.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
