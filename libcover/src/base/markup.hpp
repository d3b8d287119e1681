// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace cover {

/// `text` with the characters that mean something in markup written as entities.
std::string escaped_markup(std::string_view text);

}  // namespace cover
