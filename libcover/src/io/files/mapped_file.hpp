// A file read where it lies.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cover {

/// The bytes of a regular file, which the system brings into memory as they are looked at.
///
/// Threads: any
class MappedFile {
 public:
  /// Nothing where that does not work, as with pipes: then read_file() does.
  static std::optional<MappedFile> open(const std::string& path);

  MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}
  MappedFile& operator=(MappedFile&&) = delete;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile();

  /// REQUIRES of whoever looks at them: nobody makes the file shorter meanwhile
  [[nodiscard]] std::string_view bytes() const { return bytes_; }
  /// Gives back the memory of what was looked at; it may be looked at again.
  void forget() const;

 private:
  explicit MappedFile(std::string_view bytes) : bytes_(bytes) {}

  std::string_view bytes_;
};

}  // namespace cover
