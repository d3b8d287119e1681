// A file that appears whole or not at all.
#pragma once

#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include <cover/result.hpp>

#include "io/files/temporary_file.hpp"

namespace cover {

/// Writes to a temporary name in the folder of the target; `commit` renames. A file that is never
/// committed leaves nothing behind, and what stood under its name stays as it was. Only a process
/// that is killed leaves a temporary file behind, which goes when the name is written to again.
///
/// A symbolic link stays one: what it leads to is replaced. A file that is replaced hands its
/// permissions on, and its owner where that is allowed. A target that exists and is no regular file
/// (/dev/null, a pipe) is written to directly.
/// Threads: one writer per object; several objects may have the same target, the last commit wins.
class AtomicFile {
 public:
  /// Creates the temporary file. A requested stop fails the file.
  ///
  /// Errors: cannot_write, with the reason that the system gives.
  static Result<AtomicFile> create(const std::string& path, std::stop_token stop = {});

  /// Appends `bytes`. A failure is kept and reported by `commit`.
  void write(std::string_view bytes) { file_.write(bytes); }

  /// Where the file stands until then, for whoever writes parts of it to their places; empty where
  /// it is written to directly.
  [[nodiscard]] const std::filesystem::path& temporary_path() const { return file_.path(); }

  /// Has the file on the disk under its temporary name, so that all that is left for `commit` is a
  /// rename: where several files belong together, none of them appears if one fails. A stop is
  /// heeded no more after that.
  ///
  /// Errors: cannot_write, also for what an earlier `write` met (disk full, ...); cancelled
  Status prepare() { return file_.prepare(); }

  /// Has the file on the disk and renames it; to be called once.
  ///
  /// Errors: cannot_write, also for what an earlier `write` met (disk full, ...); cancelled
  Status commit();

 private:
  friend Status commit_together(std::span<AtomicFile* const> files);

  /// The two halves of `commit`.
  Status replace();
  [[nodiscard]] Status sync_place() const;

  AtomicFile(std::string path, std::filesystem::path target, TemporaryFile file)
      : path_(std::move(path)), target_(std::move(target)), file_(std::move(file)) {}

  std::string path_;
  std::filesystem::path target_;  ///< empty: written to directly
  TemporaryFile file_;
};

/// Whether an AtomicFile writes to `path` itself: a device, a pipe, a file that someone has opened.
bool is_written_directly(const std::string& path);

/// Commits prepared files that belong together. Nothing but their renames lies between the first
/// and the last, so a kill has little time to mix the old ones with the new; where the first cannot
/// be renamed, none is. After that, a failure is no reason to leave others old: the first is told.
///
/// Errors: cannot_write
Status commit_together(std::span<AtomicFile* const> files);

}  // namespace cover
