// Lines of numbers, whose first error stays.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text/text.hpp"

namespace cover {

/// A LineReader whose fields are asked for as numbers. A reading that fails gives a harmless value
/// and keeps the error with file and line; whoever reads in a loop asks `failed()`.
class FieldReader {
 public:
  /// `text` must outlive the reader. A `comment` character ends a line.
  FieldReader(std::string_view text, const std::string& source, char comment,
              Separator separator = Separator::blank)
      : lines_(text, source, comment, separator) {}

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  /// REQUIRES: failed()
  [[nodiscard]] const Error& error() const { return *error_; }
  /// Keeps `what` as the error, said of the current line; only the first error counts.
  void fail(ErrorCode code, std::string_view what) {
    if (!error_) error_ = lines_.error(code, what);
  }

  /// Goes on to the next line that has a field; false at the end of the text, and once failed.
  bool next() { return !failed() && lines_.next(); }
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return lines_.fields(); }

  long integer(std::size_t field);
  /// Finite, that is.
  double real(std::size_t field);

 private:
  [[nodiscard]] std::string hint_at(std::size_t field) const;

  LineReader lines_;
  std::optional<Error> error_;
};

}  // namespace cover
