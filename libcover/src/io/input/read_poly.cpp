// Triangle's .poly and .node. A .poly has four sections, each headed by a line with its count:
// points (or none: then they are in the .node of the same name), segments, holes, and optionally
// regions. Whatever a header announces must be there, and nothing may follow. Fields of a line that
// no header announces are left out, as Triangle does, but with a warning.
// Format: https://www.cs.cmu.edu/~quake/triangle.poly.html.
// Tested by tests/unit/io/input/read_poly_test.cpp.
#include <cover/read_input.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "base/out_of_memory.hpp"
#include "io/input/formats.hpp"
#include "io/input/poly_lines.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

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
  void take_ids(PolyReader& other) { index_of_id_ = std::move(other.index_of_id_); }

 private:
  /// "; the points are 1 to 7", which tells a numbering from 0 from one from 1.
  [[nodiscard]] std::string known_points() const;
  bool end_point(std::size_t field, long segment, std::uint32_t& index);
  bool point(Input& input, long attributes, bool has_markers);

  std::unordered_map<long, std::uint32_t> index_of_id_;
};

bool PolyReader::point(Input& input, long attributes, bool has_markers) {
  long id = 0;
  Point at;
  if (!integer(0, "the number of a point", id) || !position(fmt::format("point {}", id), at)) {
    return false;
  }
  const auto index = static_cast<std::uint32_t>(input.points.size());
  if (const auto [first, is_new] = index_of_id_.emplace(id, index); !is_new) {
    return fail(ErrorCode::syntax, fmt::format("there is already a point {} (line {})", id,
                                               input.point_lines[first->second]));
  }
  input.points.push_back(at);
  input.point_ids.push_back(id);
  input.point_lines.push_back(line());
  check_surplus("a point", static_cast<std::size_t>(3 + attributes + (has_markers ? 1 : 0)));
  if (has_markers) {
    const auto field = static_cast<std::size_t>(3 + attributes);
    return marker(field, fmt::format("point {}", id), input.point_markers.emplace_back(0));
  }
  return true;
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
  for (std::size_t k = 0; k < count; ++k) {
    if (!next_line(fmt::format("point {} of {}", k + 1, count)) ||
        !point(input, attributes, has_markers)) {
      return false;
    }
  }
  return true;
}

std::string PolyReader::known_points() const {
  if (index_of_id_.empty()) return "";
  const auto [low, high] =
      std::minmax_element(index_of_id_.begin(), index_of_id_.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; });
  return fmt::format("; the points are {} to {}", low->first, high->first);
}

bool PolyReader::end_point(std::size_t field, long segment, std::uint32_t& index) {
  long id = 0;
  if (!integer(field, fmt::format("segment {}: the number of an end point", segment), id)) {
    return false;
  }
  const auto found = index_of_id_.find(id);
  if (found == index_of_id_.end()) {
    return fail(ErrorCode::id_out_of_range,
                fmt::format("segment {}: there is no point {}{}", segment, id, known_points()));
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
    segment.line = line();
    if (has_markers && !marker(3, fmt::format("segment {}", segment.id), segment.marker)) {
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
    if (!next_line(fmt::format("hole {} of {}", k + 1, count)) ||
        !integer(0, "the number of a hole", hole.id) ||
        !position(fmt::format("hole {}", hole.id), hole.at)) {
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
    if (!next_line(fmt::format("region {} of {}", k + 1, count)) ||
        !integer(0, "the number of a region", seed.id) ||
        !position(fmt::format("region {}", seed.id), seed.at)) {
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
      if (*area > 0) seed.size = std::sqrt(*area * 4 / std::numbers::sqrt3);
    }
    check_surplus("a region", 5);
    input.seeds.push_back(std::move(seed));
  }
  return true;
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
  reader.report_surplus(input);
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
  reader.report_surplus(input);
  return input;
}

Result<Input> read_poly(const std::string& path) {
  return memory_as_value(path, [&]() -> Result<Input> {
    const Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return parse_poly(*text, path);
  });
}

}  // namespace cover
