// See page_pool.hpp. Tested by tests/unit/app/page_pool_test.cpp.
#include "memory/page_pool.hpp"

#include <algorithm>
#include <bit>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace cover::app {

#ifdef __linux__
namespace {

constexpr int kPopulateWrite = 23;  // MADV_POPULATE_WRITE, of Linux 5.14
/// To move pages takes the system as long as to clear so many of them, however few they are: all
/// processors must forget where they were.
constexpr std::size_t kSmallestMoved = std::size_t{1} << 18;
/// Larger arrays may be more than anybody will ever fill, or than there is.
constexpr std::size_t kMostPopulated = std::size_t{1} << 28;

/// Whether an array was asked for by its size. One that has grown by doubling, from one item on,
/// may be filled by half.
bool is_to_be_filled(std::size_t bytes) {
  constexpr int kDoubled = 16;  // times; of sizes of their own, few are such a number
  return bytes <= kMostPopulated && std::countr_zero(bytes) < kDoubled;
}

std::size_t whole_pages(std::size_t bytes) {
  static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return (bytes + page - 1) / page * page;
}

/// Pages of zeros that nobody has touched; null where there are none.
char* map_pages(char* at, std::size_t bytes) {
  const int flags = MAP_PRIVATE | MAP_ANONYMOUS | (at != nullptr ? MAP_FIXED : 0);
  void* const mapped = mmap(at, bytes, PROT_READ | PROT_WRITE, flags, -1, 0);
  return mapped != MAP_FAILED ? static_cast<char*>(mapped) : nullptr;
}

}  // namespace

void* PagePool::take(std::size_t bytes) noexcept {
  const bool populates = is_to_be_filled(bytes);
  bytes = whole_pages(bytes);
  std::size_t used_before = bytes;
  void* const array = take_pages(bytes, used_before);
  // All pages at once take the system half the time that one after the other would. What does not
  // work is made up for as pages are touched.
  if (array != nullptr && populates && used_before < bytes)
    madvise(static_cast<char*>(array) + used_before, bytes - used_before, kPopulateWrite);
  return array;
}

/// The first `used_before` bytes of the array are pages that were in use before.
void* PagePool::take_pages(std::size_t bytes, std::size_t& used_before) noexcept {
  const std::lock_guard lock(mutex_);
  if (count_ == kMostPieces) return nullptr;
  if (Piece* const piece = best_fit(bytes); piece != nullptr) {
    char* const array = piece->at;
    // What would be left and never moved is the array's.
    const std::size_t part = piece->bytes - bytes < kSmallestMoved ? piece->bytes : bytes;
    piece->at += part;
    piece->bytes -= part;
    kept_ -= part;
    add({array, part, array});
    erase_empty();
    return array;
  }
  char* const array = map_pages(nullptr, bytes);
  if (array == nullptr) return nullptr;
  std::size_t moved = 0;
  if (!move_kept(array, bytes, moved)) {
    munmap(array, bytes);
    std::for_each(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(count_),
                  [&](Piece& piece) {
                    if (piece.array == array) piece.bytes = 0;
                  });
    used_ -= moved;
    erase_empty();
    return nullptr;
  }
  if (moved < bytes) add({array + moved, bytes - moved, array});
  used_before = moved;
  erase_empty();
  return array;
}

PagePool::Piece* PagePool::best_fit(std::size_t bytes) {
  Piece* best = nullptr;
  for (std::size_t k = 0; k < count_; ++k) {
    Piece& piece = pieces_[k];
    if (piece.array != nullptr || piece.bytes < bytes) continue;
    if (best == nullptr || piece.bytes < best->bytes) best = &piece;
  }
  return best;
}

/// Moves pages that are kept to the beginning of `array`; false where a hole is left there.
bool PagePool::move_kept(char* array, std::size_t bytes, std::size_t& moved) {
  const std::size_t before = count_;
  for (std::size_t k = 0; k < before && moved < bytes; ++k) {
    Piece& piece = pieces_[k];
    if (piece.array != nullptr) continue;
    const std::size_t part = std::min(piece.bytes, bytes - moved);
    if (part < kSmallestMoved) break;     // no piece that is kept is so small
    if (count_ + 2 > kMostPieces) break;  // one for the rest
    char* const to = array + moved;
    if (mremap(piece.at, part, part, MREMAP_MAYMOVE | MREMAP_FIXED, to) == MAP_FAILED) {
      return map_pages(to, bytes - moved) != nullptr;  // what was there may be gone
    }
    piece.at += part;
    piece.bytes -= part;
    kept_ -= part;
    add({to, part, array});
    moved += part;
  }
  drop_small();
  return true;
}

void PagePool::add(const Piece& piece) {
  pieces_[count_++] = piece;
  used_ += piece.bytes;
  most_used_ = std::max(most_used_, used_);
}

void PagePool::erase_empty() {
  const auto end = pieces_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto is_empty = [](const Piece& piece) { return piece.bytes == 0; };
  count_ =
      static_cast<std::size_t>(std::remove_if(pieces_.begin(), end, is_empty) - pieces_.begin());
}

bool PagePool::give(void* array) noexcept {
  const std::lock_guard lock(mutex_);
  const std::size_t before = used_;
  for (std::size_t k = 0; k < count_; ++k) {
    if (pieces_[k].array != array) continue;
    pieces_[k].array = nullptr;
    used_ -= pieces_[k].bytes;
    kept_ += pieces_[k].bytes;
  }
  if (used_ == before) return false;
  drop_small();
  keep_at_most(whole_pages(most_used_ / 4));
  return true;
}

bool PagePool::release() noexcept {
  const std::lock_guard lock(mutex_);
  if (kept_ == 0) return false;
  keep_at_most(0);
  return true;
}

void PagePool::keep_at_most(std::size_t bytes) noexcept {
  for (std::size_t k = count_; k-- > 0 && kept_ > bytes;) {
    Piece& piece = pieces_[k];
    if (piece.array != nullptr) continue;
    give_back(piece, std::min(piece.bytes, kept_ - bytes));
  }
  drop_small();
  erase_empty();
}

/// Pieces that are too small to be moved are of no use.
void PagePool::drop_small() noexcept {
  for (std::size_t k = 0; k < count_; ++k) {
    if (pieces_[k].array == nullptr && pieces_[k].bytes < kSmallestMoved)
      give_back(pieces_[k], pieces_[k].bytes);
  }
}

/// The last `bytes` of a piece that is kept.
void PagePool::give_back(Piece& piece, std::size_t bytes) noexcept {
  if (bytes == 0) return;
  munmap(piece.at + (piece.bytes - bytes), bytes);
  piece.bytes -= bytes;
  kept_ -= bytes;
}

#else

// What moves pages is Linux's own.
void* PagePool::take(std::size_t /*bytes*/) noexcept { return nullptr; }
bool PagePool::give(void* /*array*/) noexcept { return false; }
bool PagePool::release() noexcept { return false; }

#endif

std::size_t PagePool::used() const {
  const std::lock_guard lock(mutex_);
  return used_;
}

std::size_t PagePool::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_;
}

}  // namespace cover::app
