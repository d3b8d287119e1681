// Border edges become sides that force nothing: a corner between two of them counts as the input's
// own, and rightly so, because nothing inside can change it.
// Tested by tests/unit/quality/parts/excerpt_test.cpp.
#include "quality/parts/excerpt.hpp"

#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace cover {
namespace {

using Numbers =
    std::unordered_map<std::uint32_t, std::uint32_t>;  ///< from the whole to the excerpt
}  // namespace

std::vector<std::uint32_t> triangles_around(const MutableMesh& whole, std::uint32_t t,
                                            std::size_t most,
                                            std::span<const std::uint32_t> beyond) {
  std::vector<std::uint32_t> found{t};
  std::unordered_set<std::uint32_t> seen{t};
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (std::uint32_t n : whole.triangles[found[k]].n) {
      if (is_side(n)) n = beyond.empty() ? kNone : beyond[side_index(n)];
      if (n == kNone || found.size() >= most) continue;
      if (seen.insert(n).second) found.push_back(n);
    }
  }
  return found;
}

Excerpt::Excerpt(const MutableMesh& whole, std::uint32_t t, std::size_t most,
                 std::span<const std::uint32_t> beyond, std::uint32_t spare_of_whole) {
  Numbers triangle_number, vertex_number;
  triangles_ = triangles_around(whole, t, most, beyond);
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) triangle_number[triangles_[k]] = k;
  const auto is_inside = [&](std::uint32_t n) {
    return !is_side(n) && triangle_number.contains(n);
  };

  // Vertices that are fixed or on the border come first.
  std::vector<std::uint32_t> inner;
  const auto number = [&](std::uint32_t v) {
    if (vertex_number.emplace(v, static_cast<std::uint32_t>(vertices_.size())).second) {
      vertices_.push_back(v);
    }
  };
  for (const std::uint32_t place : triangles_) {
    const auto& [v, n] = whole.triangles[place];
    for (const Corner i : kCorners) {
      if (!is_inside(n[i])) number(v[i.next()]), number(v[i.previous()]);
      (whole.is_fixed(v[i]) ? number(v[i]) : inner.push_back(v[i]));
    }
  }
  if (spare_of_whole != kNone) {
    spare = static_cast<std::uint32_t>(vertices_.size());
    number(spare_of_whole);
  }
  const auto fixed = static_cast<std::uint32_t>(vertices_.size());
  for (const std::uint32_t v : inner) number(v);

  Triangulation copy;
  for (const std::uint32_t v : vertices_) copy.points.push_back(whole.points[v]);
  std::vector<EdgeRef> side_at;
  std::vector<SideLimit> limits;
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
    const auto& [v, n] = whole.triangles[triangles_[k]];
    Triangle& triangle = copy.triangles.emplace_back();
    for (const Corner i : kCorners) {
      triangle.v[i] = vertex_number[v[i]];
      if (is_inside(n[i])) {
        triangle.n[i] = triangle_number[n[i]];
        continue;
      }
      side_at.push_back({k, static_cast<std::uint8_t>(i)});
      outside.push_back(n[i]);
      limits.push_back(is_side(n[i]) ? whole.sides[side_index(n[i])] : kNoLimit);
      if (is_side(n[i]) || !whole.goal().coupling.inside) continue;
      limits.back().least_cot = -whole.cot_opposite(n[i], v[i.previous()]);
      limits.back().is_inner = true;
    }
  }
  mesh = MutableMesh(copy, fixed, side_at, std::move(limits));
  mesh.set_goal(whole.goal());
}

std::vector<std::uint32_t> Excerpt::replace(MutableMesh& whole, const MutableMesh& improved) const {
  std::vector<std::uint32_t> vertex(improved.points.size(), kNone);
  for (std::size_t v = improved.points.size(); v < vertices_.size(); ++v)
    whole.drop_vertex(vertices_[v]);
  for (std::uint32_t v = 0; v < improved.points.size(); ++v) {
    const bool is_old = v < vertices_.size();
    if (improved.home[v] == kNone) {
      if (is_old && !improved.is_fixed(v)) whole.drop_vertex(vertices_[v]);
      continue;
    }
    vertex[v] = is_old ? vertices_[v] : whole.add_vertex(improved.points[v]);
    whole.points[vertex[v]] = improved.points[v];
  }
  std::vector<std::uint32_t> place(improved.triangles.size(), kNone), used;
  for (std::uint32_t t = 0; t < improved.triangles.size(); ++t) {
    if (improved.is_hole(t)) continue;
    place[t] = used.size() < triangles_.size() ? triangles_[used.size()] : whole.add_triangle();
    used.push_back(place[t]);
  }
  for (std::size_t k = used.size(); k < triangles_.size(); ++k) whole.drop_triangle(triangles_[k]);
  for (std::uint32_t t = 0; t < improved.triangles.size(); ++t) {
    if (improved.is_hole(t)) continue;
    MeshTriangle& triangle = whole.triangles[place[t]];
    for (const Corner i : kCorners) {
      triangle.v[i] = vertex[improved.triangles[t].v[i]];
      whole.home[triangle.v[i]] = place[t];
    }
    for (const Corner i : kCorners) {
      const std::uint32_t n = improved.triangles[t].n[i];
      triangle.n[i] = is_side(n) ? outside[side_index(n)] : place[n];
      if (is_side(n)) {
        whole.link(triangle.n[i], triangle.v[i.next()], triangle.v[i.previous()], place[t]);
      }
    }
    if (!whole.goal().coupling.inside) whole.measure(place[t]);
  }
  if (whole.goal().coupling.inside) {  // only now are their neighbours in place
    for (const std::uint32_t t : used) whole.measure(t);
    for (const std::uint32_t n : outside) whole.measure_beyond(n);
  }
  return used;
}

}  // namespace cover
