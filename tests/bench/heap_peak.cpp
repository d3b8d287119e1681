// operator new and delete of the whole program, in front of malloc and free. Blocks count with the
// size that malloc gave them. CGAL, OpenMesh and the library allocate in no other way.
#include "heap_peak.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> counting = false;
std::atomic<long> live = 0;
std::atomic<long> most = 0;

void* count(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  if (!counting.load(std::memory_order_relaxed)) return block;
  const long now = live += static_cast<long>(malloc_usable_size(block));
  for (long peak = most; now > peak && !most.compare_exchange_weak(peak, now);) {
  }
  return block;
}

void give_back(void* block) {
  if (counting.load(std::memory_order_relaxed))
    live -= static_cast<long>(malloc_usable_size(block));
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return count(std::malloc(size > 0 ? size : 1)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto a = static_cast<std::size_t>(alignment);
  return count(std::aligned_alloc(a, (size + a - 1) / a * a));
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }

namespace cover::bench {

double heap_peak_of(const std::function<void()>& work) {
  live = most = 0;
  counting = true;
  work();
  counting = false;
  return static_cast<double>(most.load());
}

}  // namespace cover::bench
