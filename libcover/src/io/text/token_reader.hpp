// Words and numbers of a text one after the other, wherever its lines break, or of binary data in
// between.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <cover/error.hpp>

namespace cover {

/// Reads blank-separated words. A reading that fails gives a harmless value and keeps the error
/// with file and line; whoever reads in a loop asks `failed()` in its condition.
class TokenReader {
 public:
  /// `text` and `source` must outlive the reader.
  TokenReader(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  /// REQUIRES: failed()
  [[nodiscard]] const Error& error() const { return *error_; }
  /// Keeps `what` as the error, said of the line of the last word; only the first error counts.
  void fail(ErrorCode code, std::string_view what);

  /// The line of the last word that was read, from 1.
  [[nodiscard]] int line() const { return line_; }

  /// Whether no word is left.
  bool at_end() {
    skip_blanks();
    return at_ == text_.size();
  }
  /// The next word; empty at the end of the text.
  std::string_view word();
  /// What the next words spell; `what` names it in errors. A text that ends is an error.
  long integer(std::string_view what);
  /// The same; as binary data it has 8 bytes and not 4.
  long wide_integer(std::string_view what);
  /// Finite, that is.
  double real(std::string_view what);
  /// A count: not negative, and no more than there are characters left, as each thing counted needs
  /// some. Loops over it end in time, and memory may be reserved for it.
  std::size_t count(std::string_view what);
  /// The same; as binary data it has 8 bytes and not 4.
  std::size_t wide_count(std::string_view what);
  /// From here on, behind the end of the line, numbers are binary data in the order of this
  /// machine's bytes; or they are words again.
  void set_binary(bool binary);
  /// A name in double quotes.
  std::string quoted(std::string_view what);
  /// Passes over words up to and with `end`; fails where it never comes.
  void skip_past(std::string_view end);
  /// Fails unless the next word is `expected`.
  void expect(std::string_view expected);

 private:
  void skip_blanks();
  /// A number of that type out of the next bytes.
  template <class T>
  T bytes(std::string_view what);
  std::size_t checked_count(long value, std::string_view what);
  /// The next word, or an error where there is none.
  std::string_view required(std::string_view what);

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool binary_ = false;
  std::optional<Error> error_;
};

}  // namespace cover
