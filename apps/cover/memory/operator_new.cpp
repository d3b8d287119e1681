// operator new and delete of the whole program: large arrays from a pool of pages, all else from
// malloc. Tested by tests/cli/program_test.py, Memory.
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "memory/page_pool.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define COVER_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define COVER_SANITIZED
#endif

namespace cover::app {

#ifdef COVER_SANITIZED

void pool_large_arrays() {}

#else

namespace {

constexpr std::size_t kLarge = std::size_t{1} << 19;
constexpr std::uintptr_t kSmallestPage = 4096;

constinit PagePool pool;
constinit std::atomic<bool> is_pooled = false;

void* take(std::size_t size) {
  if (size >= kLarge && is_pooled.load(std::memory_order_relaxed)) {
    if (void* const array = pool.take(size); array != nullptr) return array;
  }
  do {
    if (void* const block = std::malloc(size > 0 ? size : 1); block != nullptr) return block;
  } while (pool.release());
  return nullptr;
}

void give(void* block) noexcept {
  // What malloc hands out is hardly ever at the beginning of a page.
  const bool may_be_pooled = reinterpret_cast<std::uintptr_t>(block) % kSmallestPage == 0;
  if (!may_be_pooled || block == nullptr || !pool.give(block)) std::free(block);
}

}  // namespace

void pool_large_arrays() { is_pooled = true; }

#endif

}  // namespace cover::app

#ifndef COVER_SANITIZED

void* operator new(std::size_t size) {
  for (;;) {
    if (void* const block = cover::app::take(size); block != nullptr) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}
void operator delete(void* block) noexcept { cover::app::give(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { cover::app::give(block); }

#endif
