// Readers make inputs that agree with themselves; programs that fill one by hand need not.
// Tested by tests/unit/clean/check_input_test.cpp.
#include "clean/check_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <cover/option_ranges.hpp>
#include <cover/text.hpp>
#include <cover/units.hpp>

#include "base/faults/complaint.hpp"

namespace cover {
namespace {

/// Finds contradictions kind by kind; each kind is an Error of its own.
class InputChecker {
 public:
  explicit InputChecker(const Input& input) : input_(input) {}

  std::optional<Error> find() {
    check_arrays();
    check_features();
    check_words();
    if (input_.field) check_field(*input_.field);
    if (!indices_.empty()) return indices_.error();
    if (!places_.empty()) return places_.error();
    check_units();
    for (const RegionSeed& seed : input_.seeds) check_size(seed);
    for (const InputPolygon& polygon : input_.polygons) check_polygon(polygon);
    if (!numbers_.empty()) return numbers_.error();
    return {};
  }

 private:
  /// What there is for each of `things`, or for none of them.
  void check_length(std::size_t length, std::size_t things, std::string_view what,
                    std::string_view of, bool may_be_empty = true) {
    if (length == things || (may_be_empty && length == 0)) return;
    indices_.add(fmt::format("there are {} {} for {} {}", length, what, things, of), {}, {});
  }

  void check_arrays() {
    const std::size_t n = input_.points.size();
    check_length(input_.point_ids.size(), n, "point_ids", "points");
    check_length(input_.point_lines.size(), n, "point_lines", "points");
    check_length(input_.point_markers.size(), n, "point_markers", "points");
    for (const PointName& name : input_.point_names) {
      if (name.point < n) continue;
      indices_.add(fmt::format("the name '{}' is of point {}, which is not there",
                               printable(name.name), name.point),
                   {}, {});
    }
  }

  /// Features that all attributes have.
  [[nodiscard]] std::size_t features() const {
    std::size_t least = input_.attributes.empty() ? 0 : input_.attributes.front().values.size();
    for (const Attribute& attribute : input_.attributes)
      least = std::min(least, attribute.values.size());
    return least;
  }

  void check_features() {
    const std::size_t most = features();
    const auto check = [&](const char* what, std::uint32_t feature, std::vector<Point> where,
                           InputRef ref) {
      if (feature <= most) return;
      indices_.add(fmt::format("{} {} has the feature {}, but attributes have {}", what, ref.id,
                               feature, counted(most, "value")),
                   std::move(where), {ref});
    };
    for (const RegionSeed& seed : input_.seeds)
      check("region seed", seed.feature, {seed.at}, {InputKind::region_seed, seed.id});
    for (const InputPolygon& polygon : input_.polygons)
      check("polygon", polygon.feature, {}, {InputKind::polygon, polygon.id});
  }

  void check_words() {
    for (const Attribute& attribute : input_.attributes) {
      if (!attribute.is_text) continue;
      const auto most = static_cast<double>(attribute.words.size());
      for (std::size_t k = 0; k < attribute.values.size(); ++k) {
        const double value = attribute.values[k];
        if (value >= 0 && value <= most && value == std::floor(value)) continue;
        indices_.add(
            fmt::format("the attribute '{}' of feature {} is the word {}, but there are {}",
                        attribute.name, k + 1, describe(value),
                        counted(attribute.words.size(), "word")),
            {}, {});
      }
    }
  }

  void check_field(const PlaneField& field) {
    const std::size_t n = field.points.size();
    for (const PlaneField::Array& array : field.arrays)
      check_length(array.values.size(), n, fmt::format("values of the field '{}'", array.name),
                   "points of it", false);
    check_length(field.material.size(), field.triangles.size(), "materials of the field",
                 "triangles of it");
    for (std::size_t t = 0; t < field.triangles.size(); ++t) {
      for (const std::uint32_t v : field.triangles[t]) {
        if (v < n) continue;
        indices_.add(
            fmt::format("triangle {} of the field has the point {}, which is not there", t, v), {},
            {});
      }
    }
    for (std::size_t v = 0; v < n; ++v) {
      const Point p = field.points[v];
      if (!std::isfinite(p.x) || !std::isfinite(p.y))
        places_.add(fmt::format("point {} of the field is not finite", v), {p}, {});
    }
  }

  void check_units() {
    if (!(input_.scale > 0 && std::isfinite(input_.scale)))
      numbers_.add(fmt::format("the scale is {}, but must be a number above 0", input_.scale), {},
                   {});
    if (!input_.unit.empty() && !is_length_unit(input_.unit))
      numbers_.add(fmt::format("the unit is '{}', but must be nm, um, mm, cm or m, or empty",
                               printable(input_.unit)),
                   {}, {});
  }

  /// As options say it of a size.
  [[nodiscard]] static std::string wrong_size(double size) {
    return fmt::format("is {}, but must be {}", describe(size), describe(ranges::kSize));
  }

  void check_size(const RegionSeed& seed) {
    if (!seed.size || ranges::kSize.holds(*seed.size)) return;
    numbers_.add(fmt::format("the size of region seed {} at {}{} {}", seed.id, describe(seed.at),
                             line_suffix(seed.line), wrong_size(*seed.size)),
                 {seed.at}, {{InputKind::region_seed, seed.id}});
  }

  void check_polygon(const InputPolygon& polygon) {
    const InputRef ref{InputKind::polygon, polygon.id};
    std::vector<Point> where;
    if (!polygon.rings.empty() && !polygon.rings[0].empty()) where.push_back(polygon.rings[0][0]);
    if (polygon.size && !ranges::kSize.holds(*polygon.size))
      numbers_.add(fmt::format("the size of polygon {} {}", polygon.id, wrong_size(*polygon.size)),
                   where, {ref});
    // An infinite one is above or below all others; what is no number is in no order at all.
    if (polygon.priority && std::isnan(*polygon.priority))
      numbers_.add(fmt::format("the priority of polygon {} is no number", polygon.id), where,
                   {ref});
  }

  const Input& input_;
  Complaint indices_{ErrorCode::id_out_of_range, input_.source};
  Complaint places_{ErrorCode::non_finite_coordinate, input_.source};
  Complaint numbers_{ErrorCode::bad_option, input_.source};
};

}  // namespace

std::optional<Error> find_contradiction(const Input& input) { return InputChecker(input).find(); }

}  // namespace cover
