// Tested by tests/unit/sizes/fields/carry_field_test.cpp.
#include "sizes/fields/carry_field.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/core.h>

#include <cover/mesh.hpp>
#include <cover/text.hpp>
#include "base/numbers.hpp"
#include "geom/box.hpp"
#include "geom/foot.hpp"
#include "geom/triangle.hpp"
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

/// A value, and of what it was added up.
struct Value {
  double number = kNoNumber;
  double scale = 0;
};

Value value_at(const Place& place, const std::vector<double>& values) {
  Value sum{0, 0};
  for (std::size_t k = 0; k < place.points.size(); ++k) {
    if (place.shares[k] == 0) continue;
    const double part = place.shares[k] * values[place.points[k]];
    sum.number += part;
    sum.scale += std::abs(part);
  }
  return sum;
}

/// Whether two values differ by more than rounding.
bool is_apart(const Value& a, const Value& b) {
  if (std::isnan(a.number) || std::isnan(b.number))
    return std::isnan(a.number) != std::isnan(b.number);
  return std::abs(a.number - b.number) > kRounding * std::max(a.scale, b.scale);
}

/// A triangle at a vertex where regions meet.
struct Sight {
  std::uint32_t vertex;
  RegionId region;
  Point middle;
};

/// By vertex, then by region.
std::vector<Sight> sights_of(const Mesh& mesh) {
  const TriMesh& tri = mesh.tri();
  const auto place = [](TriMesh::VertexHandle v) { return static_cast<std::size_t>(v.idx()); };
  std::vector<RegionId> first(mesh.vertices(), kVoid);
  std::vector<bool> is_shared(mesh.vertices());
  for (const auto face : tri.faces()) {
    const RegionId region = mesh.region(face);
    for (const auto v : tri.fv_range(face)) {
      if (first[place(v)] == kVoid) first[place(v)] = region;
      if (first[place(v)] != region) is_shared[place(v)] = true;
    }
  }
  std::vector<Sight> sights;
  for (const auto face : tri.faces()) {
    std::array<Point, 3> corners;
    std::size_t k = 0;
    for (const auto v : tri.fv_range(face)) corners[k++] = {tri.point(v)[0], tri.point(v)[1]};
    const Point middle = centroid(corners[0], corners[1], corners[2]);
    for (const auto v : tri.fv_range(face))
      if (is_shared[place(v)])
        sights.push_back({static_cast<std::uint32_t>(v.idx()), mesh.region(face), middle});
  }
  std::stable_sort(sights.begin(), sights.end(), [](const Sight& a, const Sight& b) {
    return std::pair(a.vertex, a.region) < std::pair(b.vertex, b.region);
  });
  return sights;
}

class Carrier {
 public:
  explicit Carrier(const PlaneField& field)
      : field_(field), tree_(field.points, field.triangles, edges_of(field.triangles)) {
    reach_ = kRounding * box_of(field.points).extent();
    for (const PlaneField::Array& array : field.arrays) out_.fields.push_back({array.name, {}});
    out_.region_values.resize(field.arrays.size());
    jumps_.resize(field.arrays.size());
  }

  /// A vertex; `sights` of it, where regions meet there.
  void add(Point p, std::span<const Sight> sights) {
    places_.clear();
    add_places(p, p, places_);
    bool is_outside = false;
    if (places_.empty()) {
      places_.push_back(beside(p, p));
      const Point near = point_at(places_.front());
      is_outside = std::sqrt(squared_length(p - near)) > reach_;
      if (is_outside && outside_++ == 0) first_outside_ = p;
    }
    seen_.clear();
    if (!is_outside)
      for (const Sight& sight : sights) look(p, sight);
    for (std::size_t k = 0; k < out_.fields.size(); ++k) add_value(k, p);
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
  CarriedField take() { return std::move(out_); }

 private:
  /// What a region sees at a vertex.
  struct Seen {
    RegionId region;
    std::vector<Place> places;
  };

  /// Where `p` is in the triangles that contain `from`.
  void add_places(Point p, Point from, std::vector<Place>& places) {
    tree_.all_at(from, found_);
    for (const std::uint32_t t : found_) places.push_back(place_in(t, p));
  }

  /// Has a region look at `p` from a step inside: a vertex that was rounded may lie beyond the
  /// border that it is on.
  void look(Point p, const Sight& sight) {
    const Vector way = sight.middle - p;
    const double part = std::min(0.5, reach_ / std::sqrt(squared_length(way)));
    const Point from = p + part * way;
    if (seen_.empty() || seen_.back().region != sight.region) seen_.push_back({sight.region, {}});
    std::vector<Place>& places = seen_.back().places;
    const std::size_t before = places.size();
    add_places(p, from, places);
    if (places.size() == before) places.push_back(beside(p, from));
  }

  /// The value of the k-th array at `p`, and those of regions that see another one.
  void add_value(std::size_t k, Point p) {
    const std::vector<double>& values = field_.arrays[k].values;
    Value value = largest(places_, values);
    for (const Seen& one : seen_) {
      const Value own = largest(one.places, values);
      if (is_apart(own, value) && larger_value(value.number, own.number) == own.number) value = own;
    }
    const auto vertex = static_cast<std::uint32_t>(out_.fields[k].values.size());
    out_.fields[k].values.push_back(value.number);
    bool is_jump = is_other(places_, values, value);
    for (const Seen& one : seen_) {
      const Value own = largest(one.places, values);
      if (is_apart(own, value)) out_.region_values[k].push_back({vertex, one.region, own.number});
      is_jump = is_jump || is_other(one.places, values, value);
    }
    if (is_jump && jumps_[k].count++ == 0) jumps_[k].first = p;
  }

  [[nodiscard]] Place place_in(std::uint32_t t, Point p) const {
    const auto& [i, j, k] = field_.triangles[t];
    const auto [of_b, of_c] = shares_in({field_.points[i], field_.points[j], field_.points[k]}, p);
    return {{i, j, k}, {1 - of_b - of_c, of_b, of_c}};
  }

  /// On the piece of the border that is nearest to `from`, for a point outside.
  [[nodiscard]] Place beside(Point p, Point from) const {
    const auto [a, b] = tree_.nearest_border(from);
    const double part = part_on_segment(field_.points[a], field_.points[b], p);
    return {{a, b, b}, {1 - part, part, 0}};
  }

  [[nodiscard]] Point point_at(const Place& place) const {
    Point at{0, 0};
    for (std::size_t k = 0; k < place.points.size(); ++k) {
      at.x += place.shares[k] * field_.points[place.points[k]].x;
      at.y += place.shares[k] * field_.points[place.points[k]].y;
    }
    return at;
  }

  /// Of several values the one of the largest magnitude.
  static Value largest(const std::vector<Place>& places, const std::vector<double>& values) {
    Value best;
    for (const Place& place : places) {
      const Value value = value_at(place, values);
      if (std::isnan(best.number) || larger_value(best.number, value.number) != best.number)
        best = value;
    }
    return best;
  }

  /// Whether there is a value that is neither zero nor, but for rounding, `value`: beside a
  /// material without doping, that of the doped one is the only one.
  static bool is_other(const std::vector<Place>& places, const std::vector<double>& values,
                       const Value& value) {
    return std::any_of(places.begin(), places.end(), [&](const Place& place) {
      const Value other = value_at(place, values);
      return !std::isnan(other.number) && other.number != 0 && is_apart(other, value);
    });
  }

  const PlaneField& field_;
  TriangleTree tree_;
  double reach_ = 0;
  CarriedField out_;
  std::vector<std::uint32_t> found_;
  std::vector<Place> places_;  ///< of the vertex that is added
  std::vector<Seen> seen_;     ///< by region, where several meet
  std::vector<Jumps> jumps_;
  std::size_t outside_ = 0;
  Point first_outside_;
};

}  // namespace

CarriedField carry_field(const PlaneField& field, const Mesh& mesh, std::vector<Note>& notes) {
  if (field.arrays.empty() || field.points.empty()) return {};
  Carrier carrier(field);
  const std::vector<Sight> sights = sights_of(mesh);
  for (auto last = sights.begin(); const auto v : mesh.tri().vertices()) {
    const TriMesh::Point& p = mesh.tri().point(v);
    const auto first = last;
    while (last != sights.end() && last->vertex == static_cast<std::uint32_t>(v.idx())) ++last;
    carrier.add({p[0], p[1]}, {first, last});
  }
  CarriedField out = carrier.take();
  for (std::size_t k = 0; k < out.fields.size(); ++k) {
    const auto& [count, first] = carrier.jumps()[k];
    if (count == 0) continue;
    notes.push_back(
        {Note::Kind::warning,
         kVoid,
         fmt::format(
             "{} several values of {}, first at {}: a .vtm keeps that of each region, elsewhere "
             "that of the largest magnitude counts for all regions there",
             count == 1 ? std::string("1 vertex has") : fmt::format("{} vertices have", count),
             out.fields[k].name, describe(first)),
         {first}});
  }
  if (carrier.outside() == 0) return out;
  std::vector<std::string> names;
  for (const PlaneField::Array& array : out.fields) names.push_back(array.name);
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
