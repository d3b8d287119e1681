// Tested by tests/unit/io/input/meshes/read_size_field_test.cpp.
#include "io/input/meshes/plane_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "cdt/cdt.hpp"
#include "geom/predicates.hpp"
#include "geom/triangle.hpp"
#include "io/images/raster.hpp"
#include "io/input/formats.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/read_data_set.hpp"

namespace cover {
namespace {

constexpr const char* kFieldOfRaster =
    "of a raster, 'gdal_translate -of XYZ FILE OUT.csv' makes points x,y,h that can be read";

using Nodes = std::span<const std::uint32_t>;

/// Cuts plane cells into triangles.
class Cutter {
 public:
  explicit Cutter(PlaneField& field) : field_(field) {}

  void add(int type, Nodes nodes) {
    using namespace cell_type;
    const auto has = [&](std::size_t count) { return nodes.size() >= count; };
    switch (type) {
      case kTriangle:
      case kLagrangeTriangle:
      case kBezierTriangle:
        return parts(nodes, {{0, 1, 2}});
      case kQuadraticTriangle:
        if (!has(6)) return parts(nodes, {{0, 1, 2}});
        return parts(nodes, {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {4, 5, 3}});
      case kBiquadraticTriangle:
        if (!has(7)) return parts(nodes, {{0, 1, 2}});
        return parts(nodes, {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 6}, {4, 5, 6}, {5, 3, 6}});
      case kTriangleStrip:
        for (std::size_t k = 2; k < nodes.size(); ++k) parts(nodes.subspan(k - 2, 3), {{0, 1, 2}});
        return;
      case kPixel:
        return parts(nodes, {{0, 1, 3}, {0, 3, 2}});
      case kQuad:
      case kLagrangeQuad:
      case kBezierQuad:
        return quad({nodes[0], nodes[1], nodes[2], nodes[3]});
      case kQuadraticLinearQuad:
        if (!has(6)) return quad({nodes[0], nodes[1], nodes[2], nodes[3]});
        quad({nodes[0], nodes[4], nodes[5], nodes[3]});
        return quad({nodes[4], nodes[1], nodes[2], nodes[5]});
      case kQuadraticQuad:
        if (!has(8)) return quad({nodes[0], nodes[1], nodes[2], nodes[3]});
        parts(nodes, {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}});
        return quad({nodes[4], nodes[5], nodes[6], nodes[7]});
      case kBiquadraticQuad:
        if (!has(9)) return quad({nodes[0], nodes[1], nodes[2], nodes[3]});
        return parts(nodes, {{0, 4, 7},
                             {4, 8, 7},
                             {4, 1, 8},
                             {1, 5, 8},
                             {7, 8, 3},
                             {8, 6, 3},
                             {8, 5, 6},
                             {5, 2, 6}});
      case kPolygon:
        return polygon(nodes);
      case kQuadraticPolygon: {
        // Corners first, then the midpoints of the sides.
        std::vector<std::uint32_t> around;
        for (std::size_t k = 0; k < nodes.size() / 2; ++k) {
          around.push_back(nodes[k]);
          around.push_back(nodes[nodes.size() / 2 + k]);
        }
        return polygon(around);
      }
      default:
        return;
    }
  }

 private:
  [[nodiscard]] Point at(std::uint32_t node) const { return field_.points[node]; }

  void parts(Nodes nodes, std::initializer_list<std::array<std::size_t, 3>> triangles) {
    for (const auto& [a, b, c] : triangles)
      field_.triangles.push_back({nodes[a], nodes[b], nodes[c]});
  }

  /// Two triangles on its shorter diagonal.
  void quad(const std::array<std::uint32_t, 4>& q) {
    const auto length = [&](std::uint32_t a, std::uint32_t b) {
      return std::hypot(at(a).x - at(b).x, at(a).y - at(b).y);
    };
    if (length(q[0], q[2]) <= length(q[1], q[3])) return parts(q, {{0, 1, 2}, {0, 2, 3}});
    parts(q, {{0, 1, 3}, {1, 2, 3}});
  }

  void polygon(Nodes nodes) {
    if (nodes.size() < 3) return;
    if (nodes.size() == 4) return quad({nodes[0], nodes[1], nodes[2], nodes[3]});
    if (nodes.size() > 4 && !is_convex(nodes) && cut_by_sides(nodes)) return;
    for (std::size_t k = 2; k < nodes.size(); ++k)
      field_.triangles.push_back({nodes[0], nodes[k - 1], nodes[k]});
  }

  [[nodiscard]] bool is_convex(Nodes nodes) const {
    bool left = false, right = false;
    for (std::size_t k = 0, n = nodes.size(); k < n; ++k) {
      const Sign turn = orientation(at(nodes[k]), at(nodes[(k + 1) % n]), at(nodes[(k + 2) % n]));
      left |= turn == Sign::positive;
      right |= turn == Sign::negative;
    }
    return !left || !right;
  }

  /// The constrained triangulation of a polygon; false where its sides are none of a simple one.
  bool cut_by_sides(Nodes nodes) {
    std::vector<Point> corners;
    for (const std::uint32_t node : nodes) {
      if (!std::isfinite(at(node).x) || !std::isfinite(at(node).y)) return false;
      corners.push_back(at(node));
    }
    double area = 0;
    const auto n = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t k = 1; k + 1 < n; ++k)
      area += doubled_area(corners[0], corners[k], corners[k + 1]);
    std::vector<IndexPair> sides;
    for (std::uint32_t k = 0; k < n; ++k)
      sides.push_back(area > 0 ? IndexPair{k, (k + 1) % n} : IndexPair{(k + 1) % n, k});
    const CdtResult cut = triangulate_domain(corners, sides);
    if (!cut.conflicts.empty() || cut.triangulation.triangles.size() != n - 2) return false;
    for (const auto& triangle : cut.triangulation.triangles)
      field_.triangles.push_back(
          {nodes[triangle.v[0]], nodes[triangle.v[1]], nodes[triangle.v[2]]});
    return true;
  }

  PlaneField& field_;
};

/// The points of a table: x, y and further columns.
class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& source)
      : lines_(text, source, '#', Separator::comma) {}

  Result<PlaneField> read() {
    while (!error_ && lines_.next()) {
      const auto& fields = lines_.fields();
      if (names_.empty() && !parse_double(fields[0])) {
        names_.assign(fields.begin(), fields.end());
        read_names();
      } else {
        read_row(fields);
      }
    }
    if (!error_ && field_.points.empty())
      error_ = lines_.error(ErrorCode::truncated, "no points: expected lines x,y,h");
    if (error_) return *error_;
    triangulate();
    return std::move(field_);
  }

 private:
  void fail(ErrorCode code, const std::string& what) { error_ = lines_.error(code, what); }

  /// Whether semicolons stand in fields; quoted names may have them.
  static bool has_semicolons(const std::vector<std::string_view>& fields) {
    return std::any_of(fields.begin(), fields.end(), [](std::string_view field) {
      return field.front() != '"' && field.find(';') != std::string_view::npos;
    });
  }

  /// `row` is a line of numbers: where no semicolon stands between two of its fields, the comma
  /// there is a decimal one.
  void fail_at_semicolons(const std::vector<std::string_view>& row) {
    const bool decimal_commas =
        has_semicolons(row) &&
        std::adjacent_find(row.begin(), row.end(),
                           [](std::string_view left, std::string_view right) {
                             return left.back() != ';' && right.front() != ';';
                           }) != row.end();
    fail(ErrorCode::syntax,
         decimal_commas ? "columns are separated by ';', and decimals have a comma? Commas or "
                          "blanks are read between columns, and decimals have a point"
                        : "columns are separated by ';'? Commas or blanks are read between them");
  }

  /// The first line, where it holds no numbers: columns x and y wherever they stand.
  void read_names() {
    if (has_semicolons(lines_.fields())) {
      LineReader ahead(lines_.rest(), "", '#', Separator::comma);
      ahead.next();
      return fail_at_semicolons(ahead.fields());
    }
    for (std::string& name : names_) {
      if (name.size() > 1 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
    }
    const auto column = [&](const char* name, std::size_t otherwise) {
      for (std::size_t k = 0; k < names_.size(); ++k)
        if (lower(names_[k]) == name) return k;
      return otherwise;
    };
    x_ = column("x", 0);
    y_ = column("y", 1);
    if (x_ == y_) fail(ErrorCode::syntax, "the first two columns are x and y");
  }

  void read_row(const std::vector<std::string_view>& fields) {
    if (has_semicolons(fields)) return fail_at_semicolons(fields);
    if (names_.empty()) names_ = {"x", "y", "h"};
    if (names_.size() < 3) return fail(ErrorCode::syntax, "expected x, y and a value in each line");
    if (fields.size() != names_.size())
      return fail(ErrorCode::syntax,
                  fmt::format("expected {} numbers, found {}", names_.size(), fields.size()));
    std::vector<double> row;
    for (const std::string_view text : fields) {
      const std::optional<double> number = parse_double(text);
      if (!number) return fail(ErrorCode::syntax, fmt::format("'{}' is no number", legible(text)));
      row.push_back(*number);
    }
    const Point at{row[x_], row[y_]};
    if (!std::isfinite(at.x) || !std::isfinite(at.y))
      return fail(ErrorCode::non_finite_coordinate, "the coordinates are not finite");
    add(at, row);
  }

  void add(Point at, const std::vector<double>& row) {
    if (field_.arrays.empty()) {
      for (std::size_t k = 0; k < names_.size(); ++k)
        if (k != x_ && k != y_) field_.arrays.push_back({names_[k], {}});
    }
    const auto [known, is_new] = index_.emplace(at, field_.points.size());
    if (is_new) field_.points.push_back(at);
    std::size_t array = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k == x_ || k == y_) continue;
      std::vector<double>& values = field_.arrays[array++].values;
      if (is_new)
        values.push_back(row[k]);
      else if (values[known->second] != row[k])
        return fail(ErrorCode::syntax,
                    fmt::format("({}, {}) stands there a second time, with {} instead of {}", at.x,
                                at.y, row[k], values[known->second]));
    }
  }

  void triangulate() {
    const CdtResult cut = triangulate_hull(field_.points, {});
    for (const Triangle& t : cut.triangulation.triangles) field_.triangles.push_back(t.v);
  }

  LineReader lines_;
  std::vector<std::string> names_;
  std::size_t x_ = 0, y_ = 1;
  std::map<Point, std::size_t> index_;
  PlaneField field_;
  std::optional<Error> error_;
};

/// Points, plane cells and arrays of one number per point.
PlaneField field_of(const DataSet& data) {
  PlaneField field;
  field.points.reserve(data.point_count());
  for (std::size_t p = 0; p < data.point_count(); ++p) {
    const DataSet::Coordinates x = data.point(p);
    field.points.push_back({x[0], x[1]});
  }
  for (const NumberArray& array : data.point_arrays) {
    if (!array.is_one_per(data.point_count())) continue;
    PlaneField::Array& values = field.arrays.emplace_back(PlaneField::Array{array.name, {}});
    values.values.reserve(data.point_count());
    array.visit([&](auto numbers) {
      for (std::size_t k = 0; k < numbers.size(); ++k)
        values.values.push_back(static_cast<double>(numbers[k]));
    });
  }
  Cutter cutter(field);
  std::array<std::uint32_t, 8> room{};
  for (std::size_t c = 0; c < data.cell_count(); ++c) cutter.add(data.type(c), data.nodes(c, room));
  return field;
}

}  // namespace

Result<PlaneField> read_plane_field(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".csv") {
    const Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return parse_csv_field(*text, path);
  }
  if (extension == ".tif" || extension == ".str") {
    const Result<std::string> text = read_file(path);
    if (!text) return text.error();
    if (extension == ".tif" && is_tiff(*text))
      return wrong_file(
          path, fmt::format("a picture, which holds no field of sizes; {}", kFieldOfRaster));
    const Result<Input> input =
        extension == ".str" ? parse_suprem(*text, path) : parse_tif(*text, path);
    if (!input) return input.error();
    return input->field ? *input->field : PlaneField();
  }
  if (!is_data_set(extension) && extension != ".vtm")  // of which read_data_set() says more
    return Error{
        ErrorCode::unsupported_format,
        fmt::format("{}: a field of sizes is read from .csv, .vtu, .vtp, .vti and .vtk; {}", path,
                    kFieldOfRaster),
        {},
        {}};
  const Result<DataSetFile> file = read_data_set(path);
  if (!file) return file.error();
  return field_of(file->data);
}

Result<PlaneField> parse_csv_field(std::string_view text, const std::string& source) {
  return CsvReader(text, source).read();
}

}  // namespace cover
