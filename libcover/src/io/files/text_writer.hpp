// Numbers and words into a file, fast and without a locale.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>
#include <utility>

#include "io/files/atomic_file.hpp"

namespace cover {

/// A text file that appears whole or not at all. Doubles are written in the shortest form that
/// reads back as the same double.
class TextWriter {
 public:
  /// Errors: cannot_write; cancelled, by commit()
  static Result<TextWriter> create(const std::string& path, std::stop_token stop = {}) {
    Result<AtomicFile> file = AtomicFile::create(path, std::move(stop));
    if (!file) return std::move(file).error();
    return TextWriter(std::move(*file));
  }

  TextWriter& operator<<(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= kFull) flush();
    return *this;
  }
  TextWriter& operator<<(char c) {
    buffer_.push_back(c);
    return *this;
  }
  template <class Number>
  requires(std::integral<Number> || std::floating_point<Number>) TextWriter& operator<<(
      Number value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return *this << std::string_view(digits.data(), end);
  }

  /// See AtomicFile::prepare().
  Status prepare() {
    flush();
    return file_.prepare();
  }

  /// For commit_together(), once prepared.
  [[nodiscard]] AtomicFile& file() { return file_; }

  /// Closes and renames; to be called once.
  /// Errors: cannot_write, also of earlier output.
  Status commit() {
    flush();
    return file_.commit();
  }

 private:
  static constexpr std::size_t kFull = 1 << 16;

  explicit TextWriter(AtomicFile file) : file_(std::move(file)) { buffer_.reserve(2 * kFull); }
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

  AtomicFile file_;
  std::string buffer_;
};

/// Writes the file `path` with what `write(out)` puts into it.
///
/// Errors: cannot_write; cancelled
template <class Write>
Status write_text(const std::string& path, std::stop_token stop, Write write) {
  Result<TextWriter> out = TextWriter::create(path, std::move(stop));
  if (!out) return std::move(out).error();
  write(*out);
  return out->commit();
}

}  // namespace cover
