// A file whose parts are written to their places by several threads or processes.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>

#include <cover/result.hpp>

namespace cover {

/// The first failure is kept and reported by `finish`.
///
/// Threads: write() from any, at the same time
class PlacedFile {
 public:
  /// Opens a file that is there; `shown` is its name in messages.
  ///
  /// Errors: cannot_write, with the reason that the system gives
  static Result<PlacedFile> open(const std::filesystem::path& path, std::string shown,
                                 std::stop_token stop = {});

  PlacedFile(PlacedFile&& other) noexcept;
  PlacedFile& operator=(PlacedFile&&) = delete;
  PlacedFile(const PlacedFile&) = delete;
  PlacedFile& operator=(const PlacedFile&) = delete;
  ~PlacedFile();

  /// Gives the file its length, so that its parts may come in any order.
  void resize(std::uint64_t size);
  void write(std::uint64_t at, std::string_view bytes);
  /// False once something has failed or a stop was requested: then no more need be written.
  [[nodiscard]] bool is_good() const { return failure_ == 0 && !stop_.stop_requested(); }
  /// Has everything that was written here on the disk.
  ///
  /// Errors: cannot_write, for what an earlier call met; cancelled
  Status finish();

 private:
  PlacedFile(int file, std::string shown, std::stop_token stop)
      : file_(file), shown_(std::move(shown)), stop_(std::move(stop)) {}
  void fail(int number);

  int file_ = -1;
  std::string shown_;
  std::stop_token stop_;
  std::atomic<int> failure_ = 0;  ///< errno
};

}  // namespace cover
