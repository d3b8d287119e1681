// Tested by tests/unit/sizes/fields/carry_field_test.cpp.
#include "sizes/fields/carry_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include <cover/mesh.hpp>
#include <cover/text.hpp>
#include "base/numbers.hpp"
#include "geom/box.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"
#include "sizes/fields/triangle_tree.hpp"

namespace cover {
namespace {

/// A vertex on a border that was cut or welded is outside by rounding; this part of the field's
/// extent is far beyond any.
constexpr double kRounding = 1e-9;

/// A place between up to three points of a field.
struct Place {
  std::array<std::uint32_t, 3> points;
  std::array<double, 3> shares;
};

double value_at(const Place& place, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t k = 0; k < place.points.size(); ++k)
    if (place.shares[k] != 0) sum += place.shares[k] * values[place.points[k]];
  return sum;
}

class Carrier {
 public:
  explicit Carrier(const PlaneField& field)
      : field_(field), tree_(field.points, field.triangles, edges_of(field.triangles)) {
    reach_ = kRounding * box_of(field.points).extent();
    for (const PlaneField::Array& array : field.arrays) out_.push_back({array.name, {}});
    jumps_.resize(out_.size());
  }

  void add(Point p) {
    tree_.all_at(p, found_);
    places_.clear();
    for (const std::uint32_t t : found_) places_.push_back(place_in(t, p));
    if (found_.empty()) places_.push_back(beside(p));
    for (std::size_t k = 0; k < out_.size(); ++k) {
      const double value = largest(field_.arrays[k].values);
      out_[k].values.push_back(value);
      if (is_other(field_.arrays[k].values, value) && jumps_[k].count++ == 0) jumps_[k].first = p;
    }
  }

  /// Vertices at which there are other values than the one that counts.
  struct Jumps {
    std::size_t count = 0;
    Point first;
  };
  /// By array.
  [[nodiscard]] const std::vector<Jumps>& jumps() const { return jumps_; }
  [[nodiscard]] std::size_t outside() const { return outside_; }
  [[nodiscard]] Point first_outside() const { return first_outside_; }
  std::vector<PlaneField::Array> take() { return std::move(out_); }

 private:
  [[nodiscard]] Place place_in(std::uint32_t t, Point p) const {
    const auto& [i, j, k] = field_.triangles[t];
    const auto [of_b, of_c] = shares_in({field_.points[i], field_.points[j], field_.points[k]}, p);
    return {{i, j, k}, {1 - of_b - of_c, of_b, of_c}};
  }

  /// On the border, for a point outside.
  Place beside(Point p) {
    const auto [a, b] = tree_.nearest_border(p);
    const Point from = field_.points[a], to = field_.points[b];
    const double part = part_on_segment(from, to, p);
    const Point near{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
    if (std::sqrt(squared_length(p - near)) > reach_ && outside_++ == 0) first_outside_ = p;
    return {{a, b, b}, {1 - part, part, 0}};
  }

  /// Of several values the one of the largest magnitude.
  [[nodiscard]] double largest(const std::vector<double>& values) const {
    double best = kNoNumber;
    for (const Place& place : places_) {
      const double value = value_at(place, values);
      if (std::isnan(value)) continue;
      if (std::isnan(best) || std::abs(value) > std::abs(best)) best = value;
    }
    return best;
  }

  /// Whether there is one that is neither zero nor, but for rounding, `value`: beside a material
  /// without doping, that of the doped one is the only one.
  [[nodiscard]] bool is_other(const std::vector<double>& values, double value) const {
    return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
      const double other = value_at(place, values);
      return other != 0 && std::abs(other - value) > kRounding * std::abs(value);
    });
  }

  const PlaneField& field_;
  TriangleTree tree_;
  double reach_ = 0;
  std::vector<PlaneField::Array> out_;
  std::vector<std::uint32_t> found_;
  std::vector<Place> places_;
  std::vector<Jumps> jumps_;
  std::size_t outside_ = 0;
  Point first_outside_;
};

}  // namespace

std::vector<PlaneField::Array> carry_field(const PlaneField& field, const Mesh& mesh,
                                           std::vector<Note>& notes) {
  if (field.arrays.empty() || field.points.empty()) return {};
  Carrier carrier(field);
  for (const auto v : mesh.tri().vertices()) {
    const TriMesh::Point& p = mesh.tri().point(v);
    carrier.add({p[0], p[1]});
  }
  std::vector<PlaneField::Array> out = carrier.take();
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto& [count, first] = carrier.jumps()[k];
    if (count == 0) continue;
    notes.push_back(
        {Note::Kind::warning,
         kVoid,
         fmt::format(
             "{} several values of {}, first at {}: that of the largest magnitude "
             "counts for all regions there",
             count == 1 ? std::string("1 vertex has") : fmt::format("{} vertices have", count),
             out[k].name, describe(first)),
         {first}});
  }
  if (carrier.outside() == 0) return out;
  std::vector<std::string> names;
  for (const PlaneField::Array& array : out) names.push_back(array.name);
  notes.push_back(
      {Note::Kind::warning,
       kVoid,
       fmt::format("{} outside the triangles that have {}, first at {}: there the "
                   "nearest value counts",
                   carrier.outside() == 1 ? std::string("1 vertex lies")
                                          : fmt::format("{} vertices lie", carrier.outside()),
                   listed(names), describe(carrier.first_outside())),
       {carrier.first_outside()}});
  return out;
}

}  // namespace cover
