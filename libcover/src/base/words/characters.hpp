// What readers ask of characters and of what is around words, whatever the locale.
#pragma once

#include <string_view>

namespace cover {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Without `blanks` at both ends.
constexpr std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r\n") {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

}  // namespace cover
