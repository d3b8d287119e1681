// Numbers as text spells them, whatever the locale.
// Tested by tests/unit/base/words/parse_number_test.cpp.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/numbers.hpp"

namespace cover {

/// Without one leading plus sign, which files have and from_chars() does not take.
constexpr std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
  return plus ? text.substr(1) : text;
}

/// The number that the whole of `text` spells; none if it spells none or one that does not fit.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || status != std::errc()) return std::nullopt;
  return value;
}

/// What a spelled number that is out of a double's range is closest to: zero or infinity.
inline double nearest_in_range(std::string_view number) {
  const bool negative = number[0] == '-';
  const std::size_t e = number.find_first_of("eE");
  // Without an exponent only a very long number can be out of range: large if it has an integer
  // part, else small.
  const bool small = e == std::string_view::npos ? number.substr(negative ? 1 : 0, 2) == "0."
                                                 : number.substr(e + 1, 1) == "-";
  const double size = small ? 0 : kInfinity;
  return negative ? -size : size;
}

}  // namespace cover
