// See put_back.hpp. Tested by tests/unit/quality/parts/work_in_parts_test.cpp.
#include "quality/parts/put_back.hpp"
#include "base/containers/give_back.hpp"

#include <algorithm>
#include <utility>

namespace cover {

bool is_other_in_whole(const PartInWork& part, std::uint32_t t) {
  const MutableMesh& mesh = part.given.mesh;
  const auto& [v, n] = mesh.triangles[t];
  return std::any_of(n.begin(), n.end(),
                     [&](std::uint32_t s) {
                       return is_side(s) && side_index(s) >= part.given.first_border;
                     }) ||
         std::all_of(v.begin(), v.end(), [&](std::uint32_t u) { return mesh.is_fixed(u); });
}

void PutBack::put(PartInWork& part) {
  Part& given = part.given;
  const std::vector<std::uint32_t> place = place_triangles(part);
  place_vertices(part);
  put_vertices(part, place);
  put_triangles(part, place);
  given.mesh = {};
  give_back(part.whole_side);
  if (given.tells_places) {
    given.triangles = place;
  } else {
    give_back(given.triangles);
    give_back(given.vertices);
  }
}

std::vector<std::uint32_t> PutBack::place_triangles(PartInWork& part) const {
  const MutableMesh& mesh = part.given.mesh;
  part.triangles.spare = std::move(part.given.triangles);
  std::vector<std::uint32_t> place(mesh.triangles.size(), kNone);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.is_hole(t)) place[t] = part.triangles.next(triangles_);
  }
  part.triangles.leave_rest();
  return place;
}

void PutBack::place_vertices(PartInWork& part) const {
  const MutableMesh& mesh = part.given.mesh;
  std::vector<std::uint32_t>& place = part.given.vertices;
  for (std::uint32_t v = mesh.fixed_vertices(); v < part.own_vertices; ++v) {
    if (mesh.home[v] == kNone) part.vertices.spare.push_back(std::exchange(place[v], kNone));
  }
  place.resize(mesh.points.size(), kNone);
  for (std::uint32_t v = part.own_vertices; v < mesh.points.size(); ++v) {
    if (mesh.home[v] != kNone) place[v] = part.vertices.next(vertices_);
  }
  part.vertices.leave_rest();
}

void PutBack::put_vertices(PartInWork& part, std::span<const std::uint32_t> place) {
  const MutableMesh& mesh = part.given.mesh;
  const std::vector<std::uint32_t>& vertices = part.given.vertices;
  part.extras.points.reserve(part.vertices.extra);
  part.extras.home.reserve(part.vertices.extra);
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    const std::uint32_t to = vertices[v];
    if (to == kNone) continue;
    const std::uint32_t home = place[mesh.home[v]];
    if (to >= vertices_) {
      part.extras.points.push_back(mesh.points[v]);
      part.extras.home.push_back(home);
    } else if (v < mesh.fixed_vertices() && owners_.is_shared(to)) {
      part.homes.emplace_back(to, home);
    } else {
      whole_.points[to] = mesh.points[v];
      whole_.home[to] = home;
      if (is_extra_triangle(home)) part.home_of_extras.push_back(to);
    }
  }
}

void PutBack::put_triangles(PartInWork& part, std::span<const std::uint32_t> place) {
  const MutableMesh& mesh = part.given.mesh;
  part.extras.triangles.reserve(part.triangles.extra);
  part.extras.excess.reserve(part.triangles.extra);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const std::uint32_t to = place[t];
    bool tells_extras = false;
    const MeshTriangle triangle = placed(part, t, place, tells_extras);
    if (is_other_in_whole(part, t)) part.to_measure.push_back(to);
    if (is_extra_triangle(to)) {
      part.extras.triangles.push_back(triangle);
      part.extras.excess.push_back(mesh.excess[t]);
      continue;
    }
    whole_.triangles[to] = triangle;
    whole_.excess[to] = mesh.excess[t];
    if (tells_extras) part.beside_extras.push_back(to);
  }
}

/// Triangle `t` of a part by the places of all.
MeshTriangle PutBack::placed(PartInWork& part, std::uint32_t t,
                             std::span<const std::uint32_t> place, bool& tells_extras) const {
  const MeshTriangle& from = part.given.mesh.triangles[t];
  MeshTriangle to;
  for (const Corner i : kCorners) {
    const std::uint32_t n = from.n[i];
    to.v[i] = part.given.vertices[from.v[i]];
    if (!is_side(n)) {
      to.n[i] = place[n];
      tells_extras |= is_extra_triangle(to.n[i]);
    } else if (side_index(n) < part.given.first_border) {
      to.n[i] = part.whole_side[side_index(n)];
    } else {
      BorderEdge& edge = part.border[side_index(n) - part.given.first_border];
      edge.triangle = place[t];
      edge.edge = i;
      to.n[i] = kSomeTriangle;
    }
    tells_extras |= to.v[i] >= vertices_;
  }
  return to;
}

void PutBack::make_room(std::span<PartInWork> parts, const Team& team) {
  std::size_t triangles = 0, vertices = 0;
  for (const PartInWork& part : parts) {
    triangles += part.triangles.extra;
    vertices += part.vertices.extra;
  }
  whole_.reserve_more(triangles, vertices, team);
  for (PartInWork& part : parts) {
    part.triangle_ids.resize(part.triangles.extra);
    whole_.add_triangles(part.triangle_ids);
    for (const std::uint32_t t : part.triangles.spare) whole_.drop_triangle(t);
    part.vertex_ids.resize(part.vertices.extra);
    whole_.add_vertices(part.vertex_ids);
    for (const std::uint32_t v : part.vertices.spare) whole_.drop_vertex(v);
  }
}

void PutBack::put_extras(PartInWork& part) {
  const auto settle_triangle = [&](std::uint32_t& t) {
    if (t >= triangles_ && t < kSomeTriangle) t = part.triangle_ids[t - triangles_];
  };
  const auto settle_vertex = [&](std::uint32_t& v) {
    if (v >= vertices_ && v != kNone) v = part.vertex_ids[v - vertices_];
  };
  const auto settle = [&](MeshTriangle& triangle) {
    for (std::uint32_t& v : triangle.v) settle_vertex(v);
    for (std::uint32_t& n : triangle.n) settle_triangle(n);
  };
  for (const std::uint32_t t : part.beside_extras) settle(whole_.triangles[t]);
  for (const std::uint32_t v : part.home_of_extras) settle_triangle(whole_.home[v]);
  for (std::size_t k = 0; k < part.triangle_ids.size(); ++k) {
    settle(part.extras.triangles[k]);
    whole_.triangles[part.triangle_ids[k]] = part.extras.triangles[k];
    whole_.excess[part.triangle_ids[k]] = part.extras.excess[k];
  }
  for (std::size_t k = 0; k < part.vertex_ids.size(); ++k) {
    settle_triangle(part.extras.home[k]);
    whole_.points[part.vertex_ids[k]] = part.extras.points[k];
    whole_.home[part.vertex_ids[k]] = part.extras.home[k];
  }
  part.extras = {};
  for (BorderEdge& edge : part.border) settle_triangle(edge.triangle);
  for (std::uint32_t& t : part.to_measure) settle_triangle(t);
  for (auto& [v, t] : part.homes) settle_triangle(t);
  for (std::uint32_t& t : part.given.triangles) settle_triangle(t);
  for (std::uint32_t& v : part.given.vertices) settle_vertex(v);
}

}  // namespace cover
