// A file under a name of its own until it is whole.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include <cover/error.hpp>
#include <cover/result.hpp>

namespace cover {

/// The error of a file that cannot be written, with the system's reason `number` (errno).
Error cannot_write(const std::string& path, int number);
/// The error of a file that was to be written when the caller wanted no more.
Error not_written(const std::string& path);

/// Where the bytes of a file go that is written under the name `path`: the end of a chain of
/// symbolic links, whether it is there or not; else `path` itself. Links of /proc are not followed:
/// what /dev/stdout leads to is a file that someone else has opened.
///
/// Errors: cannot_write (ELOOP)
Result<std::filesystem::path> end_of_links(const std::filesystem::path& path);

/// The permissions and the owner that a new file takes over from the one it replaces.
struct FileOwner {
  mode_t mode = 0;  ///< permissions alone
  uid_t user = 0;
  gid_t group = 0;
};
/// Of the regular file `path`; nothing where there is none.
std::optional<FileOwner> owner_of(const std::filesystem::path& path);

/// cannot_write for a file whose own permissions forbid that, although a rename, which asks only
/// for those of its folder, could replace it. `shown` is its name in messages.
Status may_replace(const std::filesystem::path& target, const std::string& shown);

/// `.NAME.N.tmp`; where a folder takes no name as long as that, NAME is cut short, and has a hash.
std::string temporary_name(std::string_view name, int n);

/// A hidden file `.NAME.N.tmp` that becomes NAME, or another name, by one rename. It is locked
/// while its object lives, so that what a killed run has left behind can be told from what is in
/// work.
///
/// The first failure is kept and reported by `rename`.
class TemporaryFile {
 public:
  /// Creates the file beside `target`, under the first free N. What dead runs left behind stays.
  /// `shown` is the name for messages.
  ///
  /// Errors: cannot_write, with the reason that the system gives
  static Result<TemporaryFile> beside(const std::filesystem::path& target, const std::string& shown,
                                      const std::optional<FileOwner>& owner, std::stop_token stop);
  /// Opens a device or a pipe, to which is written at once.
  static Result<TemporaryFile> direct(const std::string& target, std::stop_token stop);

  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&& other) noexcept;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  /// Removes the file unless it was renamed.
  ~TemporaryFile();

  void write(std::string_view bytes);

  /// Its name; empty for a device or a pipe.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Has everything on the disk; then a power failure costs nothing of what is renamed. Nothing to
  /// do a second time.
  void sync();
  /// Does so, and looks at what has failed so far; what is left is a rename, which heeds no stop
  /// then.
  ///
  /// Errors: cannot_write for what an earlier call met; cancelled, if a stop was requested
  Status prepare();

  /// Renames the file, which must be in the same folder as `target`; to be called once. On the disk
  /// for good only after sync_folder().
  ///
  /// Errors: cannot_write, also for what an earlier call met; cancelled, if a stop was requested
  Status rename(const std::filesystem::path& target);

 private:
  TemporaryFile() = default;
  void discard();
  Status check();
  void take_over_owner();
  void fail(int number) {
    if (failure_ == 0) failure_ = number;
  }
  void push_to_disk();

  int file_ = -1;
  std::filesystem::path path_;  ///< empty: nothing to remove
  std::string shown_;
  bool is_direct_ = false;
  std::stop_token stop_;
  std::optional<FileOwner> owner_;
  int failure_ = 0;  ///< errno of the first call that failed
  bool is_synced_ = false;
  std::int64_t written_ = 0;
  std::int64_t pushed_ = 0;  ///< up to here the disk has been told to write
};

/// Removes the files of `folder` that runs have left behind which were killed while they wrote to
/// `name`.
void remove_leftovers(const std::filesystem::path& folder, std::string_view name);

/// Has the names in a folder on the disk.
///
/// Errors: cannot_write, in the name of `shown`
Status sync_folder(const std::filesystem::path& folder, const std::string& shown);

}  // namespace cover
