// Tested by tests/unit/io/text/json/split_json_test.cpp.
#include "io/text/json/split_json.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cover {
namespace {

/// By character: whether it opens or ends something. Between brackets nearly none does.
constexpr auto kIsMark = [] {
  std::array<bool, 256> is_mark{};
  for (const char c : {'"', '{', '}', '[', ']'}) is_mark[static_cast<unsigned char>(c)] = true;
  return is_mark;
}();

/// Goes through a text from bracket to bracket. Every function is false where the text is none of
/// JSON; some texts that are none pass.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t at() const { return at_; }
  void go_to(std::size_t at) { at_ = at; }
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
    for (;;) {
      const auto mark = std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(),
                                     [](char c) { return kIsMark[static_cast<unsigned char>(c)]; });
      if (mark == text_.end()) return false;
      at_ = static_cast<std::size_t>(mark - text_.begin());
      const char c = *mark;
      if (c == '"') {
        if (!pass_string()) return false;
        continue;
      }
      ++at_;
      if (c == '{' || c == '[') ++depth;
      if ((c == '}' || c == ']') && --depth == 0) return true;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The elements of the array that comes next.
bool read_elements(Scanner& scan, const PassElements& pass, SplitJson::Array& array) {
  if (!scan.take('[')) return false;
  const auto [passed, is_closed] = pass ? pass(array.name, scan.at()) : Passed{scan.at(), false};
  const bool is_first = passed == scan.at();
  scan.go_to(passed);
  if ((is_first || is_closed) && scan.take(']')) return true;
  do {
    std::string_view element;
    if (!scan.value(element)) return false;
    array.elements.push_back(element);
  } while (scan.take(','));
  return scan.take(']');
}

/// Takes arrays out of the object that the text is, until there is nothing more or it is none.
void take_out(std::string_view text, std::initializer_list<std::string_view> names,
              const PassElements& pass, SplitJson& split, std::size_t& copied) {
  Scanner scan(text);
  if (!scan.take('{')) return;
  do {
    std::string_view key;
    if (!scan.string(key) || !scan.take(':')) return;
    key = key.substr(1, key.size() - 2);
    if (scan.peek() == '[' && std::find(names.begin(), names.end(), key) != names.end() &&
        split.find(key) == nullptr) {
      const std::size_t begin = scan.at();
      SplitJson::Array array{std::string(key), {}};
      if (!read_elements(scan, pass, array)) return;
      split.arrays.push_back(std::move(array));
      split.rest += text.substr(copied, begin - copied);
      split.rest += "[]";
      copied = scan.at();
    } else {
      std::string_view passed;
      if (!scan.value(passed)) return;
    }
  } while (scan.take(','));
}

}  // namespace

std::optional<SplitJson> split_json(std::string_view text,
                                    std::initializer_list<std::string_view> names,
                                    const PassElements& pass) {
  SplitJson split;
  std::size_t copied = 0;
  take_out(text, names, pass, split, copied);
  if (split.arrays.empty()) return std::nullopt;
  split.rest += text.substr(copied);
  return split;
}

const SplitJson::Array* SplitJson::find(std::string_view name) const {
  const auto at = std::find_if(arrays.begin(), arrays.end(),
                               [&](const Array& array) { return array.name == name; });
  return at == arrays.end() ? nullptr : &*at;
}

}  // namespace cover
