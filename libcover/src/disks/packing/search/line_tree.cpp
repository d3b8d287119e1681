// Built top-down: the axis of a node is the main axis of the second moments of its end points, and
// the lines are halved by their middles along whichever of the two axes spreads these more.
// Tested by tests/unit/disks/packing/packing_test.cpp.
#include "disks/packing/search/line_tree.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace cover::disks {
namespace {

constexpr Index kLeafSize = 4;

Point start_of(const Element& e) { return e.c + e.from * e.d; }
Point end_of(const Element& e) { return e.c + e.to * e.d; }
Point middle_of(const Element& e) { return e.c + (0.5 * (e.from + e.to)) * e.d; }

/// Unit main axis of the end points of some lines.
Vector main_axis(const std::vector<Element>& elements, const Index* first, const Index* last) {
  Vector sum;
  for (const Index* i = first; i != last; ++i) {
    const Element& e = elements[*i];
    sum = sum + 0.5 * ((start_of(e) - Point{}) + (end_of(e) - Point{}));
  }
  const Point mean = Point{} + (1.0 / static_cast<double>(last - first)) * sum;
  double xx = 0, xy = 0, yy = 0;
  for (const Index* i = first; i != last; ++i) {
    for (const Point p : {start_of(elements[*i]), end_of(elements[*i])}) {
      const Vector v = p - mean;
      xx += v.x * v.x, xy += v.x * v.y, yy += v.y * v.y;
    }
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  return {std::cos(angle), std::sin(angle)};
}

struct Extent {
  double low = kInfinity;
  double high = -kInfinity;
  void include(double t) { low = std::min(low, t), high = std::max(high, t); }
  [[nodiscard]] double width() const { return high - low; }
};

}  // namespace

LineTree::LineTree(const std::vector<Element>& elements) {
  for (Index i = 0; i < elements.size(); ++i) {
    if (elements[i].is_line()) lines_.push_back(i);
  }
  if (lines_.empty()) return;
  nodes_.reserve(lines_.size());
  build(elements, 0, static_cast<Index>(lines_.size()));
}

Index LineTree::build(const std::vector<Element>& elements, Index first, Index last) {
  Index* const begin = lines_.data() + first;
  Index* const end = lines_.data() + last;
  Node n;
  n.axis = main_axis(elements, begin, end);
  const Vector across = left_normal(n.axis);
  Extent along_extent, across_extent, along_middles, across_middles;
  for (const Index* i = begin; i != end; ++i) {
    const Element& e = elements[*i];
    for (const Point p : {start_of(e), end_of(e)}) {
      along_extent.include(dot(n.axis, p - Point{}));
      across_extent.include(dot(across, p - Point{}));
    }
    along_middles.include(dot(n.axis, middle_of(e) - Point{}));
    across_middles.include(dot(across, middle_of(e) - Point{}));
  }
  constexpr double kSlack = 1 + 1e-9;  // rounding must not push a line out of its box
  n.centre = Point{} + (0.5 * (along_extent.low + along_extent.high)) * n.axis +
             (0.5 * (across_extent.low + across_extent.high)) * across;
  n.half_along = 0.5 * along_extent.width() * kSlack + 1e-12;
  n.half_across = 0.5 * across_extent.width() * kSlack + 1e-12;

  const auto self = static_cast<Index>(nodes_.size());
  nodes_.push_back(n);
  if (last - first <= kLeafSize) {
    nodes_[self].first = first;
    nodes_[self].count = last - first;
    return self;
  }
  const Vector by = along_middles.width() >= across_middles.width() ? n.axis : across;
  Index* const middle = begin + (last - first) / 2;
  std::nth_element(begin, middle, end, [&](Index i, Index j) {
    const double s = dot(by, middle_of(elements[i]) - Point{});
    const double t = dot(by, middle_of(elements[j]) - Point{});
    return s != t ? s < t : i < j;
  });
  const Index split = first + (last - first) / 2;
  build(elements, first, split);
  const Index second = build(elements, split, last);
  nodes_[self].first = second;
  return self;
}

double LineTree::distance(const Node& n, Point x) {
  const Vector v = x - n.centre;
  const double a = std::abs(dot(n.axis, v)) - n.half_along;
  const double b = std::abs(cross(n.axis, v)) - n.half_across;
  if (a <= 0) return std::max(b, 0.0);
  if (b <= 0) return a;
  return std::sqrt(a * a + b * b);
}

}  // namespace cover::disks
