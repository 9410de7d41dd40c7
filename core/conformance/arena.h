#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <type_traits>

namespace preshape::conformance {

/// Memory for the inputs of a call whose fate is watched: sealed, it cannot be written; released, it cannot be
/// touched. Whoever does either crashes, which the parent process sees.
class Arena {
 public:
  explicit Arena(std::size_t bytes = std::size_t{1} << 20);
  ~Arena();
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// A copy of the items in the arena.
  template <class T>
  std::span<const T> keep(std::span<const T> items) {
    static_assert(std::is_trivially_destructible_v<T>);
    T* const first = static_cast<T*>(take(items.size_bytes(), alignof(T)));
    for (std::size_t i = 0; i < items.size(); ++i) new (first + i) T(items[i]);
    return {first, items.size()};
  }
  void seal();
  void release();

 private:
  void* take(std::size_t bytes, std::size_t alignment);
  std::byte* memory_ = nullptr;
  std::size_t size_ = 0, used_ = 0;
};

}  // namespace preshape::conformance
