# preshape_add_plugin(KIND <kind> NAME <name> SOURCES <file>... [LIBRARIES <target>...] [TESTS <file>...])
#
# Builds one plugin library, target preshape_<kind>_<name>, file <kind>/<name>.so. It owns the flags that keep a
# plugin and its host compatible: hidden visibility, one exported symbol, every symbol bound at load, the pinned
# Eigen alignment (through preshape::core), no fast-math. TESTS are the sources of a program that ctest runs with the
# folder of the plugin as its argument.
set(PRESHAPE_PLUGIN_MAP ${CMAKE_CURRENT_LIST_DIR}/preshape_plugin.map)

macro(preshape_add_plugin)
  if("${ARGN}" MATCHES "(^|;)TESTS;")
    enable_testing()  # in the caller's folder, where ctest looks: hence a macro
  endif()
  preshape_build_plugin(${ARGN})
endmacro()

function(preshape_build_plugin)
  cmake_parse_arguments(P "" "KIND;NAME" "SOURCES;LIBRARIES;TESTS" ${ARGN})
  if(NOT P_KIND OR NOT P_NAME OR NOT P_SOURCES)
    message(FATAL_ERROR "preshape_add_plugin needs KIND, NAME and SOURCES")
  endif()
  set(target preshape_${P_KIND}_${P_NAME})
  add_library(${target} MODULE ${P_SOURCES})
  set_target_properties(${target} PROPERTIES
    PREFIX "" OUTPUT_NAME ${P_NAME}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/preshape/plugins/${P_KIND}
    # No folder of this machine gets into it; the host has the core loaded in any case.
    BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "$ORIGIN/../../..")
  target_link_libraries(${target} PRIVATE preshape::core ${P_LIBRARIES})
  target_compile_options(${target} PRIVATE -fno-fast-math)
  target_link_options(${target} PRIVATE
    "LINKER:--version-script=${PRESHAPE_PLUGIN_MAP}" "LINKER:-z,now")
  if(NOT PRESHAPE_SANITIZE)
    target_link_options(${target} PRIVATE "LINKER:-z,defs")
  endif()
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${PRESHAPE_PLUGIN_MAP})
  if(COMMAND preshape_warnings)
    preshape_warnings(${target})
    set_property(GLOBAL APPEND PROPERTY PRESHAPE_PLUGINS ${target})
    install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/preshape/plugins/${P_KIND})
  endif()
  if(P_TESTS)
    add_executable(${target}_test ${P_TESTS})
    target_link_libraries(${target}_test PRIVATE preshape::core)
    add_dependencies(${target}_test ${target})
    add_test(NAME ${target} COMMAND ${target}_test $<TARGET_FILE_DIR:${target}>)
  endif()
endfunction()

# preshape_add_conformance_test(KIND <kind> NAME <name> [OPTIONS <option>...])
#
# Registers with ctest a run of preshape's conformance suite on a plugin that preshape_add_plugin builds. OPTIONS are
# those of `preshape conform`, such as --tier quick.
macro(preshape_add_conformance_test)
  enable_testing()  # in the caller's folder, where ctest looks: hence a macro
  preshape_register_conformance_test(${ARGN})
endmacro()

function(preshape_register_conformance_test)
  cmake_parse_arguments(P "" "KIND;NAME" "OPTIONS" ${ARGN})
  if(NOT P_KIND OR NOT P_NAME)
    message(FATAL_ERROR "preshape_add_conformance_test needs KIND and NAME")
  endif()
  set(target preshape_${P_KIND}_${P_NAME})
  if(NOT TARGET ${target})
    message(FATAL_ERROR "preshape_add_conformance_test: there is no plugin ${P_KIND} ${P_NAME}; "
      "call preshape_add_plugin(KIND ${P_KIND} NAME ${P_NAME} ...) before it")
  endif()
  add_test(NAME ${target}_conformance
    COMMAND preshape::command conform $<TARGET_FILE:${target}> ${P_OPTIONS})
endfunction()
