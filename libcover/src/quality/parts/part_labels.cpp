// See part_labels.hpp. Tested by tests/unit/quality/parts/work_in_parts_test.cpp.
#include "quality/parts/part_labels.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "geom/box.hpp"

namespace cover {
namespace {

constexpr std::size_t kSamples = 256;  ///< triangles of a part that say where the tree divides

Point middle_of(const MutableMesh& mesh, std::uint32_t t) {
  const Point a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

/// Parts of the plane with about as many triangles each.
class Tree {
 public:
  Tree(const MutableMesh& mesh, std::size_t parts) {
    const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / (kSamples * parts));
    std::vector<Point> middles;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += step) {
      const auto t = static_cast<std::uint32_t>(k);
      if (!mesh.is_hole(t)) middles.push_back(middle_of(mesh, t));
    }
    divide(middles, parts);
  }

  [[nodiscard]] std::uint32_t part_at(Point p) const {
    const Node* node = nodes_.data();
    while (node->beyond != 0) {
      const bool is_beyond = node->is_x ? p.x >= node->at : p.y >= node->at;
      node = is_beyond ? &nodes_[node->beyond] : node + 1;
    }
    return node->part;
  }

 private:
  struct Node {
    double at = 0;
    bool is_x = false;
    std::uint32_t beyond = 0;  ///< the node above `at`; that below is the next one. 0: a part
    std::uint32_t part = 0;
  };

  void divide(std::span<Point> middles, std::size_t parts) {
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    if (parts < 2 || middles.size() < 2) {
      nodes_[node].part = parts_++;
      return;
    }
    const Box box = box_of(middles);
    const bool is_x = box.high.x - box.low.x >= box.high.y - box.low.y;
    const std::size_t below = parts / 2, place = middles.size() * below / parts;
    const auto coordinate = [is_x](Point p) { return is_x ? p.x : p.y; };
    std::nth_element(middles.begin(), middles.begin() + static_cast<std::ptrdiff_t>(place),
                     middles.end(),
                     [&](Point p, Point q) { return coordinate(p) < coordinate(q); });
    nodes_[node].at = coordinate(middles[place]);
    nodes_[node].is_x = is_x;
    divide(middles.first(place), below);
    nodes_[node].beyond = static_cast<std::uint32_t>(nodes_.size());
    divide(middles.subspan(place), parts - below);
  }

  std::vector<Node> nodes_;
  std::uint32_t parts_ = 0;
};

/// ENSURES: numbers below `parts`, all of them from 0 to the largest; kNone for holes
UnsetVector<std::uint32_t> branches_of(const MutableMesh& mesh, std::size_t parts) {
  const std::size_t count = mesh.triangles.size();
  const std::size_t least = (mesh.triangle_count() + parts - 1) / parts;
  std::vector<std::uint32_t> order, parent(count, kNone);
  UnsetVector<std::uint32_t> label(count, kNone);
  order.reserve(mesh.triangle_count());
  std::vector<std::uint32_t> size(count, 0);  // of what hangs on a triangle; 0: not seen
  for (std::uint32_t root = 0; root < count; ++root) {
    if (mesh.is_hole(root) || size[root] != 0) continue;
    size[root] = 1;
    order.push_back(root);
    for (std::size_t k = order.size() - 1; k < order.size(); ++k) {
      for (const std::uint32_t n : mesh.triangles[order[k]].n) {
        if (is_side(n) || size[n] != 0) continue;
        size[n] = 1;
        parent[n] = order[k];
        order.push_back(n);
      }
    }
  }
  std::uint32_t next = 0;
  for (std::size_t k = order.size(); k-- > 0;) {
    const std::uint32_t t = order[k];
    if (size[t] >= least) {
      label[t] = next++;
    } else if (parent[t] != kNone) {
      size[parent[t]] += size[t];
    }
  }
  for (const std::uint32_t t : order) {  // what is left at the roots is one part
    if (label[t] == kNone) label[t] = parent[t] == kNone ? next : label[parent[t]];
  }
  return label;
}

}  // namespace

PartLabels label_parts(const MutableMesh& mesh, std::size_t parts, const Team& team) {
  PartLabels labels;
  if (mesh.points.size() == mesh.fixed_vertices()) {
    labels.of_triangle = branches_of(mesh, parts);
    for (const std::uint32_t label : labels.of_triangle) {
      if (label != kNone) labels.count = std::max<std::size_t>(labels.count, label + 1U);
    }
    return labels;
  }
  const Tree tree(mesh, parts);
  labels.count = parts;
  labels.of_triangle.resize(mesh.triangles.size());
  team.each_range(mesh.triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const auto t = static_cast<std::uint32_t>(k);
      labels.of_triangle[k] = mesh.is_hole(t) ? kNone : tree.part_at(middle_of(mesh, t));
    }
  });
  return labels;
}

}  // namespace cover
