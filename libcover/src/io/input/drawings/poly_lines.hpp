// The lines of Triangle's .poly and .node: fields as numbers, sections headed by their counts.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/input.hpp>

#include "base/team.hpp"
#include "io/text/plain_lines.hpp"
#include "io/text/text.hpp"

namespace cover {

/// What is being read, in words that are put together for an error only: they would take longer
/// than the reading.
struct Wanted {
  std::string_view kind;               ///< "point"
  std::optional<long> number = {};     ///< as the file has it
  std::string_view part = {};          ///< of the element; ": the boundary marker"
  std::optional<std::size_t> of = {};  ///< how many there are

  [[nodiscard]] std::string text() const;
};

/// A LineReader whose readings say whether they went well; the first error stays in `error()`, with
/// file and line. `what` names in errors what is read.
class PolyLines {
 public:
  PolyLines(std::string_view text, const std::string& source, const Team& team = {})
      : lines_(without_utf8_mark(text), source, '#'), team_(team) {}

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  /// Nothing but comments may be left.
  bool expect_end();
  /// Adds what was left out to the warnings of `input`.
  void report_surplus(Input& input) const;

 protected:
  bool fail(ErrorCode code, std::string_view what) {
    error_ = lines_.error(code, what);
    return false;
  }

  /// Goes on to the next line; false at the end of the text.
  bool next() { return lines_.next(); }
  bool next_line(const Wanted& wanted);
  /// The next line, which begins with a count.
  bool header(std::string_view section, std::size_t& count);
  /// The count that this line begins with.
  bool announced(std::string_view section, std::size_t& count);
  /// Room in `values` for `count` more lines, each of some bytes, as far as the file can hold them.
  template <class T>
  void make_room(std::size_t count, std::vector<T>& values) const {
    constexpr std::size_t kShortestLine = 6;  // "1 0 0\n"
    values.reserve(values.size() + std::min(count, lines_.left() / kShortestLine));
  }
  /// Reads up to `most` items from plain lines (plain_lines.hpp), as long as they follow each
  /// other; returns how many. `put(part, place, line)` puts the items of a range to their places,
  /// the first of all to 0, and counts its lines from `line` on; others do so at the same time.
  template <class Item, class Read, class Follows, class MakeRoom, class Put>
  std::size_t read_plain(std::size_t most, const Read& read, const Follows& follows,
                         const MakeRoom& make_room, const Put& put) {
    constexpr std::size_t kMostRanges = 32;
    std::size_t done = 0;
    bool goes_on = true;
    for (std::size_t ranges = 1; goes_on && done < most;) {
      const auto parts = read_plain_ranges<Item>(lines_.rest(), most - done, ranges, read, team_);
      goes_on = !parts.empty();
      std::vector<std::size_t> places;
      std::vector<int> lines;
      for (const PlainLines<Item>& part : parts) {
        goes_on = follows(part);
        if (!goes_on) break;
        goes_on = part.is_all;
        places.push_back(done);
        lines.push_back(lines_.line());
        lines_.pass(part.bytes, part.line_count);
        done += part.items.size();
      }
      make_room(done);
      team_.each(places.size(), [&](std::size_t k) { put(parts[k], places[k], lines[k]); });
      ranges = team_.workers() > 1 ? std::min(2 * ranges, kMostRanges) : 1;
    }
    return done;
  }
  /// Notes that a line of the kind `what` has more fields than the `expected` ones.
  void check_surplus(std::string_view what, std::size_t expected);

  [[nodiscard]] int line() const { return lines_.line(); }
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return lines_.fields(); }
  bool integer(std::size_t field, const Wanted& what, long& value);
  /// Fields 1 and 2.
  bool position(const Wanted& what, Point& at);
  /// A boundary marker; 0 where the field is missing.
  bool marker(std::size_t field, const Wanted& what, int& value);
  /// A count from a header that may not be there (then 0).
  [[nodiscard]] long optional_count(std::size_t field) const {
    const auto& f = fields();
    return field < f.size() ? parse_integer(f[field]).value_or(0) : 0;
  }

 private:
  /// Fields that are left out.
  struct Surplus {
    std::string first;      ///< where, and what
    std::size_t lines = 0;  ///< that have some
  };

  /// An error that a wrong count may be the cause of.
  bool fail_count(ErrorCode code, std::string_view what);
  bool coordinate(std::size_t field, const Wanted& what, double& value);

  LineReader lines_;
  Team team_;
  std::optional<Error> error_;
  std::string counts_;  ///< what the headers so far announce, in words
  Surplus surplus_;
};

}  // namespace cover
