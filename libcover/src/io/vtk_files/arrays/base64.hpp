// Bytes written as base64.
#pragma once

#include <cstddef>
#include <string_view>

namespace cover {

/// Decodes from the front of a text, piece by piece. Blanks are passed over. Padding may stand in
/// the middle: VTK writes the header of compressed data as a text of its own in front.
class Base64 {
 public:
  explicit Base64(std::string_view text) : text_(text) {}

  /// More than this cannot come.
  [[nodiscard]] std::size_t most() const { return held_ + text_.size() / 4 * 3; }

  /// The next `size` bytes; false where the text ends before, or is no base64.
  bool read(char* out, std::size_t size);

 private:
  /// Decodes the next four letters into `bytes_`.
  bool next();

  std::string_view text_;
  char bytes_[3] = {};  ///< decoded and not taken yet: the last `held_` of `filled_`
  std::size_t filled_ = 0;
  std::size_t held_ = 0;
};

}  // namespace cover
