// A range of the text is read as if an element began where it begins. Whether one does shows the
// range before it: where that ends behind a comma at this very place, after nothing but pairs. So
// strings, and brackets within brackets, need not be looked for first.
// Tested by tests/unit/io/text/json/read_pairs_test.cpp.
#include "io/text/json/read_pairs.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <type_traits>

#include "base/words/characters.hpp"

namespace cover {

template <class Number>
struct PairRange {
  std::vector<std::array<Number, 2>> pairs{};
  std::size_t end = 0;  ///< behind the comma of the last pair, or the "]" behind it
  bool is_closed = false;
};

namespace {

constexpr std::size_t kRange = 1 << 17;         // bytes
constexpr std::size_t kFewestBytes = 16;        // of a pair, to make room; shorter ones are rare
constexpr std::string_view kInNoPair = "\"{}";  // nor between pairs

/// Pairs of numbers in brackets, as JSON writes them: from_chars() takes more.
class PairReader {
 public:
  explicit PairReader(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

  [[nodiscard]] const char* at() const { return at_; }
  template <class Number>
  bool read(std::array<Number, 2>& pair) {
    return take('[') && number(pair[0]) && take(',') && number(pair[1]) && take(']');
  }
  bool take(char c) {
    pass_blanks();
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

 private:
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

template <class Number>
std::optional<std::array<Number, 2>> read_whole(std::string_view element) {
  PairReader reader(element);
  std::array<Number, 2> pair{};
  if (!reader.read(pair) || reader.at() != element.data() + element.size()) return std::nullopt;
  return pair;
}

/// The place behind the first `], ` from `at` on; `end` if there is none before it.
std::size_t behind_pair(std::string_view text, std::size_t at, std::size_t end) {
  while ((at = std::min(text.find(']', at), end)) != end) {
    at = std::min(text.find_first_not_of(" \n\r\t", at + 1), end);
    if (at != end && text[at] == ',') return at + 1;
  }
  return end;
}

/// The pairs that begin in [begin, end).
template <class Number>
PairRange<Number> read_range(std::string_view text, std::size_t begin, std::size_t end) {
  PairRange<Number> range;
  range.pairs.reserve((end - begin) / kFewestBytes);
  range.end = begin;
  PairReader reader(text.substr(begin));
  std::array<Number, 2> pair{};
  while (range.end < end && reader.read(pair)) {
    const bool goes_on = reader.take(',');
    if (!goes_on && !reader.take(']')) break;
    range.pairs.push_back(pair);
    range.end = static_cast<std::size_t>(reader.at() - text.data());
    if (goes_on) continue;
    --range.end;
    range.is_closed = true;
    break;
  }
  return range;
}

}  // namespace

std::optional<Point> read_pair(std::string_view element) {
  const auto pair = read_whole<double>(element);
  if (!pair) return std::nullopt;
  return Point{(*pair)[0], (*pair)[1]};
}

std::optional<std::array<long, 2>> read_integer_pair(std::string_view element) {
  return read_whole<long>(element);
}

template <class Number>
Pairs<Number> read_pairs(std::string_view text, std::size_t begin, const Team& team) {
  std::size_t end = text.size();
  for (const char c : kInNoPair) end = std::min(end, text.substr(0, end).find(c, begin));
  std::vector<std::size_t> begins{begin};
  while (end - begins.back() > kRange) {
    const std::size_t next = behind_pair(text, begins.back() + kRange, end);
    if (next == end) break;
    begins.push_back(next);
  }
  std::vector<PairRange<Number>> ranges(begins.size());
  begins.push_back(end);
  team.each(ranges.size(),
            [&](std::size_t k) { ranges[k] = read_range<Number>(text, begins[k], begins[k + 1]); });
  Pairs<Number> pairs;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    pairs.end = ranges[k].end;
    pairs.is_closed = ranges[k].is_closed;
    pairs.size += ranges[k].pairs.size();
    pairs.ranges.push_back(std::move(ranges[k].pairs));
    if (pairs.is_closed || pairs.end != begins[k + 1]) break;
  }
  return pairs;
}

template Pairs<double> read_pairs(std::string_view, std::size_t, const Team&);
template Pairs<long> read_pairs(std::string_view, std::size_t, const Team&);

}  // namespace cover
