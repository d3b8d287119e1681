// Long runs of lines of numbers, read by ranges of the text.
//
// A line is plain if it holds nothing but numbers with blanks between, as nearly all lines of large
// files do. Others (comments, commas, signs of plus, whatever is wrong) are left to a LineReader.
// Tested by tests/unit/io/text/plain_lines_test.cpp.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/team.hpp"

namespace cover {

/// The fields of a plain line, one after the other. Each reading is false where the line is not
/// plain, or has no further field.
class PlainLine {
 public:
  explicit PlainLine(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

  /// Whether the line has another field; else it is over.
  bool has_more() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    return at_ != end_ && *at_ != '\n';
  }
  bool integer(long& value) { return has_more() && number(value); }
  /// A finite one.
  bool real(double& value) { return has_more() && number(value) && std::isfinite(value); }
  /// Goes past the end of the line. False if there are more fields.
  bool end() {
    if (has_more()) return false;
    if (at_ != end_) ++at_;
    return true;
  }

  [[nodiscard]] const char* at() const { return at_; }

 private:
  static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }

  template <class Number>
  bool number(Number& value) {
    const auto [end, status] = std::from_chars(at_, end_, value);
    at_ = end;
    return status == std::errc() && (end == end_ || *end == '\n' || is_blank(*end));
  }

  const char* at_;
  const char* end_;
};

/// Items of plain lines, one each.
template <class Item>
struct PlainLines {
  std::vector<Item> items;
  std::vector<int> lines;  ///< by item: its line, counted from 1
  std::size_t bytes = 0;   ///< that were read: whole lines
  int line_count = 0;      ///< in these
  bool is_all = false;     ///< the text ended; else it goes on with something else, or it is enough
};

/// Reads up to `most` items from the beginning of a text. `read(line, items)` reads the fields of a
/// line, and adds an item; false if it is not plain. Lines with nothing but blanks are passed.
template <class Item, class Read>
PlainLines<Item> read_plain_lines(std::string_view text, std::size_t most, const Read& read) {
  PlainLines<Item> out;
  while (out.bytes < text.size() && out.items.size() < most) {
    PlainLine line(text.substr(out.bytes));
    const bool is_empty = !line.has_more();
    const std::size_t before = out.items.size();
    if (!((is_empty || read(line, out.items)) && line.end())) {
      out.items.resize(before);
      return out;
    }
    out.bytes = static_cast<std::size_t>(line.at() - text.data());
    ++out.line_count;
    if (!is_empty) out.lines.push_back(out.line_count);
  }
  out.is_all = out.bytes == text.size();
  return out;
}

/// The beginning of a text in ranges of whole lines: at most so many.
inline std::vector<std::string_view> ranges_of_lines(std::string_view text, std::size_t most) {
  constexpr std::size_t kRange = 1 << 18;
  std::vector<std::string_view> ranges;
  while (!text.empty() && ranges.size() < most) {
    const std::size_t end = text.size() > kRange ? text.find('\n', kRange) : text.npos;
    ranges.push_back(text.substr(0, end == text.npos ? end : end + 1));
    text.remove_prefix(ranges.back().size());
  }
  return ranges;
}

/// Reads up to `most` items, `ranges` of some 256 kB at a time; `read` as for read_plain_lines(),
/// which must not mind what stands before its range. Line numbers count from the beginning of the
template <class Item, class Read>
std::vector<PlainLines<Item>> read_plain_ranges(std::string_view text, std::size_t most,
                                                std::size_t ranges, const Read& read,
                                                const Team& team) {
  const std::vector<std::string_view> texts = ranges_of_lines(text, ranges);
  std::vector<PlainLines<Item>> parts(texts.size());
  team.each(texts.size(),
            [&](std::size_t k) { parts[k] = read_plain_lines<Item>(texts[k], most, read); });
  std::size_t used = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].items.size() > most) parts[k] = read_plain_lines<Item>(texts[k], most, read);
    most -= parts[k].items.size();
    used = k + 1;
    if (!parts[k].is_all || most == 0) break;
  }
  parts.resize(used);
  return parts;
}

}  // namespace cover
