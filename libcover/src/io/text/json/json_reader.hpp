// Typed access to a JSON document that remembers the first thing found wrong, with its path.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <cover/error.hpp>
#include <cover/point.hpp>
#include <cover/result.hpp>

namespace cover {

using Json = nlohmann::json;

// NOLINTBEGIN(bugprone-exception-escape): moved and erased in place, values throw nothing.

/// Takes a value apart, from its last leaf on, without any memory. The library's destructor makes a
/// list of what it gives back, and ends the process where there is no memory for it.
void take_apart(Json& value) noexcept;

/// A document that is given back without asking for memory.
class JsonDocument {
 public:
  JsonDocument() = default;
  explicit JsonDocument(Json&& root) noexcept : root_(std::move(root)) {}
  JsonDocument(JsonDocument&& other) noexcept : root_(std::move(other.root_)) {}
  JsonDocument& operator=(JsonDocument&& other) noexcept {
    std::swap(root_, other.root_);
    return *this;
  }
  JsonDocument(const JsonDocument&) = delete;
  JsonDocument& operator=(const JsonDocument&) = delete;
  ~JsonDocument() { take_apart(root_); }

  [[nodiscard]] Json& root() { return root_; }
  [[nodiscard]] const Json& root() const { return root_; }

 private:
  Json root_;
};

// NOLINTEND(bugprone-exception-escape)

/// Parses `text`. A key given twice in one object is an error: the first one would be lost.
///
/// Errors: syntax, with line and column.
Result<JsonDocument> parse_json_text(std::string_view text, const std::string& source);

/// Reads values of one document. A reading that fails gives a harmless value and keeps the error;
/// whoever reads asks `failed()` before going on with what depends on it.
class JsonReader {
 public:
  /// `document` and `source` must outlive the reader.
  JsonReader(const Json& document, const std::string& source)
      : document_(document), source_(source) {}

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  /// REQUIRES: failed()
  [[nodiscard]] const Error& error() const { return *error_; }

  /// Keeps `what` as the error, said of the place of `at` in the document; only the first counts.
  void fail(const Json& at, const std::string& what, ErrorCode code = ErrorCode::syntax);

  /// Fails unless `object` is an object all of whose keys are among `keys`, and none of whose
  /// values, but for those of the keys `free`, is null.
  bool expect_keys(const Json& object, const std::vector<std::string_view>& keys,
                   const std::vector<std::string_view>& free = {});
  /// The member of an object, or nullptr where it is missing or null.
  static const Json* member(const Json& object, std::string_view key);
  /// The member of an object; fails where it is missing.
  const Json& required(const Json& object, std::string_view key);
  /// The elements of an array; none, and an error, if it is none.
  const Json& array(const Json& value, std::string_view of_what);

  double number(const Json& value);
  /// REQUIRES of the file: larger than zero.
  double positive(const Json& value);
  long integer(const Json& value);
  bool boolean(const Json& value);
  std::string text(const Json& value);
  /// A string, or an integer as it is written.
  std::string name(const Json& value);
  /// `[x, y]`; with `more_allowed` further numbers are passed over (GeoJSON's heights).
  Point point(const Json& value, bool more_allowed = false);

 private:
  const Json& document_;
  const std::string& source_;
  std::optional<Error> error_;
};

}  // namespace cover
