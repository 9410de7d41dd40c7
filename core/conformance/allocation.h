#pragma once

#include <cstddef>

namespace preshape::conformance {

/// Whether allocations can be watched: the process's malloc is ours (not under a sanitizer, which brings its own).
bool allocations_watched();

/// Counts what this thread allocates while it lives; one at a time.
class AllocationWatch {
 public:
  AllocationWatch();
  ~AllocationWatch();
  AllocationWatch(const AllocationWatch&) = delete;
  AllocationWatch& operator=(const AllocationWatch&) = delete;
  std::size_t count() const;
};

/// Lets the n-th allocation of this thread fail, counted from 1, once; one at a time.
class AllocationFault {
 public:
  explicit AllocationFault(std::size_t n);
  ~AllocationFault();
  AllocationFault(const AllocationFault&) = delete;
  AllocationFault& operator=(const AllocationFault&) = delete;
  bool happened() const;
};

/// Watches what all threads together allocate and free while it lives; one at a time.
class HeapWatch {
 public:
  HeapWatch();
  ~HeapWatch();
  HeapWatch(const HeapWatch&) = delete;
  HeapWatch& operator=(const HeapWatch&) = delete;
  /// Bytes allocated less bytes freed since it was made.
  std::ptrdiff_t growth() const;
};

}  // namespace preshape::conformance
