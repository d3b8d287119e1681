// A file that appears whole or not at all.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include <cover/error.hpp>
#include <cover/result.hpp>

namespace cover {

/// Writes to a temporary name in the folder of the target; `commit` renames. A file that is never
/// committed leaves nothing behind, and what stood under its name stays as it was.
///
/// A target that exists and is no regular file (/dev/null, a pipe) is written to directly.
/// Threads: one writer per object; several objects may have the same target, the last commit wins.
class AtomicFile {
 public:
  /// Creates the temporary file.
  ///
  /// Errors: cannot_write, with the reason that the system gives.
  static Result<AtomicFile> create(const std::string& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Appends `bytes`. A failure is kept and reported by `commit`.
  void write(std::string_view bytes);

  /// The name to give to a library that opens its files itself; call `release` first.
  [[nodiscard]] const std::string& temporary_path() const { return temporary_; }
  /// Closes the file, so that others can write to `temporary_path`; `write` may not follow.
  void release();

  /// Closes and renames; to be called once.
  ///
  /// Errors: cannot_write, also for what an earlier `write` met (disk full, ...).
  Status commit();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  AtomicFile() = default;
  /// Removes the temporary file of an object that was never committed.
  void discard();
  /// The error for `path_`, with the system's reason `number`.
  [[nodiscard]] Error failure(int number) const;

  std::string path_;
  std::string temporary_;  ///< empty: nothing to remove
  std::unique_ptr<std::FILE, Closer> file_;
  int first_failure_ = 0;  ///< errno of the first write that failed
};

}  // namespace cover
