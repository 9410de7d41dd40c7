# Everything that the core needs, found once. Plugins find what they alone need.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(TBB REQUIRED)
find_package(PNG REQUIRED)
# Lua's C++ build: an error unwinds destructors.
pkg_search_module(LUA REQUIRED IMPORTED_TARGET lua5.4-c++ lua5.4)
pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
if(PRESHAPE_BUILD_TESTS)
  find_package(doctest REQUIRED)
endif()
find_program(CCACHE ccache)
if(CCACHE)
  # The sloppiness lets it keep objects built with precompiled headers; the base directory lets checkouts share.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
  add_compile_options(-fpch-preprocess)
endif()
