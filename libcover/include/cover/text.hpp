// Text of messages: numbers, places and names in words, and what strangers wrote made harmless.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <cover/point.hpp>

namespace cover {

/// The shortest text that reads back as the same number.
std::string describe(double x);

/// Three digits, for distances that are only told.
std::string describe_roughly(double x);

/// "(x, y)", each in the shortest form that reads back as the same number.
std::string describe(Point p);

/// The items with `separator` between them.
std::string listed(std::span<const std::string> items, std::string_view separator = ", ");

/// "1 segment", "3 segments".
std::string counted(std::size_t n, std::string_view singular);

/// ASCII letters in lower case.
std::string lower(std::string_view text);

/// `text` with what would steer a terminal or is no text written out: control characters and bytes
/// that are no UTF-8 as \n, \t or \x1b, marks of writing direction as \u202e. All else stays.
std::string printable(std::string_view text);

/// `text` with the characters that mean something in markup written as entities, and those that may
/// not be in it at all as printable() writes them.
std::string escaped_markup(std::string_view text);

/// The candidate that `word` is most likely a misspelling of, if one is close enough.
std::optional<std::string> closest(std::string_view word, std::span<const std::string> candidates);

/// "; did you mean 'disks'?" for the end of a message; empty if no candidate is close enough.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// "'disk' is not one of refine, disks; did you mean 'disks'?"
std::string not_one_of(std::string_view word, std::span<const std::string> candidates);

}  // namespace cover
