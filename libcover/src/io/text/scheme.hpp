// Scheme's written form: what drawing programs take for commands.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <cover/result.hpp>

namespace cover {

/// An expression as it is written.
struct SchemeForm {
  enum class Kind { list, symbol, text, number };
  Kind kind = Kind::list;
  std::vector<SchemeForm> items;  ///< of a list
  std::string word;               ///< of a symbol; of a text without its quotes
  double number = 0;
  int line = 0;  ///< of the file, from 1
};

/// The expressions of a text, one after the other; comments (; and #| |#) are passed over, and
/// lines that begin with # as a preprocessor's do, which are returned in `directives`. A quote
/// stands for nothing: '(a b) is (a b).
///
/// Errors: syntax, with the line: parentheses that do not match, texts without an end, more than
///         kSchemeDepth lists one in the other
/// Cost:   O(length of text)
struct SchemeText {
  std::vector<SchemeForm> forms;
  std::vector<int> directives;  ///< their lines
};
Result<SchemeText> parse_scheme(std::string_view text, const std::string& source);

}  // namespace cover
