#pragma once
/// Version of the library and of the SDK (plugins of the same major and an equal or older minor load).
/// CMake reads the three numbers from this file.
#define PRESHAPE_VERSION_MAJOR 0
#define PRESHAPE_VERSION_MINOR 1
#define PRESHAPE_VERSION_PATCH 0
#define PRESHAPE_VERSION_STRING "0.1.0"

/// The version as one number that grows with it: 10000 * major + 100 * minor + patch. For the preprocessor.
#define PRESHAPE_VERSION_NUMBER \
  (PRESHAPE_VERSION_MAJOR * 10000 + PRESHAPE_VERSION_MINOR * 100 + PRESHAPE_VERSION_PATCH)
/// Whether this SDK is of that version or a later one: `#if PRESHAPE_VERSION_AT_LEAST(0, 2, 0)`.
#define PRESHAPE_VERSION_AT_LEAST(major, minor, patch) \
  (PRESHAPE_VERSION_NUMBER >= (major) * 10000 + (minor) * 100 + (patch))
