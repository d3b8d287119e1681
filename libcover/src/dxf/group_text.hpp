// Texts of DXF, which are in the code page of the drawing up to 2006.
#pragma once

#include <string>
#include <string_view>

namespace cover {

/// `value` in UTF-8: characters written as \U+00E4 are taken as these, and what is no UTF-8 as text
/// in `code_page` ($DWGCODEPAGE, as "ANSI_1252"; empty: that one). What is no text there either
/// stays as it is.
///
/// Cost: O(n)
std::string group_text_in_utf8(std::string_view value, std::string_view code_page);

}  // namespace cover
