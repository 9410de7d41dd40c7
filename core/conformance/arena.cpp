#include "arena.h"

#include <sys/mman.h>

#include "preshape/base/assert.h"

namespace preshape::conformance {

Arena::Arena(std::size_t bytes) : size_(bytes) {
  void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  PRESHAPE_DEMAND(memory != MAP_FAILED);
  memory_ = static_cast<std::byte*>(memory);
}

Arena::~Arena() { munmap(memory_, size_); }

void Arena::seal() { mprotect(memory_, size_, PROT_READ); }
// Not unmapped, so that nothing else can come to lie there.
void Arena::release() { mprotect(memory_, size_, PROT_NONE); }

void* Arena::take(std::size_t bytes, std::size_t alignment) {
  used_ = (used_ + alignment - 1) / alignment * alignment;
  PRESHAPE_DEMAND(used_ + bytes <= size_);
  void* const place = memory_ + used_;
  used_ += bytes;
  return place;
}

}  // namespace preshape::conformance
