// Tested by tests/unit/sizes/fields/size_function_test.cpp and carry_field_test.cpp.
#include "sizes/fields/triangle_tree.hpp"

#include <algorithm>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include "geom/predicates.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeSegment = bg::model::segment<TreePoint>;
using Strategy = bg::index::rstar<16>;

TreePoint tree_point(Point p) { return {p.x, p.y}; }

/// Those that occur once, of sorted edges; each point for itself if there are none.
TreeEdges border_of(const TreeEdges& edges, std::size_t points) {
  TreeEdges border;
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t next = k + 1;
    while (next < edges.size() && edges[next] == edges[k]) ++next;
    if (next == k + 1) border.push_back(edges[k]);
    k = next;
  }
  if (!border.empty()) return border;
  for (std::uint32_t v = 0; v < points; ++v) border.emplace_back(v, v);
  return border;
}

}  // namespace

struct TriangleTree::Trees {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> corners;
  TreeEdges border;
  bg::index::rtree<std::pair<TreeBox, std::uint32_t>, Strategy> triangles;
  bg::index::rtree<std::pair<TreeSegment, std::uint32_t>, Strategy> segments;

  [[nodiscard]] bool contains(std::uint32_t t, Point p) const {
    const Point a = points[corners[t][0]], b = points[corners[t][1]], c = points[corners[t][2]];
    const Sign side = orientation(a, b, c);
    if (side == Sign::zero) return false;
    const Sign wrong = side == Sign::positive ? Sign::negative : Sign::positive;
    return orientation(a, b, p) != wrong && orientation(b, c, p) != wrong &&
           orientation(c, a, p) != wrong;
  }

  template <class Look>
  void around(Point p, Look look) const {
    const auto visit = [&](const std::pair<TreeBox, std::uint32_t>& entry) { look(entry.second); };
    triangles.query(bg::index::intersects(tree_point(p)),
                    boost::make_function_output_iterator(visit));
  }
};

TreeEdges edges_of(std::span<const std::array<std::uint32_t, 3>> triangles) {
  TreeEdges edges;
  for (const auto& [a, b, c] : triangles) {
    for (const auto& [u, v] : {std::pair(a, b), {b, c}, {c, a}}) {
      edges.emplace_back(std::min(u, v), std::max(u, v));
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

TriangleTree::TriangleTree(std::span<const Point> points,
                           std::span<const std::array<std::uint32_t, 3>> triangles,
                           const TreeEdges& edges) {
  auto trees = std::make_unique<Trees>();
  trees->points.assign(points.begin(), points.end());
  trees->corners.assign(triangles.begin(), triangles.end());
  trees->border = border_of(edges, points.size());
  std::vector<std::pair<TreeBox, std::uint32_t>> boxes;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    TreeBox box;
    bg::assign_inverse(box);
    for (const std::uint32_t v : triangles[t]) bg::expand(box, tree_point(points[v]));
    boxes.emplace_back(box, t);
  }
  trees->triangles = {boxes.begin(), boxes.end()};
  std::vector<std::pair<TreeSegment, std::uint32_t>> segments;
  for (std::uint32_t e = 0; e < trees->border.size(); ++e) {
    const auto& [a, b] = trees->border[e];
    segments.emplace_back(TreeSegment{tree_point(points[a]), tree_point(points[b])}, e);
  }
  trees->segments = {segments.begin(), segments.end()};
  trees_ = std::move(trees);
}
TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;

std::optional<std::uint32_t> TriangleTree::first_at(Point p) const {
  std::optional<std::uint32_t> first;
  trees_->around(p, [&](std::uint32_t t) {
    if ((!first || t < *first) && trees_->contains(t, p)) first = t;
  });
  return first;
}

void TriangleTree::all_at(Point p, std::vector<std::uint32_t>& found) const {
  found.clear();
  trees_->around(p, [&](std::uint32_t t) {
    if (trees_->contains(t, p)) found.push_back(t);
  });
  std::sort(found.begin(), found.end());
}

std::pair<std::uint32_t, std::uint32_t> TriangleTree::nearest_border(Point p) const {
  std::uint32_t nearest = 0;
  const auto look = [&](const std::pair<TreeSegment, std::uint32_t>& entry) {
    nearest = entry.second;
  };
  trees_->segments.query(bg::index::nearest(tree_point(p), 1),
                         boost::make_function_output_iterator(look));
  return trees_->border[nearest];
}

std::array<double, 2> shares_in(const std::array<Point, 3>& abc, Point p) {
  const auto [a, b, c] = abc;
  const double whole = doubled_area(a, b, c);
  return {doubled_area(a, p, c) / whole, doubled_area(a, b, p) / whole};
}

}  // namespace cover
