// Tested by tests/unit/io/input/drawings/read_poly_test.cpp.
#include "io/input/drawings/poly_lines.hpp"

#include <fmt/core.h>

#include <cmath>

namespace cover {

std::string Wanted::text() const {
  std::string words(kind);
  if (number) words += fmt::format(" {}", *number);
  words += part;
  if (of) words += fmt::format(" of {}", *of);
  return words;
}

bool PolyLines::next_line(const Wanted& wanted) {
  if (lines_.next()) return true;
  return fail_count(ErrorCode::truncated,
                    fmt::format("the file ends where {} should follow", wanted.text()));
}

bool PolyLines::fail_count(ErrorCode code, std::string_view what) {
  return fail(code, counts_.empty() ? std::string(what)
                                    : fmt::format("{}; are the counts right? {}", what, counts_));
}

void PolyLines::check_surplus(std::string_view what, std::size_t expected) {
  const auto& f = lines_.fields();
  if (f.size() <= expected) return;
  if (++surplus_.lines > 1) return;
  surplus_.first = fmt::format(
      "{}:{}: '{}' and what follows is left out: the file announces {} "
      "fields for {}",
      lines_.source(), lines_.line(), f[expected], expected, what);
}

void PolyLines::report_surplus(Input& input) const {
  if (surplus_.lines == 0) return;
  input.warnings.push_back(
      surplus_.first + (surplus_.lines == 1 ? std::string()
                        : surplus_.lines == 2
                            ? "; 1 more line has too many"
                            : fmt::format("; {} more lines have too many", surplus_.lines - 1)));
}

bool PolyLines::header(std::string_view section, std::size_t& count) {
  return next_line({.kind = "the number of ", .part = section}) && announced(section, count);
}

bool PolyLines::announced(std::string_view section, std::size_t& count) {
  long value = 0;
  if (!integer(0, {.kind = "the number of ", .part = section}, value)) {
    if (counts_.empty()) error_->message += "; is this a .poly or .node file?";
    return false;
  }
  if (value < 0)
    return fail(ErrorCode::syntax, fmt::format("the number of {} is negative", section));
  count = static_cast<std::size_t>(value);
  counts_ +=
      fmt::format("{}{}: {} (line {})", counts_.empty() ? "" : ", ", section, count, lines_.line());
  return true;
}

bool PolyLines::integer(std::size_t field, const Wanted& what, long& value) {
  const auto& f = lines_.fields();
  if (field >= f.size())
    return fail_count(ErrorCode::syntax, fmt::format("{} is missing", what.text()));
  const auto parsed = parse_integer(f[field]);
  if (!parsed) {
    return fail(ErrorCode::syntax, fmt::format("{}: '{}' is no integer{}", what.text(),
                                               legible(f[field]), hint_at_comma(f[field])));
  }
  value = *parsed;
  return true;
}

bool PolyLines::coordinate(std::size_t field, const Wanted& what, double& value) {
  const char* const axis = field == 1 ? "x" : "y";
  const auto& f = lines_.fields();
  if (field >= f.size()) {
    return fail_count(ErrorCode::syntax,
                      fmt::format("{}: the {} coordinate is missing", what.text(), axis));
  }
  const auto parsed = parse_double(f[field]);
  if (!parsed) {
    return fail(ErrorCode::syntax,
                fmt::format("{}: the {} coordinate '{}' is no number{}", what.text(), axis,
                            legible(f[field]), hint_at_comma(f[field])));
  }
  if (!std::isfinite(*parsed)) {
    return fail(
        ErrorCode::non_finite_coordinate,
        fmt::format("{}: the {} coordinate '{}' is not finite", what.text(), axis, f[field]));
  }
  value = *parsed;
  return true;
}

bool PolyLines::position(const Wanted& what, Point& at) {
  return coordinate(1, what, at.x) && coordinate(2, what, at.y);
}

bool PolyLines::marker(std::size_t field, const Wanted& what, int& value) {
  long read = 0;
  if (field >= lines_.fields().size()) return true;
  Wanted part = what;
  part.part = ": the boundary marker";
  if (!integer(field, part, read)) return false;
  value = static_cast<int>(read);
  if (value == read) return true;
  return fail(ErrorCode::syntax,
              fmt::format("{}: the boundary marker {} is too large", what.text(), read));
}

bool PolyLines::expect_end() {
  if (!lines_.next()) return true;
  return fail_count(ErrorCode::syntax, "there are more lines than the counts announce");
}

}  // namespace cover
