// Tested by tests/unit/io/layout/read_gds_test.cpp.
#include "io/layout/gds_library.hpp"

#include <cmath>
#include <map>
#include <optional>

#include <fmt/core.h>

#include "io/layout/gds_records.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// Everything that an element may say, in whatever order.
struct Element {
  GdsRecord start;
  GdsShape shape;
  GdsPath path;
  GdsText text;
  GdsReference reference;
  std::vector<GdsPoint> points;
};

class LibraryReader {
 public:
  LibraryReader(std::string_view bytes, const std::string& source) : records_(bytes, source) {}

  Result<GdsLibrary> read() {
    if (next() && record_.type() != GdsType::header)
      fail(ErrorCode::syntax, "a GDSII file begins with the record HEADER");
    while (next() && record_.type() != GdsType::end_library) {
      if (record_.type() == GdsType::units) read_units();
      if (record_.type() == GdsType::begin_cell) read_cell();
    }
    if (!error_) link();
    if (error_) return *std::move(error_);
    return std::move(library_);
  }

 private:
  /// Goes on; false after an error.
  bool next() {
    if (error_) return false;
    Result<GdsRecord> record = records_.next();
    if (record) {
      record_ = *record;
    } else {
      error_ = std::move(record).error();
    }
    return !error_;
  }

  void fail(ErrorCode code, std::string_view what) {
    if (!error_) error_ = records_.error(code, record_, what);
  }

  void read_units() {
    library_.unit = record_.real_at(0);
    library_.metres = record_.real_at(1);
    if (!(library_.unit > 0 && library_.metres > 0 && std::isfinite(1 / library_.unit)))
      fail(ErrorCode::syntax, "the record UNITS needs two numbers above zero");
  }

  void read_cell() {
    GdsCell cell;
    while (next() && record_.type() != GdsType::end_cell) {
      switch (record_.type()) {
        case GdsType::cell_name:
          cell.name = record_.text();
          break;
        case GdsType::boundary:
        case GdsType::box:
        case GdsType::path:
        case GdsType::text:
        case GdsType::reference:
        case GdsType::array:
        case GdsType::node:
          read_element(cell);
          break;
        case GdsType::end_library:
        case GdsType::begin_cell:
          fail(ErrorCode::syntax, fmt::format("the cell '{}' does not end", legible(cell.name)));
          break;
        default:
          break;
      }
    }
    if (error_) return;
    const auto number = static_cast<std::uint32_t>(library_.cells.size());
    if (!numbers_.emplace(cell.name, number).second)
      fail(ErrorCode::syntax, fmt::format("there are two cells '{}'", legible(cell.name)));
    library_.cells.push_back(std::move(cell));
  }

  void read_element(GdsCell& cell) {
    Element element;
    element.start = record_;
    while (next() && record_.type() != GdsType::end_element) read_part(element);
    if (error_) return;
    record_ = element.start;  // what errors are about
    switch (element.start.type()) {
      case GdsType::boundary:
      case GdsType::box:
        add_polygon(cell, element);
        break;
      case GdsType::path:
        add_path(cell, element);
        break;
      case GdsType::text:
        if (element.points.empty()) return fail(ErrorCode::syntax, "a text without a place");
        element.text.at = element.points.front();
        element.text.layer = element.shape.layer;
        cell.texts.push_back(std::move(element.text));
        break;
      case GdsType::reference:
      case GdsType::array:
        add_reference(cell, element);
        break;
      default:
        break;  // a node is no geometry
    }
  }

  void read_part(Element& element) {
    switch (record_.type()) {
      case GdsType::layer:
        element.shape.layer.layer = record_.short_at(0);
        break;
      case GdsType::data_type:
      case GdsType::text_type:
      case GdsType::box_type:
        element.shape.layer.type = record_.short_at(0);
        break;
      case GdsType::width:
        element.path.width = record_.long_at(0);
        break;
      case GdsType::path_type:
        element.path.ends = record_.short_at(0);
        break;
      case GdsType::begin_extension:
        element.path.begin = record_.long_at(0);
        break;
      case GdsType::end_extension:
        element.path.end = record_.long_at(0);
        break;
      case GdsType::coordinates:
        for (std::size_t k = 0; 8 * k + 8 <= record_.bytes(); ++k)
          element.points.push_back({record_.long_at(2 * k), record_.long_at(2 * k + 1)});
        break;
      case GdsType::string:
        element.text.text = record_.text();
        break;
      case GdsType::referred_name:
        element.reference.name = record_.text();
        break;
      case GdsType::columns_rows:
        element.reference.columns = record_.short_at(0);
        element.reference.rows = record_.short_at(1);
        break;
      case GdsType::transform: {
        const auto bits = static_cast<std::uint16_t>(record_.short_at(0));
        element.reference.mirrored = (bits & 0x8000U) != 0;
        if ((bits & 0x6U) != 0) ++library_.absolute;
        break;
      }
      case GdsType::magnification:
        element.reference.magnification = record_.real_at(0);
        break;
      case GdsType::angle:
        element.reference.angle = record_.real_at(0);
        break;
      case GdsType::end_cell:
      case GdsType::begin_cell:
      case GdsType::end_library:
        record_ = element.start;
        fail(ErrorCode::syntax, "an element does not end");
        break;
      default:
        break;  // properties and the like
    }
  }

  void add_points(GdsShape& shape, const std::vector<GdsPoint>& points) {
    shape.first = static_cast<std::uint32_t>(library_.points.size());
    shape.count = static_cast<std::uint32_t>(points.size());
    library_.points.insert(library_.points.end(), points.begin(), points.end());
  }

  void add_polygon(GdsCell& cell, Element& element) {
    std::vector<GdsPoint>& points = element.points;
    while (points.size() > 1 && points.back() == points.front()) points.pop_back();
    if (points.size() < 3) {
      ++library_.left_out;
      return;
    }
    add_points(element.shape, points);
    cell.shapes.push_back(element.shape);
  }

  void add_path(GdsCell& cell, Element& element) {
    std::vector<GdsPoint> points;
    for (const GdsPoint p : element.points)
      if (points.empty() || points.back() != p) points.push_back(p);
    if (points.size() < 2) {
      ++library_.left_out;
      return;
    }
    add_points(element.shape, points);
    element.shape.path = static_cast<std::uint32_t>(library_.paths.size());
    library_.paths.push_back(element.path);
    cell.shapes.push_back(element.shape);
  }

  void add_reference(GdsCell& cell, Element& element) {
    GdsReference& reference = element.reference;
    const bool array = element.start.type() == GdsType::array;
    if (element.points.size() != (array ? 3U : 1U))
      return fail(ErrorCode::syntax,
                  fmt::format("{} needs {}", array ? "an array of cells" : "a cell in a cell",
                              array ? "three points" : "one point"));
    if (!array) reference.columns = reference.rows = 1;
    if (reference.columns < 1 || reference.rows < 1)
      return fail(ErrorCode::syntax, fmt::format("an array of {} columns and {} rows",
                                                 reference.columns, reference.rows));
    if (!(reference.magnification > 0 && std::isfinite(reference.magnification)))
      return fail(ErrorCode::syntax, "a magnification is a number above zero");
    reference.at.fill(element.points.front());
    std::copy(element.points.begin(), element.points.end(), reference.at.begin());
    reference.byte = element.start.at();
    cell.references.push_back(std::move(reference));
  }

  void link() {
    for (GdsCell& cell : library_.cells) {
      for (GdsReference& reference : cell.references) {
        const auto found = numbers_.find(reference.name);
        if (found == numbers_.end()) {
          record_ = GdsRecord(GdsType::reference, {}, reference.byte);
          return fail(ErrorCode::syntax, fmt::format("there is no cell '{}', which '{}' refers to",
                                                     legible(reference.name), legible(cell.name)));
        }
        reference.cell = found->second;
      }
    }
  }

  GdsRecords records_;
  GdsRecord record_;
  GdsLibrary library_;
  std::map<std::string, std::uint32_t> numbers_;
  std::optional<Error> error_;
};

}  // namespace

Result<GdsLibrary> parse_gds_library(std::string_view bytes, const std::string& source) {
  return LibraryReader(bytes, source).read();
}

}  // namespace cover
