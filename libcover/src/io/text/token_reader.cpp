#include "io/text/token_reader.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "io/text/text.hpp"

namespace cover {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// The word for a message: cut short, and without bytes that would spoil a terminal.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, 40));
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return word.size() > 40 ? text + "..." : text;
}

}  // namespace

void TokenReader::fail(ErrorCode code, std::string_view what) {
  if (!error_) error_ = Error{code, fmt::format("{}:{}: {}", source_, line_, what), {}, {}};
}

void TokenReader::skip_blanks() {
  for (; at_ < text_.size() && is_blank(text_[at_]); ++at_) line_ += text_[at_] == '\n';
}

std::string_view TokenReader::word() {
  skip_blanks();
  const std::size_t start = at_;
  while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
  return text_.substr(start, at_ - start);
}

std::string_view TokenReader::required(std::string_view what) {
  const std::string_view found = word();
  if (found.empty()) fail(ErrorCode::truncated, fmt::format("the file ends before {}", what));
  return found;
}

void TokenReader::set_binary(bool binary) {
  binary_ = binary;
  if (!binary) return;
  while (at_ < text_.size() && text_[at_] != '\n' && is_blank(text_[at_])) ++at_;
  if (at_ < text_.size() && text_[at_] == '\n') ++at_;
}

template <class T>
T TokenReader::bytes(std::string_view what) {
  T value{};
  if (text_.size() - at_ < sizeof(T)) {
    fail(ErrorCode::truncated, fmt::format("the file ends before {}", what));
    at_ = text_.size();
    return value;
  }
  std::memcpy(&value, text_.data() + at_, sizeof(T));
  at_ += sizeof(T);
  return value;
}

long TokenReader::wide_integer(std::string_view what) {
  return binary_ ? static_cast<long>(bytes<std::int64_t>(what)) : integer(what);
}

long TokenReader::integer(std::string_view what) {
  if (binary_) return bytes<std::int32_t>(what);
  const std::string_view found = required(what);
  const std::optional<long> value = parse_integer(found);
  if (!value) fail(ErrorCode::syntax, fmt::format("expected {}, found '{}'", what, shown(found)));
  return value.value_or(0);
}

double TokenReader::real(std::string_view what) {
  if (binary_) {
    const auto value = bytes<double>(what);
    if (std::isfinite(value)) return value;
    fail(ErrorCode::non_finite_coordinate, fmt::format("{} is not finite", what));
    return 0;
  }
  const std::string_view found = required(what);
  const std::optional<double> value = parse_double(found);
  if (!value) fail(ErrorCode::syntax, fmt::format("expected {}, found '{}'", what, shown(found)));
  if (value && !std::isfinite(*value))
    fail(ErrorCode::non_finite_coordinate, fmt::format("{} is not finite: {}", what, shown(found)));
  return failed() ? 0 : *value;
}

std::size_t TokenReader::count(std::string_view what) { return checked_count(integer(what), what); }

std::size_t TokenReader::wide_count(std::string_view what) {
  return checked_count(wide_integer(what), what);
}

std::size_t TokenReader::checked_count(long value, std::string_view what) {
  if (value >= 0 && static_cast<std::size_t>(value) <= text_.size() - at_)
    return static_cast<std::size_t>(value);
  if (value < 0)
    fail(ErrorCode::syntax, fmt::format("{} is negative: {}", what, value));
  else
    fail(ErrorCode::truncated, fmt::format("the file is too short for {} {}", value, what));
  return 0;
}

std::string TokenReader::quoted(std::string_view what) {
  skip_blanks();
  const std::size_t end = at_ < text_.size() ? text_.find_first_of("\"\n", at_ + 1) : text_.npos;
  if (end == text_.npos || text_[at_] != '"' || text_[end] != '"') {
    fail(ErrorCode::syntax, fmt::format("expected {} in double quotes", what));
    return {};
  }
  std::string name(text_.substr(at_ + 1, end - at_ - 1));
  at_ = end + 1;
  return name;
}

void TokenReader::skip_past(std::string_view end) {
  for (std::string_view w = required(end); !failed() && w != end;) w = required(end);
}

void TokenReader::expect(std::string_view expected) {
  const std::string_view found = required(expected);
  if (found != expected)
    fail(ErrorCode::syntax, fmt::format("expected {}, found '{}'", expected, shown(found)));
}

}  // namespace cover
