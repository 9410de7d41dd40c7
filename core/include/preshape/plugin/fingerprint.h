#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/plugin/interface_hash.h"
#include "preshape/spatial/pose.h"
#include "preshape/spatial/wrench.h"
#include "preshape/version.h"

namespace preshape {

/// What two separately built binaries must agree on before one may call the other. Numbers only, no pointers:
/// it is read from a plugin's file before any of the plugin's code runs. Append only.
struct Fingerprint {
  std::uint32_t sdk_major, sdk_minor;
  std::uint32_t interface_hash_low, interface_hash_high;  ///< of the interface headers
  std::uint32_t probe_size, probe_alignment;              ///< of a struct with one of each boundary type
  std::uint32_t gxx_abi, cxx11_abi, glibcxx_debug, rtti, exceptions;
  std::uint32_t eigen_version, eigen_max_align, eigen_static_align, eigen_malloc_aligned, eigen_index_size;
  std::uint32_t instruction_set;  ///< bit 0 AVX, 1 AVX2, 2 FMA, 3 AVX-512F
  std::uint32_t fast_math, sanitizer;
  std::uint32_t compiler, cplusplus, ndebug;  ///< told, not compared
};

namespace detail {

/// One of each type that crosses the boundary.
struct BoundaryProbe {
  std::string text;
  std::vector<double> numbers;
  std::span<const double> view;
  std::shared_ptr<int> shared;
  Eigen::Vector3d vector;
  Eigen::Matrix3d matrix;
  Eigen::MatrixXd dynamic;
  Pose pose;
  Wrench wrench;
};

constexpr std::uint32_t sanitizer_bits() {
  std::uint32_t bits = 0;
#if defined(__SANITIZE_ADDRESS__)
  bits |= 1u;
#endif
#if defined(__SANITIZE_THREAD__)
  bits |= 2u;
#endif
  return bits;
}

constexpr std::uint32_t instruction_set_bits() {
  std::uint32_t bits = 0;
#if defined(__AVX__)
  bits |= 1u;
#endif
#if defined(__AVX2__)
  bits |= 2u;
#endif
#if defined(__FMA__)
  bits |= 4u;
#endif
#if defined(__AVX512F__)
  bits |= 8u;
#endif
  return bits;
}

}  // namespace detail

/// The fingerprint of the code that includes this header. `static`, so that a plugin and its host each keep
/// their own copy.
static constexpr Fingerprint this_fingerprint() {
  Fingerprint f{};
  f.sdk_major = PRESHAPE_VERSION_MAJOR;
  f.sdk_minor = PRESHAPE_VERSION_MINOR;
  f.interface_hash_low = PRESHAPE_INTERFACE_HASH_LOW;
  f.interface_hash_high = PRESHAPE_INTERFACE_HASH_HIGH;
  f.probe_size = sizeof(detail::BoundaryProbe);
  f.probe_alignment = alignof(detail::BoundaryProbe);
#if defined(__GXX_ABI_VERSION)
  f.gxx_abi = __GXX_ABI_VERSION;
#endif
#if defined(_GLIBCXX_USE_CXX11_ABI)
  f.cxx11_abi = _GLIBCXX_USE_CXX11_ABI;
#endif
#if defined(_GLIBCXX_DEBUG)
  f.glibcxx_debug = 1;
#endif
#if defined(__GXX_RTTI)
  f.rtti = 1;
#endif
#if defined(__EXCEPTIONS)
  f.exceptions = 1;
#endif
  f.eigen_version = EIGEN_WORLD_VERSION * 10000 + EIGEN_MAJOR_VERSION * 100 + EIGEN_MINOR_VERSION;
  f.eigen_max_align = EIGEN_MAX_ALIGN_BYTES;
  f.eigen_static_align = EIGEN_MAX_STATIC_ALIGN_BYTES;
  f.eigen_malloc_aligned = EIGEN_MALLOC_ALREADY_ALIGNED;
  f.eigen_index_size = sizeof(Eigen::Index);
  f.instruction_set = detail::instruction_set_bits();
#if defined(__FAST_MATH__)
  f.fast_math = 1;
#endif
  f.sanitizer = detail::sanitizer_bits();
#if defined(__clang__)
  f.compiler = 2000000u + __clang_major__ * 1000u;
#else
  f.compiler = 1000000u + __GNUC__ * 1000u;
#endif
  f.cplusplus = __cplusplus;
#if defined(NDEBUG)
  f.ndebug = 1;
#endif
  return f;
}

/// Why `plugin` cannot be called from `host`, field by field with both sides and the mend; empty when it can.
PRESHAPE_API std::vector<std::string> fingerprint_conflicts(const Fingerprint& plugin, const Fingerprint& host);

/// "SDK 0.1, g++ 12, C++20, Eigen 3.4.0, AVX2": for listings and reports.
PRESHAPE_API std::string fingerprint_text(const Fingerprint& fingerprint);

/// The fingerprint that this core library was built with.
PRESHAPE_API const Fingerprint& host_fingerprint();

}  // namespace preshape
