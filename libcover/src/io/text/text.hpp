// Text files in memory: lines, fields and numbers, with file and line in every error.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/error.hpp>
#include <cover/files.hpp>
#include <cover/result.hpp>
#include <cover/text.hpp>

namespace cover {

/// `text` without the mark of UTF-8 that some editors put at its beginning.
inline std::string_view without_utf8_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

/// The number that the whole of `field` spells; none if it spells none. Too large numbers become
/// infinite, too small ones zero; "nan" and "inf" are numbers here.
std::optional<double> parse_double(std::string_view field);

/// The integer that the whole of `field` spells; none if it spells none or one that does not fit.
std::optional<long> parse_integer(std::string_view field);

/// What to add to an error about a field that spells no number: a word on decimal commas, or
/// nothing.
std::string hint_at_comma(std::string_view field);

/// A field as a message can hold it: cut off after 40 bytes, with '?' for what is no letter.
std::string legible(std::string_view field);

/// What stands between the fields of a line.
enum class Separator {
  blank,  ///< blanks; a comma before a blank counts with it, any other is part of its field
  comma,  ///< blanks or commas
};

/// The lines of a text as fields; comments and empty lines are skipped.
class LineReader {
 public:
  /// `text` must outlive the reader; `source` is the file's name for messages. A `comment`
  /// character ends a line.
  LineReader(std::string_view text, std::string source, char comment,
             Separator separator = Separator::blank);

  /// Bytes that have not been read: no header may announce more lines.
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  /// The same as text, which begins with the next line.
  [[nodiscard]] std::string_view rest() const { return rest_; }
  /// Goes on to the next line that has a field; false at the end of the text.
  bool next();
  /// Passes whole lines, of so many bytes, that somebody else has read.
  void pass(std::size_t bytes, int lines) {
    rest_.remove_prefix(bytes);
    line_ += lines;
  }

  /// The fields of the current line.
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }
  /// The number of the current line, from 1.
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] const std::string& source() const { return source_; }

  /// An error "file:line: what" about the current line.
  [[nodiscard]] Error error(ErrorCode code, std::string_view what) const;

 private:
  std::string_view rest_;
  std::string source_;
  char comment_;
  Separator separator_;
  int line_ = 0;
  std::vector<std::string_view> fields_;
};

}  // namespace cover
