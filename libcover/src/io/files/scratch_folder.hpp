// A place for files that are to be moved to their names all at once.
#pragma once

#include <filesystem>
#include <string>

#include <cover/result.hpp>

namespace cover {

/// A new, hidden folder beside a target path; removed with what is left in it.
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

  /// Lets the folder stay with all that is in it.
  void leave() { path_.clear(); }

 private:
  explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;  ///< empty: moved from, or left
};

}  // namespace cover
