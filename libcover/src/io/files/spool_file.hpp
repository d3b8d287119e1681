// A file that nobody sees, for what does not fit into memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>

#include <cover/result.hpp>

namespace cover {

/// A file without a name, which the system takes back whatever ends the process.
///
/// Threads: append() and read() from any, at the same time
class SpoolFile {
 public:
  /// On the disk of the file `target`, which need not be there; on that of temporary files where
  /// it is a device or a pipe.
  ///
  /// Errors: cannot_write, in the name of `target`
  static Result<SpoolFile> beside(const std::string& target);

  SpoolFile(SpoolFile&& other) noexcept;
  SpoolFile& operator=(SpoolFile&&) = delete;
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;
  ~SpoolFile();

  /// Appends bytes; returns where they begin. The first failure is kept: see failure().
  std::uint64_t append(std::span<const std::byte> bytes);
  /// Fills `bytes` from `at` on.
  ///
  /// Errors: cannot_write, in the name of the target, also where there are not so many bytes
  Status read(std::uint64_t at, std::span<std::byte> bytes) const;

  /// False once something could not be appended.
  [[nodiscard]] bool is_good() const { return failure_ == 0; }
  /// Errors: cannot_write, for what an append() met
  [[nodiscard]] Status status() const;

 private:
  SpoolFile(int file, std::string shown) : file_(file), shown_(std::move(shown)) {}

  int file_ = -1;
  std::string shown_;
  std::atomic<std::uint64_t> end_ = 0;
  std::atomic<int> failure_ = 0;  ///< errno
};

/// Whether the disk of `target` has room for so many bytes more, as far as the system tells.
///
/// Errors: cannot_write, with both figures
Status check_room(const std::string& target, double bytes);

}  // namespace cover
