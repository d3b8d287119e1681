// Triangle's .poly and .node. A .poly has four sections, each headed by a line with its count:
// points (or none: then they are in the .node of the same name), segments, holes, and optionally
// regions. Whatever a header announces must be there, and nothing may follow. Fields of a line that
// no header announces are left out, as Triangle does, but with a warning.
// Format: https://www.cs.cmu.edu/~quake/triangle.poly.html.
// Tested by tests/unit/io/input/drawings/read_poly_test.cpp.
#include <cover/read_input.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "base/faults/out_of_memory.hpp"
#include "base/run_all.hpp"
#include "io/input/drawings/poly_lines.hpp"
#include "io/input/formats.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// Which index a number of the file stands for.
class Numbering {
 public:
  /// Adds the next index; returns the one that had the number before, if one had it.
  std::optional<std::uint32_t> add(long id) {
    if (others_.empty() && (size_ == 0 || from_first(id) == size_)) {
      if (size_ == 0) first_ = id;
      ++size_;
      return {};
    }
    if (const auto known = find(id)) return known;
    others_.emplace(id, static_cast<std::uint32_t>(size_ + others_.size()));
    return {};
  }
  /// Adds the next indices for `count` numbers from `id` on; false if one of them might be known.
  bool add_run(long id, std::size_t count) {
    if (!others_.empty() || (size_ != 0 && from_first(id) != size_)) return false;
    if (size_ == 0) first_ = id;
    size_ += count;
    return true;
  }
  [[nodiscard]] std::optional<std::uint32_t> find(long id) const {
    if (from_first(id) < size_) return static_cast<std::uint32_t>(from_first(id));
    const auto found = others_.find(id);
    if (found == others_.end()) return {};
    return found->second;
  }
  /// "; the points are 1 to 7", which tells a numbering from 0 from one from 1.
  [[nodiscard]] std::string known() const {
    if (size_ == 0) return "";
    long low = first_, high = first_ + static_cast<long>(size_) - 1;
    for (const auto& [id, index] : others_) {
      low = std::min(low, id);
      high = std::max(high, id);
    }
    return fmt::format("; the points are {} to {}", low, high);
  }

 private:
  /// How far `id` is from the first number; modulo 2^64, as any number may stand in a file.
  [[nodiscard]] std::uint64_t from_first(long id) const {
    return static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(first_);
  }

  // Nearly all files count: the first numbers need no table.
  long first_ = 0;
  std::size_t size_ = 0;
  std::unordered_map<long, std::uint32_t> others_;
};

/// Reads sections into an Input; the first error stops it and stays in `error()`.
class PolyReader : public PolyLines {
 public:
  using PolyLines::PolyLines;

  /// Reads the point section. A header with count 0 leaves `input` empty.
  bool read_points(Input& input);
  bool read_segments(Input& input);
  bool read_holes(Input& input);
  /// The section may be missing.
  bool read_regions(Input& input);
  /// Takes the numbering over from the reader of the .node file.
  void take_ids(PolyReader& other) { numbering_ = std::move(other.numbering_); }

 private:
  /// Of lines that are read one by one, so many are read before plain ones are looked for again.
  static constexpr std::size_t kOneByOne = 1000;

  struct PlainPoint {
    long id;
    Point at;
    int marker;
  };

  bool end_point(std::size_t field, long segment, std::uint32_t& index);
  bool point(Input& input, long attributes, bool has_markers);
  std::size_t read_plain_points(Input& input, std::size_t most, long attributes, bool has_markers);
  std::size_t read_plain_segments(Input& input, std::size_t most, bool has_markers);

  Numbering numbering_;
};

bool PolyReader::point(Input& input, long attributes, bool has_markers) {
  long id = 0;
  Point at;
  if (!integer(0, {"the number of a point"}, id) || !position({"point", id}, at)) {
    return false;
  }
  if (const auto first = numbering_.add(id)) {
    return fail(ErrorCode::syntax, fmt::format("there is already a point {} (line {})", id,
                                               input.point_lines[*first]));
  }
  input.points.push_back(at);
  input.point_ids.push_back(id);
  input.point_lines.push_back(line());
  check_surplus("a point", static_cast<std::size_t>(3 + attributes + (has_markers ? 1 : 0)));
  if (has_markers) {
    const auto field = static_cast<std::size_t>(3 + attributes);
    return marker(field, {"point", id}, input.point_markers.emplace_back(0));
  }
  return true;
}

/// The marker that may end a line. It is 0 where there is none.
bool read_marker(PlainLine& line, bool has_markers, int& marker) {
  long value = 0;
  if (has_markers && line.has_more() && !line.integer(value)) return false;
  marker = static_cast<int>(value);
  return marker == value;
}

/// Points whose numbers count on.
std::size_t PolyReader::read_plain_points(Input& input, std::size_t most, long attributes,
                                          bool has_markers) {
  const std::size_t first = input.points.size();
  const auto read = [&](PlainLine& line, std::vector<PlainPoint>& points) {
    PlainPoint p{};
    double ignored = 0;
    if (!line.integer(p.id) || !line.real(p.at.x) || !line.real(p.at.y)) return false;
    for (long k = 0; k < attributes && line.has_more(); ++k) {
      if (!line.real(ignored)) return false;
    }
    if (!read_marker(line, has_markers, p.marker)) return false;
    if (!points.empty() &&
        (points.back().id == std::numeric_limits<long>::max() || p.id != points.back().id + 1))
      return false;
    points.push_back(p);
    return true;
  };
  return read_plain<PlainPoint>(
      most, read,
      [&](const PlainLines<PlainPoint>& part) {
        return part.items.empty() || numbering_.add_run(part.items[0].id, part.items.size());
      },
      [&](std::size_t count) {
        input.points.resize(first + count);
        input.point_ids.resize(first + count);
        input.point_lines.resize(first + count);
        if (has_markers) input.point_markers.resize(first + count);
      },
      [&](const PlainLines<PlainPoint>& part, std::size_t place, int line) {
        for (std::size_t k = 0; k < part.items.size(); ++k) {
          const std::size_t v = first + place + k;
          input.points[v] = part.items[k].at;
          input.point_ids[v] = part.items[k].id;
          input.point_lines[v] = line + part.lines[k];
          if (has_markers) input.point_markers[v] = part.items[k].marker;
        }
      });
}

std::size_t PolyReader::read_plain_segments(Input& input, std::size_t most, bool has_markers) {
  struct Plain {
    long id;
    std::uint32_t a, b;
    int marker;
  };
  const std::size_t first = input.segments.size();
  const auto end = [&](PlainLine& line, std::uint32_t& index) {
    long id = 0;
    if (!line.integer(id)) return false;
    const std::optional<std::uint32_t> found = numbering_.find(id);
    index = found.value_or(0);
    return found.has_value();
  };
  const auto read = [&](PlainLine& line, std::vector<Plain>& segments) {
    Plain s{};
    if (!line.integer(s.id) || !end(line, s.a) || !end(line, s.b) ||
        !read_marker(line, has_markers, s.marker))
      return false;
    segments.push_back(s);
    return true;
  };
  return read_plain<Plain>(
      most, read, [](const PlainLines<Plain>&) { return true; },
      [&](std::size_t count) { input.segments.resize(first + count); },
      [&](const PlainLines<Plain>& part, std::size_t place, int line) {
        for (std::size_t k = 0; k < part.items.size(); ++k) {
          InputSegment& segment = input.segments[first + place + k];
          segment.id = part.items[k].id;
          segment.a = part.items[k].a;
          segment.b = part.items[k].b;
          segment.marker = part.items[k].marker;
          segment.line = line + part.lines[k];
        }
      });
}

bool PolyReader::read_points(Input& input) {
  std::size_t count = 0;
  if (!header("points", count)) return false;
  const long dimension = fields().size() > 1 ? optional_count(1) : 2;
  if (dimension != 2) {
    return fail(ErrorCode::syntax, fmt::format("the dimension is '{}', it must be 2", fields()[1]));
  }
  const long attributes = std::clamp(optional_count(2), 0L, 1L << 30U);
  const bool has_markers = optional_count(3) != 0;
  make_room(count, input.points);
  make_room(count, input.point_ids);
  make_room(count, input.point_lines);
  for (std::size_t k = 0, next_plain = 0; k < count; ++k) {
    if (k == next_plain) {
      k += read_plain_points(input, count - k, attributes, has_markers);
      next_plain = k + kOneByOne;
      if (k == count) break;
    }
    if (!next_line({.kind = "point", .number = static_cast<long>(k + 1), .of = count}) ||
        !point(input, attributes, has_markers)) {
      return false;
    }
  }
  return true;
}

bool PolyReader::end_point(std::size_t field, long segment, std::uint32_t& index) {
  long id = 0;
  if (!integer(field, {"segment", segment, ": the number of an end point"}, id)) {
    return false;
  }
  const auto found = numbering_.find(id);
  if (!found) {
    return fail(ErrorCode::id_out_of_range,
                fmt::format("segment {}: there is no point {}{}", segment, id, numbering_.known()));
  }
  index = *found;
  return true;
}

bool PolyReader::read_segments(Input& input) {
  std::size_t count = 0;
  if (!header("segments", count)) return false;
  const bool has_markers = optional_count(1) != 0;
  make_room(count, input.segments);
  for (std::size_t k = 0, next_plain = 0; k < count; ++k) {
    if (k == next_plain) {
      k += read_plain_segments(input, count - k, has_markers);
      next_plain = k + kOneByOne;
      if (k == count) break;
    }
    InputSegment segment;
    if (!next_line({.kind = "segment", .number = static_cast<long>(k + 1), .of = count}) ||
        !integer(0, {"the number of a segment"}, segment.id) ||
        !end_point(1, segment.id, segment.a) || !end_point(2, segment.id, segment.b)) {
      return false;
    }
    segment.line = line();
    if (has_markers && !marker(3, {"segment", segment.id}, segment.marker)) {
      return false;
    }
    check_surplus("a segment", has_markers ? 4 : 3);
    input.segments.push_back(segment);
  }
  return true;
}

bool PolyReader::read_holes(Input& input) {
  std::size_t count = 0;
  if (!header("holes", count)) return false;
  for (std::size_t k = 0; k < count; ++k) {
    HoleSeed hole;
    if (!next_line({.kind = "hole", .number = static_cast<long>(k + 1), .of = count}) ||
        !integer(0, {"the number of a hole"}, hole.id) || !position({"hole", hole.id}, hole.at)) {
      return false;
    }
    hole.line = line();
    check_surplus("a hole", 3);
    input.holes.push_back(hole);
  }
  return true;
}

bool PolyReader::read_regions(Input& input) {
  if (!next()) return true;
  std::size_t count = 0;
  if (!announced("regions", count)) return false;
  for (std::size_t k = 0; k < count; ++k) {
    RegionSeed seed;
    if (!next_line({.kind = "region", .number = static_cast<long>(k + 1), .of = count}) ||
        !integer(0, {"the number of a region"}, seed.id) ||
        !position({"region", seed.id}, seed.at)) {
      return false;
    }
    const auto& f = fields();
    seed.line = line();
    if (f.size() > 3) {
      const auto attribute = parse_double(f[3]);
      if (!attribute || !std::isfinite(*attribute)) {
        return fail(ErrorCode::syntax, fmt::format("region {}: the attribute '{}' is no number{}",
                                                   seed.id, f[3], hint_at_comma(f[3])));
      }
      seed.material = f[3];
    }
    if (f.size() > 4) {
      const auto area = parse_double(f[4]);
      if (!area || !std::isfinite(*area)) {
        return fail(ErrorCode::syntax,
                    fmt::format("region {}: the largest area '{}' is no number{}", seed.id, f[4],
                                hint_at_comma(f[4])));
      }
      // The edge length of the equilateral triangle of that area.
      if (*area > 0) seed.size = 2 * std::sqrt(*area / std::numbers::sqrt3);
    }
    check_surplus("a region", 5);
    input.seeds.push_back(std::move(seed));
  }
  input.seeds_may_miss = count > 0;
  return true;
}

/// Reads the points of a .poly that has none from the .node beside it.
std::optional<Error> read_node(const std::string& poly_path, const Team& team, PolyReader& poly,
                               Input& input) {
  const std::string path = std::filesystem::path(poly_path).replace_extension(".node").string();
  const Result<std::string> text = read_file(path);
  if (!text) {
    Error error = text.error();
    error.message += fmt::format(" ({} has no points of its own)", poly_path);
    return error;
  }
  PolyReader reader(*text, path, team);
  if (!reader.read_points(input) || !reader.expect_end()) return reader.error();
  reader.report_surplus(input);
  poly.take_ids(reader);
  return {};
}

Result<Input> parse_poly_by_team(std::string_view text, const std::string& source,
                                 const Team& team) {
  Input input;
  input.source = source;
  PolyReader reader(text, source, team);
  if (!reader.read_points(input)) return *reader.error();
  if (input.points.empty()) {
    if (auto error = read_node(source, team, reader, input)) return *error;
  }
  if (!reader.read_segments(input) || !reader.read_holes(input) || !reader.read_regions(input) ||
      !reader.expect_end()) {
    return *reader.error();
  }
  reader.report_surplus(input);
  return input;
}

}  // namespace

Result<Input> parse_poly(std::string_view text, const std::string& source,
                         const ReadOptions& options) {
  std::optional<Result<Input>> input;
  with_team(worker_count(options.threads),
            [&](const Team& team) { input.emplace(parse_poly_by_team(text, source, team)); });
  return *std::move(input);
}

}  // namespace cover
