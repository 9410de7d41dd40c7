#include "allocation.h"

#include <malloc.h>

#include <cerrno>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define PRESHAPE_OWN_MALLOC 0
#else
#define PRESHAPE_OWN_MALLOC 1
#endif

namespace preshape::conformance {

namespace {

// Plain numbers, so that no start-up code is needed before the first allocation of a thread.
thread_local std::size_t watched_count = 0;
thread_local std::size_t fault_at = 0;  ///< allocations until one fails; 0: none will

#if PRESHAPE_OWN_MALLOC
/// Counts an allocation. @returns whether it shall fail
bool note_allocation() {
  ++watched_count;
  return fault_at != 0 && --fault_at == 0;
}
#endif

}  // namespace

bool allocations_watched() { return PRESHAPE_OWN_MALLOC; }

AllocationWatch::AllocationWatch() { watched_count = 0; }
AllocationWatch::~AllocationWatch() = default;
std::size_t AllocationWatch::count() const { return watched_count; }

AllocationFault::AllocationFault(std::size_t n) { fault_at = n; }
AllocationFault::~AllocationFault() { fault_at = 0; }
bool AllocationFault::happened() const { return fault_at == 0; }

std::size_t heap_in_use() {
  malloc_trim(0);  // freed blocks that are kept for the next of their size would count as in use
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace preshape::conformance

#if PRESHAPE_OWN_MALLOC
// The executable's definitions stand before those of the C library for every library of the process; the memory
// is the C library's own, so its free takes it back.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);

[[gnu::visibility("default")]] void* malloc(std::size_t size) {
  if (preshape::conformance::note_allocation()) return errno = ENOMEM, nullptr;
  return __libc_malloc(size);
}
[[gnu::visibility("default")]] void* calloc(std::size_t count, std::size_t size) {
  if (preshape::conformance::note_allocation()) return errno = ENOMEM, nullptr;
  return __libc_calloc(count, size);
}
[[gnu::visibility("default")]] void* realloc(void* block, std::size_t size) {
  if (preshape::conformance::note_allocation()) return errno = ENOMEM, nullptr;
  return __libc_realloc(block, size);
}
}
#endif
