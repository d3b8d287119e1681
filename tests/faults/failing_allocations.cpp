// The operators of a program come before those of the C++ library, so that these here are what the
// program and all its libraries call. In front of each block stand its size and its run.
#include "failing_allocations.hpp"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace cover::testing {
namespace {

struct alignas(std::max_align_t) Header {
  std::uint64_t run = 0;  ///< 0: not counted
  std::size_t size = 0;
};

std::atomic<bool> is_on = false;
std::atomic<std::uint64_t> run = 0;
std::atomic<std::size_t> counted = 0;
std::atomic<std::size_t> fails_at = 0;
std::atomic<std::size_t> fails_before = 0;
std::atomic<bool> has_failed = false;
std::atomic<std::size_t> left = 0;
std::atomic<std::size_t> left_size = 0;
std::atomic<Header*> before_failure = nullptr;
thread_local Header* last = nullptr;

void* allocate(std::size_t size) {
  if (const std::size_t number = is_on ? ++counted : 0;
      number > 0 && number >= fails_at && number < fails_before) {
    if (!has_failed.exchange(true)) before_failure = last;
    throw std::bad_alloc();
  }
  auto* const header = static_cast<Header*>(std::malloc(sizeof(Header) + size));
  if (header == nullptr) throw std::bad_alloc();
  *header = {is_on ? run.load() : 0, size};
  if (header->run != 0) {
    ++left;
    left_size += size;
    last = header;
  }
  return header + 1;
}

void give_back(void* block) noexcept {
  if (block == nullptr) return;
  auto* const header = static_cast<Header*>(block) - 1;
  if (header->run != 0 && header->run == run) {
    --left;
    left_size -= header->size;
  }
  if (header == last) last = nullptr;
  Header* suspect = header;
  before_failure.compare_exchange_strong(suspect, nullptr);
  std::free(header);
}

void* allocate_or_null(std::size_t size) noexcept {
  try {
    return allocate(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace

void fail_allocation(std::size_t at, std::size_t in_a_row) {
  ++run;
  counted = left = left_size = 0;
  has_failed = false;
  before_failure = last = nullptr;
  fails_at = at;
  fails_before = at == 0 ? 0 : at + in_a_row;
  is_on = true;
}

Allocations end_of_failing_allocations() {
  is_on = false;
  Header* const suspect = before_failure;
  return {counted, has_failed, left, left_size, suspect != nullptr ? suspect->size : 0};
}

void free_block_before_failure() {
  if (Header* const lost = before_failure) give_back(lost + 1);
}

}  // namespace cover::testing

void* operator new(std::size_t size) { return cover::testing::allocate(size); }
void* operator new[](std::size_t size) { return cover::testing::allocate(size); }
// A sanitizer has its own of these, whose blocks have no header.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return cover::testing::allocate_or_null(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return cover::testing::allocate_or_null(size);
}
void operator delete(void* block) noexcept { cover::testing::give_back(block); }
void operator delete[](void* block) noexcept { cover::testing::give_back(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept {
  cover::testing::give_back(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept {
  cover::testing::give_back(block);
}
void operator delete(void* block, std::size_t) noexcept { cover::testing::give_back(block); }
void operator delete[](void* block, std::size_t) noexcept { cover::testing::give_back(block); }
