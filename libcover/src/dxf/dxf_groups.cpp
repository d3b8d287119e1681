// Tested by tests/unit/dxf/read_dxf_test.cpp.
#include "dxf/dxf_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "dxf/group_text.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// A number that says what the value is, and the value.
struct Group {
  long code = 0;
  std::string_view value;
  int line = 0;  ///< of the value
};

constexpr std::array<std::string_view, 14> kKinds{
    "LINE",   "ARC",    "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE",
    "VERTEX", "INSERT", "POINT",  "TEXT",    "MTEXT",  "SEQEND",     "BLOCK"};
constexpr std::size_t kMostText = 1000;  // bytes of one group; dxflib cuts lines at 1024

bool is_real(long code) { return (code >= 10 && code <= 59) || (code >= 210 && code <= 239); }
bool is_whole(long code) { return (code >= 60 && code <= 79) || (code >= 90 && code <= 99); }
bool is_text(long code) { return code == 1 || code == 2 || code == 3 || code == 8; }

class Checker {
 public:
  Checker(std::string_view text, const std::string& source)
      : rest_(without_utf8_mark(text)), source_(source) {}

  Result<CheckedDxf> check() {
    if (rest_.starts_with("AutoCAD Binary DXF"))
      return Error{ErrorCode::unsupported_format,
                   fmt::format("{}: binary DXF is not read: save it as text (ASCII)", source_),
                   {},
                   {}};
    if (rest_.starts_with("AC10"))
      return Error{ErrorCode::unsupported_format,
                   fmt::format("{}: this is a DWG file: save it as DXF", source_),
                   {},
                   {}};
    advance();
    while (!error_ && !is(0, "EOF")) {
      if (is(0, "SECTION")) {
        advance();
        section();
      } else {
        advance();
      }
    }
    if (error_) return *std::move(error_);
    out_.text += "  0\nEOF\n";
    return std::move(out_);
  }

 private:
  void fail(ErrorCode code, int line, std::string_view what) {
    if (!error_) error_ = Error{code, fmt::format("{}:{}: {}", source_, line, what), {}, {}};
  }

  std::optional<std::string_view> next_line() {
    if (rest_.empty()) return std::nullopt;
    ++line_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(rest_.size(), end + 1));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    return line;
  }

  /// Goes on to the next group that is no comment.
  void advance() {
    do {
      const auto code = next_line();
      const auto value = code ? next_line() : std::nullopt;
      if (!value) return fail(ErrorCode::truncated, line_, "the file ends without EOF");
      const std::optional<long> number = parse_integer(*code);
      if (!number)
        return fail(ErrorCode::syntax, line_ - 1,
                    fmt::format("'{}' is no group code of DXF", legible(*code)));
      group_ = {*number, *value, line_};
    } while (group_.code == 999);
  }

  [[nodiscard]] bool is(long code, std::string_view value) const {
    return group_.code == code && group_.value == value;
  }
  [[nodiscard]] bool in_section() const {
    return !error_ && !is(0, "ENDSEC") && !is(0, "EOF") && !is(0, "SECTION");
  }

  void section() {
    if (error_ || group_.code != 2) return;
    const std::string name(group_.value);
    advance();
    if (name == "HEADER") return header();
    if (name == "TABLES") return tables();
    const bool drawn = name == "ENTITIES" || name == "BLOCKS";
    if (drawn) put("  0\nSECTION\n  2\n" + name);
    while (in_section()) {
      if (drawn && group_.code == 0) {
        entity();
      } else {
        advance();
      }
    }
    if (drawn) put("  0\nENDSEC");
  }

  void header() {
    std::string_view variable;
    for (; in_section(); advance()) {
      if (group_.code == 9) variable = group_.value;
      if (variable == "$INSUNITS" && group_.code == 70)
        out_.unit = static_cast<int>(parse_integer(group_.value).value_or(0));
      if (variable == "$DWGCODEPAGE" && group_.code == 3) code_page_ = group_.value;
    }
  }

  void tables() {
    while (in_section()) {
      const bool is_layer = is(0, "LAYER");
      advance();
      if (is_layer) layer();
    }
  }

  void layer() {
    constexpr long kFrozen = 1;
    std::string name;
    bool frozen = false, off = false;
    for (; !error_ && group_.code != 0; advance()) {
      if (group_.code == 2)
        name = group_text_in_utf8(group_.value, code_page_).substr(0, kMostText);
      if (group_.code == 70) frozen = (parse_integer(group_.value).value_or(0) & kFrozen) != 0;
      if (group_.code == 62) off = parse_integer(group_.value).value_or(0) < 0;
    }
    if (frozen || off) out_.hidden[lower(name)] = {name, frozen};
  }

  void put(std::string_view text) {
    out_.text += text;
    out_.text += '\n';
  }
  void put(long code, std::string_view value) {
    out_.text += fmt::format("{:3}\n{}\n", code, value);
  }

  void entity() {
    const std::string_view kind = group_.value;
    const int line = group_.line;
    std::vector<Group> groups;
    bool paper = false, invisible = false;
    for (advance(); !error_ && group_.code != 0; advance()) {
      paper |= group_.code == 67 && group_.value == "1";
      invisible |= group_.code == 60 && group_.value == "1";
      if (is_real(group_.code) || is_whole(group_.code) || is_text(group_.code))
        groups.push_back(group_);
    }
    if (error_) return;
    if (kind == "ENDBLK") return put("  0\nENDBLK");
    const bool known = std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
    const bool inner = kind == "VERTEX" || kind == "SEQEND";
    const bool counts = known && !inner && kind != "BLOCK";
    if (paper) {  // whether a sheet's windows and tables are left out, nobody asks
      if (counts) ++out_.in_paper_space;
      return;
    }
    if (invisible && counts) {
      ++out_.invisible;
      return;
    }
    if (!known || (inner && !in_polyline_)) {
      if (!inner && kind != "ATTRIB" && kind != "ATTDEF") ++out_.left_out[legible(kind)];
      return;
    }
    // The end of a sequence of attributes is not one of vertices.
    if (kind == "POLYLINE") in_polyline_ = true;
    if (kind == "SEQEND") in_polyline_ = false;
    note_width(kind, groups);
    put(0, kind);
    put_counts(kind, groups);
    for (const Group& g : groups) put_group(kind, g);
    if (in_polyline_ && !inner && kind != "POLYLINE")
      fail(ErrorCode::syntax, line, "a polyline does not end before the next entity");
  }

  /// Widths stand with a polyline, for all of it, and with its corners.
  void note_width(std::string_view kind, const std::vector<Group>& groups) {
    const bool is_light = kind == "LWPOLYLINE";
    if (is_light || kind == "POLYLINE") out_.wide.push_back(false);
    if (!is_light && !in_polyline_) return;
    for (const Group& g : groups)
      if ((g.code == 40 || g.code == 41 || (is_light && g.code == 43)) &&
          parse_double(g.value).value_or(0) > 0)
        out_.wide.back() = true;
  }

  /// What dxflib takes memory for, as it is and not as it is announced.
  void put_counts(std::string_view kind, const std::vector<Group>& groups) {
    const auto count = [&](long code) {
      return std::to_string(std::count_if(groups.begin(), groups.end(),
                                          [&](const Group& g) { return g.code == code; }));
    };
    if (kind == "LWPOLYLINE") put(90, count(10));
    if (kind != "SPLINE") return;
    put(72, count(40));
    put(73, count(10));
    put(74, count(11));
  }

  static bool is_count(std::string_view kind, long code) {
    return (kind == "LWPOLYLINE" && code == 90) || (kind == "SPLINE" && code >= 72 && code <= 74);
  }

  void put_group(std::string_view kind, const Group& g) {
    if (is_count(kind, g.code)) return;
    if (is_text(g.code))
      return put(g.code, group_text_in_utf8(g.value, code_page_).substr(0, kMostText));
    if (is_whole(g.code)) {
      const std::optional<long> number = parse_integer(g.value);
      if (!number || std::abs(static_cast<double>(*number)) > 2e9)
        return fail(ErrorCode::syntax, g.line,
                    fmt::format("'{}' is no whole number", legible(g.value)));
      return put(g.code, g.value);
    }
    const std::optional<double> number = parse_double(g.value);
    if (!number)
      return fail(ErrorCode::syntax, g.line,
                  fmt::format("'{}' is no number{}", legible(g.value), hint_at_comma(g.value)));
    if (!std::isfinite(*number))
      return fail(ErrorCode::non_finite_coordinate, g.line,
                  fmt::format("'{}' is not finite", legible(g.value)));
    put(g.code, fmt::format("{}", *number));  // the shortest that is the same double
  }

  std::string_view rest_;
  const std::string& source_;
  int line_ = 0;
  Group group_;
  std::string_view code_page_;
  bool in_polyline_ = false;
  CheckedDxf out_;
  std::optional<Error> error_;
};

}  // namespace

Result<CheckedDxf> check_dxf(std::string_view text, const std::string& source) {
  return Checker(text, source).check();
}

}  // namespace cover
