// Text of strangers on a terminal, in a picture or on a page.
#pragma once

#include <string>
#include <string_view>

namespace cover {

/// `text` with what would steer a terminal or is no text written out: control characters and bytes
/// that are no UTF-8 as \n, \t or \x1b, marks of writing direction as \u202e. All else stays.
std::string printable(std::string_view text);

}  // namespace cover
