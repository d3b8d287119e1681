// Pages of arrays that were freed, for the arrays that come next.
//
// Stages of a run give way to each other, and so do their arrays, three times the memory that is in
// use at a time. The system clears each page before it is touched first, by one thread, and that is
// most of its time in a run. So pages stay: an array is put together from those of several others,
// which the system moves without looking at them, and no piece of memory is too small for the next.
#pragma once

#include <array>
#include <cstddef>
#include <mutex>

namespace cover::app {

class PagePool {
 public:
  constexpr PagePool() = default;

  /// Room for `bytes`, from the pages that are kept and then from the system, at the beginning of a
  /// page; null where there is none.
  [[nodiscard]] void* take(std::size_t bytes) noexcept;
  /// Keeps the pages of an array, but no more than a quarter of the most that were in use.
  ///
  /// ENSURES: false, and nothing has happened, where take() has not made it
  [[nodiscard]] bool give(void* array) noexcept;
  /// Gives the system what is kept; false if that is nothing.
  bool release() noexcept;

  /// Bytes of pages in use, and of those that are kept.
  [[nodiscard]] std::size_t used() const;
  [[nodiscard]] std::size_t kept() const;

 private:
  /// Pages that follow each other and were mapped at once: only these can be moved at once.
  struct Piece {
    char* at = nullptr;
    std::size_t bytes = 0;
    void* array = nullptr;  ///< whose it is; null if it is kept
  };

  void* take_pages(std::size_t bytes, std::size_t& used_before) noexcept;
  /// The smallest piece that is kept and has so many bytes; null if none has.
  Piece* best_fit(std::size_t bytes);
  bool move_kept(char* array, std::size_t bytes, std::size_t& moved);
  void keep_at_most(std::size_t bytes) noexcept;
  void drop_small() noexcept;
  void give_back(Piece& piece, std::size_t bytes) noexcept;
  void add(const Piece& piece);
  void erase_empty();

  /// Whoever needs more has arrays that are no longer large beside what it has.
  static constexpr std::size_t kMostPieces = 4096;

  mutable std::mutex mutex_;
  std::array<Piece, kMostPieces> pieces_{};
  std::size_t count_ = 0;
  std::size_t used_ = 0, kept_ = 0, most_used_ = 0;
};

/// From now on `operator new` takes large arrays from a pool, but for sanitizers, which have one of
/// their own.
void pool_large_arrays();

}  // namespace cover::app
