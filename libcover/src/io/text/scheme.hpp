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
/// lines that begin with # as a preprocessor's do. Of these, #if 0 and #if 1, #else and #endif are
/// understood. What stands between any other #if and its #endif is left out, as nobody knows which
/// branch is meant. A quote stands for nothing: '(a b) is (a b).
///
/// Errors: syntax, with the line: parentheses that do not match, texts and #if without an end, more
///         than kSchemeDepth lists one in the other
/// Cost:   O(length of text)
struct SchemeText {
  std::vector<SchemeForm> forms;
  std::vector<int> conditions;  ///< lines of each #if that is not understood
  std::vector<int> directives;  ///< lines of all else that a preprocessor would read
};
Result<SchemeText> parse_scheme(std::string_view text, const std::string& source);

}  // namespace cover
