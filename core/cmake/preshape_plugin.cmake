# preshape_add_plugin(KIND <kind> NAME <name> SOURCES <file>... [LIBRARIES <target>...])
#
# Builds one plugin library, target preshape_<kind>_<name>, file <kind>/<name>.so. It owns the flags that keep a
# plugin and its host compatible: hidden visibility, one exported symbol, every symbol bound at load, the pinned
# Eigen alignment (through preshape::core), no fast-math.
set(PRESHAPE_PLUGIN_MAP ${CMAKE_CURRENT_LIST_DIR}/preshape_plugin.map)

function(preshape_add_plugin)
  cmake_parse_arguments(P "" "KIND;NAME" "SOURCES;LIBRARIES" ${ARGN})
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
    install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/preshape/plugins/${P_KIND})
  endif()
endfunction()
