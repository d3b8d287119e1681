// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace cover {

/// `text` with the characters that mean something in markup written as entities, and those that may
/// not be in it at all as printable() writes them.
std::string escaped_markup(std::string_view text);

}  // namespace cover
