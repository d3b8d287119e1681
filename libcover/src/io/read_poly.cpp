// Triangle's .poly and .node. A .poly has four sections, each headed by a line with its count:
// points (or none: then they are in the .node of the same name), segments, holes, and optionally
// regions. Whatever a header announces must be there, and nothing may follow.
// Format: https://www.cs.cmu.edu/~quake/triangle.poly.html. Tested by
// tests/unit/io/read_poly_test.cpp.
#include <cover/read_input.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "io/formats.hpp"
#include "io/text.hpp"

namespace cover {
namespace {

/// Reads sections into an Input; the first error stops it and stays in `error()`.
class PolyReader {
 public:
  PolyReader(std::string_view text, const std::string& source) : lines_(text, source, '#') {}

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  /// Reads the point section. A header with count 0 leaves `input` empty.
  bool read_points(Input& input);
  bool read_segments(Input& input);
  bool read_holes(Input& input);
  /// The section may be missing.
  bool read_regions(Input& input);
  /// Nothing but comments may be left.
  bool expect_end();
  /// Takes the numbering over from the reader of the .node file.
  void take_ids(PolyReader& other) { index_of_id_ = std::move(other.index_of_id_); }

 private:
  bool fail(ErrorCode code, std::string_view what) {
    error_ = lines_.error(code, what);
    return false;
  }
  bool next_line(std::string_view wanted);
  bool header(std::string_view section, std::size_t& count);
  bool integer(std::size_t field, std::string_view what, long& value);
  bool coordinate(std::size_t field, std::string_view what, double& value);
  bool position(std::string_view what, Point& at);
  /// A boundary marker; 0 where the field is missing.
  bool marker(std::size_t field, std::string_view what, int& value);
  bool end_point(std::size_t field, long segment, std::uint32_t& index);
  bool point(Input& input, long attributes, bool has_markers);
  /// A count from a header that may not be there (then 0).
  [[nodiscard]] long optional_count(std::size_t field) const {
    const auto& f = lines_.fields();
    return field < f.size() ? parse_integer(f[field]).value_or(0) : 0;
  }

  LineReader lines_;
  std::optional<Error> error_;
  std::unordered_map<long, std::uint32_t> index_of_id_;
};

bool PolyReader::next_line(std::string_view wanted) {
  if (lines_.next()) return true;
  return fail(ErrorCode::truncated, fmt::format("the file ends where {} should follow", wanted));
}

bool PolyReader::header(std::string_view section, std::size_t& count) {
  long value = 0;
  if (!next_line(fmt::format("the number of {}", section)) ||
      !integer(0, fmt::format("the number of {}", section), value)) {
    return false;
  }
  if (value < 0)
    return fail(ErrorCode::syntax, fmt::format("the number of {} is negative", section));
  count = static_cast<std::size_t>(value);
  return true;
}

bool PolyReader::integer(std::size_t field, std::string_view what, long& value) {
  const auto& f = lines_.fields();
  if (field >= f.size()) return fail(ErrorCode::syntax, fmt::format("{} is missing", what));
  const auto parsed = parse_integer(f[field]);
  if (!parsed)
    return fail(ErrorCode::syntax, fmt::format("{}: '{}' is no integer", what, f[field]));
  value = *parsed;
  return true;
}

bool PolyReader::coordinate(std::size_t field, std::string_view what, double& value) {
  const char* const axis = field == 1 ? "x" : "y";
  const auto& f = lines_.fields();
  if (field >= f.size()) {
    return fail(ErrorCode::syntax, fmt::format("{}: the {} coordinate is missing", what, axis));
  }
  const auto parsed = parse_double(f[field]);
  if (!parsed) {
    return fail(ErrorCode::syntax,
                fmt::format("{}: the {} coordinate '{}' is no number", what, axis, f[field]));
  }
  if (!std::isfinite(*parsed)) {
    return fail(ErrorCode::non_finite_coordinate,
                fmt::format("{}: the {} coordinate '{}' is not finite", what, axis, f[field]));
  }
  value = *parsed;
  return true;
}

bool PolyReader::position(std::string_view what, Point& at) {
  return coordinate(1, what, at.x) && coordinate(2, what, at.y);
}

bool PolyReader::marker(std::size_t field, std::string_view what, int& value) {
  long read = 0;
  if (field >= lines_.fields().size()) return true;
  if (!integer(field, fmt::format("{}: the boundary marker", what), read)) return false;
  value = static_cast<int>(read);
  if (value == read) return true;
  return fail(ErrorCode::syntax,
              fmt::format("{}: the boundary marker {} is too large", what, read));
}

bool PolyReader::point(Input& input, long attributes, bool has_markers) {
  long id = 0;
  Point at;
  if (!integer(0, "the number of a point", id) || !position(fmt::format("point {}", id), at)) {
    return false;
  }
  const auto index = static_cast<std::uint32_t>(input.points.size());
  if (!index_of_id_.emplace(id, index).second) {
    return fail(ErrorCode::syntax, fmt::format("there is already a point {}", id));
  }
  input.points.push_back(at);
  input.point_ids.push_back(id);
  input.point_lines.push_back(lines_.line());
  if (has_markers) {
    const auto field = static_cast<std::size_t>(3 + attributes);
    return marker(field, fmt::format("point {}", id), input.point_markers.emplace_back(0));
  }
  return true;
}

bool PolyReader::read_points(Input& input) {
  std::size_t count = 0;
  if (!header("points", count)) return false;
  const long dimension = lines_.fields().size() > 1 ? optional_count(1) : 2;
  if (dimension != 2) {
    return fail(ErrorCode::syntax,
                fmt::format("the dimension is '{}', it must be 2", lines_.fields()[1]));
  }
  const long attributes = std::max(0L, optional_count(2));
  const bool has_markers = optional_count(3) != 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!next_line(fmt::format("point {} of {}", k + 1, count)) ||
        !point(input, attributes, has_markers)) {
      return false;
    }
  }
  return true;
}

bool PolyReader::end_point(std::size_t field, long segment, std::uint32_t& index) {
  long id = 0;
  if (!integer(field, fmt::format("segment {}: the number of an end point", segment), id)) {
    return false;
  }
  const auto found = index_of_id_.find(id);
  if (found == index_of_id_.end()) {
    return fail(ErrorCode::id_out_of_range,
                fmt::format("segment {}: there is no point {}", segment, id));
  }
  index = found->second;
  return true;
}

bool PolyReader::read_segments(Input& input) {
  std::size_t count = 0;
  if (!header("segments", count)) return false;
  const bool has_markers = optional_count(1) != 0;
  for (std::size_t k = 0; k < count; ++k) {
    InputSegment segment;
    if (!next_line(fmt::format("segment {} of {}", k + 1, count)) ||
        !integer(0, "the number of a segment", segment.id) ||
        !end_point(1, segment.id, segment.a) || !end_point(2, segment.id, segment.b)) {
      return false;
    }
    segment.line = lines_.line();
    if (has_markers && !marker(3, fmt::format("segment {}", segment.id), segment.marker)) {
      return false;
    }
    input.segments.push_back(segment);
  }
  return true;
}

bool PolyReader::read_holes(Input& input) {
  std::size_t count = 0;
  if (!header("holes", count)) return false;
  for (std::size_t k = 0; k < count; ++k) {
    HoleSeed hole;
    if (!next_line(fmt::format("hole {} of {}", k + 1, count)) ||
        !integer(0, "the number of a hole", hole.id) ||
        !position(fmt::format("hole {}", hole.id), hole.at)) {
      return false;
    }
    hole.line = lines_.line();
    input.holes.push_back(hole);
  }
  return true;
}

bool PolyReader::read_regions(Input& input) {
  if (!lines_.next()) return true;
  long count = 0;
  if (!integer(0, "the number of regions", count)) return false;
  for (long k = 0; k < count; ++k) {
    RegionSeed seed;
    if (!next_line(fmt::format("region {} of {}", k + 1, count)) ||
        !integer(0, "the number of a region", seed.id) ||
        !position(fmt::format("region {}", seed.id), seed.at)) {
      return false;
    }
    const auto& f = lines_.fields();
    seed.line = lines_.line();
    if (f.size() > 3) {
      const auto attribute = parse_double(f[3]);
      if (!attribute || !std::isfinite(*attribute)) {
        return fail(ErrorCode::syntax,
                    fmt::format("region {}: the attribute '{}' is no number", seed.id, f[3]));
      }
      seed.material = f[3];
    }
    if (f.size() > 4) {
      const auto area = parse_double(f[4]);
      if (!area || !std::isfinite(*area)) {
        return fail(ErrorCode::syntax,
                    fmt::format("region {}: the largest area '{}' is no number", seed.id, f[4]));
      }
      // The edge length of the equilateral triangle of that area.
      if (*area > 0) seed.size = std::sqrt(*area * 4 / std::numbers::sqrt3);
    }
    input.seeds.push_back(std::move(seed));
  }
  return true;
}

bool PolyReader::expect_end() {
  if (!lines_.next()) return true;
  return fail(ErrorCode::syntax, "there are more lines than the counts in the file announce");
}

/// Reads the points of a .poly that has none from the .node beside it.
std::optional<Error> read_node(const std::string& poly_path, PolyReader& poly, Input& input) {
  const std::string path = std::filesystem::path(poly_path).replace_extension(".node").string();
  const Result<std::string> text = read_file(path);
  if (!text) {
    Error error = text.error();
    error.message += fmt::format(" ({} has no points of its own)", poly_path);
    return error;
  }
  PolyReader reader(*text, path);
  if (!reader.read_points(input) || !reader.expect_end()) return reader.error();
  poly.take_ids(reader);
  return {};
}

}  // namespace

Result<Input> parse_poly(std::string_view text, const std::string& source) {
  Input input;
  input.source = source;
  PolyReader reader(text, source);
  if (!reader.read_points(input)) return *reader.error();
  if (input.points.empty()) {
    if (auto error = read_node(source, reader, input)) return *error;
  }
  if (!reader.read_segments(input) || !reader.read_holes(input) || !reader.read_regions(input) ||
      !reader.expect_end()) {
    return *reader.error();
  }
  return input;
}

Result<Input> read_poly(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  return parse_poly(*text, path);
}

}  // namespace cover
