// Tested by tests/unit/io/text/split_json_test.cpp.
#include "io/text/split_json.hpp"

#include <algorithm>

namespace cover {
namespace {

/// Goes through a text from bracket to bracket. Every function is false where the text is none of
/// JSON; some texts that are none pass.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t at() const { return at_; }
  /// The next character that is not blank; 0 at the end.
  char peek() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  /// A string with its quotes.
  bool string(std::string_view& out) {
    if (peek() != '"') return false;
    const std::size_t begin = at_;
    if (!pass_string()) return false;
    out = text_.substr(begin, at_ - begin);
    return true;
  }
  bool value(std::string_view& out) {
    const char first = peek();
    const std::size_t begin = at_;
    if (first == '"') {
      if (!pass_string()) return false;
    } else if (first == '{' || first == '[') {
      if (!pass_brackets()) return false;
    } else {
      while (at_ < text_.size() && !is_end(text_[at_])) ++at_;
    }
    out = text_.substr(begin, at_ - begin);
    return !out.empty();
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  static bool is_end(char c) { return is_blank(c) || c == ',' || c == ']' || c == '}' || c == ':'; }

  bool pass_string() {
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\\') {
        ++at_;
      } else if (text_[at_] == '"') {
        ++at_;
        return true;
      }
    }
    return false;
  }

  bool pass_brackets() {
    std::size_t depth = 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"') {
        if (!pass_string()) return false;
        continue;
      }
      ++at_;
      if (c == '{' || c == '[') ++depth;
      if ((c == '}' || c == ']') && --depth == 0) return true;
    }
    return false;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The elements of the array that comes next.
bool read_elements(Scanner& scan, std::vector<std::string_view>& elements) {
  if (!scan.take('[')) return false;
  if (scan.take(']')) return true;
  do {
    std::string_view element;
    if (!scan.value(element)) return false;
    elements.push_back(element);
  } while (scan.take(','));
  return scan.take(']');
}

}  // namespace

std::optional<SplitJson> split_json(std::string_view text,
                                    std::initializer_list<std::string_view> names) {
  Scanner scan(text);
  if (!scan.take('{')) return std::nullopt;
  do {
    std::string_view key;
    if (!scan.string(key) || !scan.take(':')) return std::nullopt;
    key = key.substr(1, key.size() - 2);
    if (scan.peek() == '[' && std::find(names.begin(), names.end(), key) != names.end()) {
      SplitJson split;
      split.name = key;
      const std::size_t begin = scan.at();
      if (!read_elements(scan, split.elements)) return std::nullopt;
      split.rest = text.substr(0, begin);
      split.rest += "[]";
      split.rest += text.substr(scan.at());
      return split;
    }
    std::string_view passed;
    if (!scan.value(passed)) return std::nullopt;
  } while (scan.take(','));
  return std::nullopt;
}

}  // namespace cover
