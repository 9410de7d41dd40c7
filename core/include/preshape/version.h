#pragma once
/// Version of the library and of the SDK (plugins of the same major and an equal or older minor load).
/// CMake reads the three numbers from this file.
#define PRESHAPE_VERSION_MAJOR 0
#define PRESHAPE_VERSION_MINOR 1
#define PRESHAPE_VERSION_PATCH 0
#define PRESHAPE_VERSION_STRING "0.1.0"
