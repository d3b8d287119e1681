// Tested by tests/unit/io/input/read_size_field_test.cpp.
#include <cover/read_size_field.hpp>

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/ranges.h>

#include "base/errors.hpp"
#include "base/out_of_memory.hpp"
#include "cdt/cdt.hpp"
#include "geom/predicates.hpp"
#include "io/vtk_files/read_data_set.hpp"

namespace cover {
namespace {

using Nodes = std::span<const std::uint32_t>;

/// The sizes by point, or what there is instead.
Result<const NumberArray*> find_sizes(const DataSet& data, const std::string& path) {
  for (const char* name : {"size", "h"})
    if (const NumberArray* found = data.array_of_points(name)) return found;
  std::vector<const NumberArray*> found;
  std::vector<std::string_view> names;
  for (const NumberArray& array : data.point_arrays) {
    if (!array.is_one_per(data.point_count())) continue;
    found.push_back(&array);
    names.push_back(array.name);
  }
  if (found.size() == 1) return found.front();
  if (found.empty()) return wrong_file(path, "no point array with one component, of edge lengths");
  return wrong_file(path,
                    fmt::format("which point array has the edge lengths? None of {} is called size "
                                "or h",
                                fmt::join(names, ", ")));
}

/// Cuts plane cells into triangles.
class Cutter {
 public:
  explicit Cutter(SizeSamples& samples) : samples_(samples) {}

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
  [[nodiscard]] Point at(std::uint32_t node) const { return samples_.points[node]; }

  void parts(Nodes nodes, std::initializer_list<std::array<std::size_t, 3>> triangles) {
    for (const auto& [a, b, c] : triangles)
      samples_.triangles.push_back({nodes[a], nodes[b], nodes[c]});
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
      samples_.triangles.push_back({nodes[0], nodes[k - 1], nodes[k]});
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
    for (std::uint32_t k = 0; k < n; ++k) {
      const Point p = corners[k], q = corners[(k + 1) % n];
      area +=
          (p.x - corners[0].x) * (q.y - corners[0].y) - (q.x - corners[0].x) * (p.y - corners[0].y);
    }
    std::vector<IndexPair> sides;
    for (std::uint32_t k = 0; k < n; ++k)
      sides.push_back(area > 0 ? IndexPair{k, (k + 1) % n} : IndexPair{(k + 1) % n, k});
    const CdtResult cut = triangulate_domain(corners, sides);
    if (!cut.conflicts.empty() || cut.triangulation.triangles.size() != n - 2) return false;
    for (const auto& triangle : cut.triangulation.triangles)
      samples_.triangles.push_back(
          {nodes[triangle.v[0]], nodes[triangle.v[1]], nodes[triangle.v[2]]});
    return true;
  }

  SizeSamples& samples_;
};

}  // namespace

Result<SizeSamples> read_size_field(const std::string& path) {
  const Result<DataSetFile> file = read_data_set(path);
  if (!file) return file.error();
  const DataSet& data = file->data;
  const Result<const NumberArray*> sizes = find_sizes(data, path);
  if (!sizes) return sizes.error();
  SizeSamples samples;
  samples.points.reserve(data.point_count());
  for (std::size_t p = 0; p < data.point_count(); ++p) {
    const DataSet::Coordinates x = data.point(p);
    samples.points.push_back({x[0], x[1]});
  }
  samples.sizes.reserve(data.point_count());
  (*sizes)->visit([&](auto numbers) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
      samples.sizes.push_back(static_cast<double>(numbers[k]));
  });
  Cutter cutter(samples);
  std::array<std::uint32_t, 8> room{};
  for (std::size_t c = 0; c < data.cell_count(); ++c) cutter.add(data.type(c), data.nodes(c, room));
  return samples;
}

Status load_size_field(Options& options) {
  return memory_as_value(options.size_field_name, [&]() -> Status {
    if (options.size_field || options.size_field_name.empty()) return ok();
    const Result<SizeSamples> samples = read_size_field(options.size_field_name);
    if (!samples) return samples.error();
    Result<SizeFunction> sizes = size_function(*samples, options.growth.value_or(Options::kGrowth));
    if (!sizes) {
      Error error = std::move(sizes).error();
      error.message = fmt::format("{}: {}", options.size_field_name, error.message);
      return error;
    }
    options.size_field = *std::move(sizes);
    return ok();
  });
}

}  // namespace cover
