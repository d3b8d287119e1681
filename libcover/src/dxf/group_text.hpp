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

/// `text` with what AutoCAD writes as %%c, %%d and %%p (diameter, degree, plus or minus), %%123
/// (the character of that number) and %%% as these characters, and without lines under and over it
/// (%%u, %%o, %%k). What else begins with %% stays.
///
/// Cost: O(n)
std::string with_symbols(std::string_view text);

}  // namespace cover
