// Tested by tests/unit/io/text/json/split_json_test.cpp.
#include "io/text/json/split_json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <system_error>
#include <type_traits>

namespace cover {
namespace {

/// By character: whether it opens or ends something. Between brackets nearly none does.
constexpr auto kIsMark = [] {
  std::array<bool, 256> is_mark{};
  for (const unsigned char c : {'"', '{', '}', '[', ']'}) is_mark[c] = true;
  return is_mark;
}();

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

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A pair of numbers in brackets, as JSON writes them: from_chars() takes more.
class PairReader {
 public:
  explicit PairReader(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

  template <class Number>
  std::optional<std::array<Number, 2>> read() {
    std::array<Number, 2> pair{};
    if (take('[') && number(pair[0]) && take(',') && number(pair[1]) && take(']') && at_ == end_)
      return pair;
    return std::nullopt;
  }

 private:
  bool take(char c) {
    pass_blanks();
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }
  void pass_blanks() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) ++at_;
  }
  const char* after_digits(const char* from) const {
    return std::find_if_not(from, end_, is_digit);
  }

  /// The end of the number that begins here, and whether it is an integer; null if there is none.
  const char* end_of_number(bool& is_integer) const {
    const char* p = at_ != end_ && *at_ == '-' ? at_ + 1 : at_;
    const char* q = after_digits(p);
    if (q == p || (*p == '0' && q - p > 1)) return nullptr;
    is_integer = true;
    if (q != end_ && *q == '.') {
      is_integer = false;
      p = q + 1;
      q = after_digits(p);
      if (q == p) return nullptr;
    }
    if (q != end_ && (*q == 'e' || *q == 'E')) {
      is_integer = false;
      p = q + 1;
      if (p != end_ && (*p == '+' || *p == '-')) ++p;
      q = after_digits(p);
      if (q == p) return nullptr;
    }
    return q;
  }

  template <class Number>
  bool number(Number& out) {
    pass_blanks();
    bool is_integer = false;
    const char* const end = end_of_number(is_integer);
    if (end == nullptr) return false;
    // Integers are integers first, so that -0 is 0.
    long whole = 0;
    std::from_chars_result result{};
    if (is_integer) {
      result = std::from_chars(at_, end, whole);
      out = static_cast<Number>(whole);
    } else if constexpr (std::is_same_v<Number, double>) {
      result = std::from_chars(at_, end, out);
    } else {
      return false;
    }
    at_ = end;
    return result.ec == std::errc() && result.ptr == end;
  }

  const char* at_;
  const char* end_;
};

}  // namespace

std::optional<Point> read_pair(std::string_view element) {
  const auto pair = PairReader(element).read<double>();
  if (!pair) return std::nullopt;
  return Point{(*pair)[0], (*pair)[1]};
}

std::optional<std::array<long, 2>> read_integer_pair(std::string_view element) {
  return PairReader(element).read<long>();
}

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
