#include "allocation.h"

#include <malloc.h>

#include <atomic>
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

// Of all threads. malloc's own statistics would count the freed blocks that it keeps for later.
std::atomic<bool> heap_watched = false;
std::atomic<std::ptrdiff_t> heap_growth = 0;

#if PRESHAPE_OWN_MALLOC
void note_growth(void* block, std::ptrdiff_t sign) {
  if (!block || !heap_watched.load(std::memory_order_relaxed)) return;
  heap_growth.fetch_add(sign * static_cast<std::ptrdiff_t>(malloc_usable_size(block)), std::memory_order_relaxed);
}
void* taken(void* block) {
  note_growth(block, 1);
  return block;
}
void given_back(void* block) { note_growth(block, -1); }

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

HeapWatch::HeapWatch() {
  heap_growth = 0;
  heap_watched = true;
}
HeapWatch::~HeapWatch() { heap_watched = false; }
std::ptrdiff_t HeapWatch::growth() const { return heap_growth.load(); }

}  // namespace preshape::conformance

#if PRESHAPE_OWN_MALLOC
// The executable's definitions stand before those of the C library for every library of the process; they pass
// everything on to it.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

#define PRESHAPE_EXPORTED [[gnu::visibility("default")]]
using preshape::conformance::given_back;
using preshape::conformance::note_allocation;
using preshape::conformance::taken;

PRESHAPE_EXPORTED void* malloc(std::size_t size) {
  if (note_allocation()) return errno = ENOMEM, nullptr;
  return taken(__libc_malloc(size));
}
PRESHAPE_EXPORTED void* calloc(std::size_t count, std::size_t size) {
  if (note_allocation()) return errno = ENOMEM, nullptr;
  return taken(__libc_calloc(count, size));
}
PRESHAPE_EXPORTED void* realloc(void* block, std::size_t size) {
  if (note_allocation()) return errno = ENOMEM, nullptr;
  given_back(block);
  void* const moved = __libc_realloc(block, size);
  return taken(moved ? moved : size ? block : nullptr) == moved ? moved : nullptr;
}
PRESHAPE_EXPORTED void* memalign(std::size_t alignment, std::size_t size) {
  if (note_allocation()) return errno = ENOMEM, nullptr;
  return taken(__libc_memalign(alignment, size));
}
PRESHAPE_EXPORTED void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
PRESHAPE_EXPORTED int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  void* const found = memalign(alignment, size);
  if (!found) return ENOMEM;
  *block = found;
  return 0;
}
PRESHAPE_EXPORTED void free(void* block) {
  given_back(block);
  __libc_free(block);
}
}
#endif
