// Tested by tests/unit/vtk/read_output_test.cpp and the seeds of tests/fuzz.
#include "vtk/sound_cells.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include <vtkCellArray.h>
#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

namespace cover {
namespace {

constexpr std::array<std::string_view, 5> kCellKeywords{"CELLS", "POLYGONS", "LINES", "VERTICES",
                                                        "TRIANGLE_STRIPS"};

/// The text of a legacy file, from a position on.
class LegacyText {
 public:
  explicit LegacyText(std::string_view text) : left_(text) {}

  [[nodiscard]] bool at_end() const { return left_.empty(); }

  std::string_view line() {
    const std::size_t end = std::min(left_.find('\n'), left_.size());
    const std::string_view out = left_.substr(0, end);
    left_.remove_prefix(std::min(end + 1, left_.size()));
    return out;
  }

  std::optional<std::int64_t> number() {
    const std::size_t start = std::min(left_.find_first_not_of(" \t\r\n"), left_.size());
    left_.remove_prefix(start);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
    if (error != std::errc()) return std::nullopt;
    left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
    return value;
  }

  /// Four bytes, the highest first.
  std::optional<std::int64_t> binary_number() {
    if (left_.size() < 4) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8U | static_cast<unsigned char>(left_[k]);
    left_.remove_prefix(4);
    return static_cast<std::int32_t>(value);
  }

 private:
  std::string_view left_;
};

/// `size` numbers make up `count` cells, each of which begins with the number of its nodes.
bool is_sound(LegacyText& text, std::int64_t count, std::int64_t size, bool binary) {
  const auto next = [&] { return binary ? text.binary_number() : text.number(); };
  for (; count > 0; --count) {
    const auto nodes = next();
    if (!nodes || *nodes < 0 || *nodes >= size) return false;
    size -= 1 + *nodes;
    for (std::int64_t k = 0; k < *nodes; ++k)
      if (!next()) return false;
  }
  return count == 0 && size == 0;
}

/// From version 5 on: a line with `keyword` and a type, then `count` integers.
bool has_array(LegacyText& text, std::string_view keyword, std::int64_t count, bool binary) {
  std::string_view line = text.line();
  while (line.empty() && !text.at_end()) line = text.line();  // what is left of the line before
  if (!line.starts_with(keyword)) return false;
  const bool wide = line.find("64") != std::string_view::npos || line.ends_with("long") ||
                    line.ends_with("vtkIdType");
  if (binary && wide) count *= 2;
  for (; count > 0; --count)
    if (!(binary ? text.binary_number() : text.number())) return false;
  (void)text.line();
  return true;
}

/// 1 to 9, or 0 where the first line is not exactly what all writers write: VTK makes something of
/// it then, and we could not tell what.
int major_version(std::string_view line) {
  constexpr std::string_view kHead = "# vtk DataFile Version ";
  if (!line.starts_with(kHead)) return 0;
  line.remove_prefix(kHead.size());
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (line.size() < 3 || line[0] == '0' || !is_digit(line[0]) || line[1] != '.' ||
      !is_digit(line[2]))
    return 0;
  return line.find_first_not_of(" \t\r", 3) == std::string_view::npos ? line[0] - '0' : 0;
}

/// Whether a line that says how many numbers follow, `POINTS 6 double` or an array's
/// `name 1 4 int`, names no more than there are letters, and none below 0.
bool has_possible_counts(std::string_view line, std::int64_t letters) {
  constexpr std::array<std::string_view, 4> kCounting{"POINTS", "CELL_TYPES", "CELL_DATA",
                                                      "POINT_DATA"};
  std::array<std::string_view, 5> words;
  std::size_t count = 0;
  for (std::string_view rest = line; count < words.size();) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r"), rest.size()));
    if (rest.empty()) break;
    const std::size_t end = std::min(rest.find_first_of(" \t\r"), rest.size());
    words[count++] = rest.substr(0, end);
    rest.remove_prefix(end);
  }
  const auto is_possible = [&](std::string_view word) {
    const auto value = LegacyText(word).number();
    return value && *value >= 0 && *value <= letters;
  };
  const bool counts = std::find(kCounting.begin(), kCounting.end(), words[0]) != kCounting.end();
  if (counts && count > 1) return is_possible(words[1]);
  const auto is_number = [](std::string_view word) {
    return word.find_first_not_of("-0123456789") == std::string_view::npos;
  };
  const bool array =
      count == 4 && is_number(words[1]) && is_number(words[2]) && !is_number(words[3]);
  return !array || (is_possible(words[1]) && is_possible(words[2]));
}

bool is_cell_keyword(std::string_view word) {
  for (const std::string_view keyword : kCellKeywords)
    if (word == keyword) return true;
  return false;
}

/// Each cell has at least `least` nodes, of `points`.
bool is_sound(vtkCellArray* cells, vtkIdType points, vtkIdType least) {
  if (cells == nullptr) return true;
  const vtkIdType last = cells->GetNumberOfConnectivityIds();
  vtkIdType before = 0;
  for (vtkIdType c = 0; c <= cells->GetNumberOfCells() && cells->GetNumberOfOffsets() > 0; ++c) {
    const auto offset = static_cast<vtkIdType>(cells->GetOffsetsArray()->GetComponent(c, 0));
    if (offset < before || offset > last || (c == 0 && offset != 0)) return false;
    if (c > 0 && offset - before < least) return false;
    before = offset;
  }
  vtkDataArray* nodes = cells->GetConnectivityArray();
  for (vtkIdType k = 0; k < last; ++k) {
    const double node = nodes->GetComponent(k, 0);
    if (!(node >= 0 && node < static_cast<double>(points))) return false;
  }
  return true;
}

}  // namespace

bool has_sound_cells(std::string_view legacy_text) {
  LegacyText text(legacy_text);
  const int version = major_version(text.line());
  if (version == 0) return false;
  (void)text.line();  // the title
  const bool binary = text.line().starts_with("BINARY");
  while (!text.at_end()) {
    const std::string_view line = text.line();
    const std::size_t end = std::min(line.find(' '), line.size());
    if (!has_possible_counts(line, static_cast<std::int64_t>(legacy_text.size()))) return false;
    if (!is_cell_keyword(line.substr(0, end))) continue;
    LegacyText numbers(line.substr(end));
    const auto count = numbers.number(), size = numbers.number();
    if (!count || !size || *count < 0 || *size < 0) return false;
    const bool sound = version >= 5 ? has_array(text, "OFFSETS", *count, binary) &&
                                          has_array(text, "CONNECTIVITY", *size, binary)
                                    : is_sound(text, *count, *size, binary);
    if (!sound) return false;
  }
  return true;
}

bool has_sound_cells(vtkDataSet& data) {
  const vtkIdType points = data.GetNumberOfPoints();
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data)) {
    vtkCellArray* cells = grid->GetCells();
    const vtkIdType types =
        grid->GetCellTypesArray() == nullptr ? 0 : grid->GetCellTypesArray()->GetNumberOfTuples();
    return is_sound(cells, points, 0) && (cells == nullptr || cells->GetNumberOfCells() == types);
  }
  if (auto* surface = vtkPolyData::SafeDownCast(&data)) {
    return is_sound(surface->GetVerts(), points, 1) && is_sound(surface->GetLines(), points, 2) &&
           is_sound(surface->GetPolys(), points, 3) && is_sound(surface->GetStrips(), points, 3);
  }
  return true;
}

}  // namespace cover
