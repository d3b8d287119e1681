// Files as a whole: read, replaced, or in a place that nobody else should see.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <cover/result.hpp>

namespace cover {

/// The extension of a file's name with its dot, in lower case: ".vtu" of "a/B.VTU". By it formats
/// are known, of what is read and of what is written.
std::string extension_of(const std::string& path);

/// The whole content of a file.
///
/// Errors: cannot_open, with the reason that the system gives.
Result<std::string> read_file(const std::string& path);

/// Puts a file with these bytes in the place of what `path` names, at once: whatever happens, that
/// is the whole old file or the whole new one.
///
/// Errors: cannot_write, with the reason that the system gives
Status replace_file(const std::string& path, std::string_view bytes);

/// A new, hidden folder beside a target path; removed with what is left in it. It is locked while
/// its object lives: those that killed runs have left behind are removed with the next one.
class ScratchFolder {
 public:
  /// Errors: cannot_write, with the reason that the system gives.
  static Result<ScratchFolder> beside(const std::string& target);

  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&& other) noexcept;
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  ScratchFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::filesystem::path path_;  ///< empty: moved from
  int lock_ = -1;
};

}  // namespace cover
