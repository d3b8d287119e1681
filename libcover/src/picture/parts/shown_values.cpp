// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/parts/shown_values.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/expression.hpp"
#include "base/faults/errors.hpp"
#include "picture/parts/triangle_angles.hpp"

namespace cover {
namespace {

/// All that may be shown, in the order in which names count.
class Shown {
 public:
  explicit Shown(const PictureMesh& mesh) : mesh_(mesh), soup_(mesh.mesh.soup) {
    for (const CellArray& array : mesh.mesh.arrays) add(array.name, Kind::of_triangles);
    if (!soup_.region.empty()) add_unless_known("RegionId", Kind::region);
    if (!soup_.material.empty()) add_unless_known("material", Kind::material);
    for (const PlaneField::Array& array : mesh.mesh.point_arrays) add(array.name, Kind::of_points);
    add_unless_known("max_angle", Kind::largest_angle);
    add_unless_known("min_angle", Kind::smallest_angle);
  }

  Result<std::vector<double>> values(const std::string& shown) {
    const auto at = std::find(names_.begin(), names_.end(), shown);
    if (at != names_.end()) return means({static_cast<std::size_t>(at - names_.begin())}, nullptr);
    std::vector<std::string> names = names_;
    names.insert(names.end(), {"x", "y"});
    const Result<Expression> formula = Expression::parse(shown, names);
    if (!formula)
      return bad_option(
          fmt::format("the mesh has no array '{}'; it has {}{}", shown, listed(names_),
                      is_word(shown) ? "" : "; as an expression: " + formula.error().message));
    std::vector<std::size_t> used;
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (formula->uses(k)) used.push_back(k);
    return means(used, &*formula);
  }

 private:
  enum class Kind { of_triangles, of_points, region, material, largest_angle, smallest_angle };
  /// A name's array: its kind, and its place among those of its kind in the mesh.
  struct Source {
    Kind kind;
    std::size_t place;
  };

  void add(const std::string& name, Kind kind) {
    const auto is_kind = [&](const Source& source) { return source.kind == kind; };
    const auto place = std::count_if(sources_.begin(), sources_.end(), is_kind);
    sources_.push_back({kind, static_cast<std::size_t>(place)});
    names_.push_back(name);
  }
  void add_unless_known(const char* name, Kind kind) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) add(name, kind);
  }

  static bool is_word(const std::string& text) {
    return text.find_first_of("()+-*/^") == std::string::npos;
  }

  /// The mean of the corners, of the one array that is used or of a formula of several.
  Result<std::vector<double>> means(const std::vector<std::size_t>& used,
                                    const Expression* formula) const {
    std::vector<std::vector<double>> of_triangles(names_.size());
    for (const std::size_t k : used) {
      if (Status status = check_size(k); !status) return std::move(status).error();
      of_triangles[k] = values_of_triangles(sources_[k]);
    }
    if (formula == nullptr && sources_[used.front()].kind != Kind::of_points)
      return std::move(of_triangles[used.front()]);
    std::vector<double> means, row(names_.size() + 2);
    means.reserve(soup_.triangles.size());
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      const RegionId region(static_cast<std::uint32_t>(soup_.region.empty() ? 1 : soup_.region[t]));
      double sum = 0;
      for (const std::uint32_t v : soup_.triangles[t]) {
        for (const std::size_t k : used)
          row[k] = sources_[k].kind == Kind::of_points
                       ? value_in(mesh_.mesh.point_arrays, mesh_.region_values, sources_[k].place,
                                  v, region)
                       : of_triangles[k][t];
        row[names_.size()] = soup_.points[v].x;
        row[names_.size() + 1] = soup_.points[v].y;
        sum += formula != nullptr ? (*formula)(row) : row[used.front()];
      }
      means.push_back(sum / 3);
    }
    return means;
  }

  [[nodiscard]] Status check_size(std::size_t k) const {
    const auto [kind, place] = sources_[k];
    const bool is_at_points = kind == Kind::of_points;
    if (!is_at_points && kind != Kind::of_triangles) return ok();
    const std::size_t size = is_at_points ? mesh_.mesh.point_arrays[place].values.size()
                                          : mesh_.mesh.arrays[place].values.size();
    const std::size_t things = is_at_points ? soup_.points.size() : soup_.triangles.size();
    if (size == things) return ok();
    return Error{ErrorCode::id_out_of_range,
                 fmt::format("the array '{}' has {} values for {} {}", names_[k], size, things,
                             is_at_points ? "points" : "triangles"),
                 {},
                 {}};
  }

  /// Nothing for values at points.
  [[nodiscard]] std::vector<double> values_of_triangles(const Source& source) const {
    switch (source.kind) {
      case Kind::of_triangles:
        return mesh_.mesh.arrays[source.place].values;
      case Kind::region:
        return {soup_.region.begin(), soup_.region.end()};
      case Kind::material:
        return {soup_.material.begin(), soup_.material.end()};
      case Kind::largest_angle:
        return largest_angles(soup_);
      case Kind::smallest_angle:
        return smallest_angles(soup_);
      case Kind::of_points:
        break;
    }
    return {};
  }

  const PictureMesh& mesh_;
  const TriangleSoup& soup_;
  std::vector<std::string> names_;
  std::vector<Source> sources_;
};

}  // namespace

Result<std::vector<double>> shown_values(const PictureMesh& mesh, const std::string& shown) {
  return Shown(mesh).values(shown);
}

}  // namespace cover
