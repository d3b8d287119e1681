// See cavity.hpp. Tested by tests/unit/quality/mutable/cavity_test.cpp.
#include "quality/mutable/cavity.hpp"

#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Gives the places of the old triangles to `count` new ones, takes more or gives some back.
void reuse_places(MutableMesh& mesh, const Cavity& cavity, int count, Installed& installed) {
  installed.count = count;
  for (int k = 0; k < count; ++k) {
    installed.triangles[at(k)] =
        k < cavity.triangle_count() ? cavity.triangle(k) : mesh.add_triangle();
  }
  for (int k = count; k < cavity.triangle_count(); ++k) mesh.drop_triangle(cavity.triangle(k));
}

/// Whether all triangles from the loop to `p` are counter-clockwise, exactly.
bool sees_loop(const MutableMesh& mesh, const Cavity& cavity, Point p) {
  const Point* const points = mesh.points.data();
  Point a = points[cavity.vertex(cavity.size() - 1)];
  for (int k = 0; k < cavity.size(); ++k) {
    const Point b = points[cavity.vertex(k)];
    if (orientation(a, b, p) != Sign::positive) return false;
    a = b;
  }
  return true;
}

}  // namespace

void Cavity::take(std::uint32_t t, const double* excess) {
  triangles_[at(triangle_count_++)] = t;
  worst_ = std::max(worst_, excess[t]);
}

void Cavity::erase(int k) {
  for (int m = k; m + 1 < size_; ++m) loop_[at(m)] = loop_[at(m + 1)];
  --size_;
}

void Cavity::start(std::uint32_t t) {
  const MeshTriangle& s = mesh_->triangles[t];
  size_ = 3;
  triangle_count_ = swallowed_count_ = 0;
  worst_ = -kInverted;
  for (const Corner i : kCorners) loop_[i] = {s.v[i], s.n[i.previous()]};
  take(t, mesh_->excess.data());
}

bool Cavity::start_star(std::uint32_t v) {
  size_ = triangle_count_ = 0;
  swallowed_count_ = 1;
  swallowed_[0] = v;
  worst_ = -kInverted;
  const std::uint32_t home = mesh_->home[v];
  const MeshTriangle* const triangles = mesh_->triangles.data();
  const double* const excess = mesh_->excess.data();
  std::uint32_t t = home;
  do {
    if (size_ == kCapacity) return false;
    const auto& [corners, across] = triangles[t];
    const Corner i = triangles[t].corner_of(v);
    loop_[at(size_++)] = {corners[i.next()], across[i]};
    take(t, excess);
    t = across[i.next()];
  } while (t != home);
  return true;
}

bool Cavity::grow(int k) {
  const std::uint32_t t = outer(k);
  if (is_side(t) || triangle_count_ == kCapacity) return false;
  const MeshTriangle& s = mesh_->triangles.data()[t];
  const double* const excess = mesh_->excess.data();
  const int after = next(k), before = previous(k);
  const Corner j = s.edge_from(vertex(after));  // edge j of s runs from the end to the start of k
  const std::uint32_t c = s.v[j];
  const std::uint32_t first = s.n[j.next()];       // across start - c
  const std::uint32_t second = s.n[j.previous()];  // across c - end
  // Where c is the end of the next edge, or the start of the one before, the vertex between that
  // and k is swallowed: `edge` takes the place of itself and of the one behind it.
  const auto swallow = [&](int edge, int behind, std::uint32_t beyond) {
    const std::uint32_t inner = vertex(behind);
    if (size_ <= 3 || mesh_->is_fixed(inner)) return false;
    loop_[at(edge)].outer = beyond;
    swallowed_[at(swallowed_count_++)] = inner;
    take(t, excess);
    erase(behind);
    return true;
  };
  if (outer(after) == t) return swallow(k, after, first);
  if (outer(before) == t) return swallow(before, k, second);
  if (size_ == kCapacity) return false;
  for (int m = 0; m < size_; ++m) {
    if (vertex(m) == c) return false;
  }
  for (int m = size_; m > k + 1; --m) loop_[at(m)] = loop_[at(m - 1)];
  ++size_;
  loop_[at(k)].outer = first;
  loop_[at(k + 1)] = {c, second};
  take(t, excess);
  return true;
}

bool Cavity::sees_beyond(int k, Point p) const {
  const std::uint32_t t = outer(k);
  if (is_side(t)) return false;
  const MeshTriangle& s = mesh_->triangles[t];
  const Point c = mesh_->points[s.v[s.edge_from(vertex(next(k)))]];
  const Vector to_a = mesh_->points[vertex(k)] - p, to_b = mesh_->points[vertex(next(k))] - p;
  return cross(to_a, c - p) > 0 && cross(c - p, to_b) > 0;
}

bool install_star(MutableMesh& mesh, const Cavity& cavity, Point p, Installed& installed) {
  if (!sees_loop(mesh, cavity, p)) return false;
  const int size = cavity.size();
  for (int k = 0; k < cavity.swallowed_count(); ++k) mesh.drop_vertex(cavity.swallowed(k));
  const std::uint32_t apex = mesh.add_vertex(p);
  reuse_places(mesh, cavity, size, installed);
  for (int k = 0; k < size; ++k) {
    const int before = cavity.previous(k);
    const std::uint32_t t = installed.triangles[at(k)];
    const std::uint32_t a = cavity.vertex(k), b = cavity.vertex(cavity.next(k));
    mesh.triangles[t] = {{a, b, apex},
                         {installed.triangles[at(cavity.next(k))], installed.triangles[at(before)],
                          cavity.outer(k)}};
    mesh.link(cavity.outer(k), a, b, t);
    mesh.home[a] = t;
  }
  mesh.home[apex] = installed.triangles[0];
  for (int k = 0; k < size; ++k) mesh.measure(installed.triangles[at(k)]);
  for (int k = 0; k < size; ++k) mesh.measure_beyond(cavity.outer(k));
  return true;
}

bool relocate(MutableMesh& mesh, const Cavity& cavity, Point p) {
  if (!sees_loop(mesh, cavity, p)) return false;
  mesh.points[cavity.swallowed(0)] = p;
  for (int k = 0; k < cavity.triangle_count(); ++k) mesh.measure(cavity.triangle(k));
  for (int k = 0; k < cavity.size(); ++k) mesh.measure_beyond(cavity.outer(k));
  return true;
}

bool install_patch(MutableMesh& mesh, const Cavity& cavity, const Patch& patch,
                   Installed& installed) {
  // Where rounding leaves a triangle of the cavity flat, no patch at all may count as no worse.
  if (patch.count() != cavity.size() - 2 + (patch.inserted ? 2 : 0)) return false;
  const auto point = [&](int corner) {
    return corner < cavity.size() ? mesh.points[cavity.vertex(corner)] : *patch.inserted;
  };
  for (int k = 0; k < patch.count(); ++k) {
    const auto& [a, b, c] = patch.corners(k);
    if (orientation(point(a), point(b), point(c)) != Sign::positive) return false;
  }
  for (int k = 0; k < cavity.swallowed_count(); ++k) mesh.drop_vertex(cavity.swallowed(k));
  const std::uint32_t apex = patch.inserted ? mesh.add_vertex(*patch.inserted) : kNone;
  const auto vertex = [&](int corner) {
    return corner < cavity.size() ? cavity.vertex(corner) : apex;
  };
  reuse_places(mesh, cavity, patch.count(), installed);
  for (int k = 0; k < patch.count(); ++k) {
    MeshTriangle& t = mesh.triangles[installed.triangles[at(k)]];
    for (const Corner i : kCorners) {
      const int from = patch.corners(k)[i.next()], to = patch.corners(k)[i.previous()];
      t.v[i] = vertex(patch.corners(k)[i]);
      mesh.home[t.v[i]] = installed.triangles[at(k)];
      if (from < cavity.size() && to == cavity.next(from)) {  // on the loop
        t.n[i] = cavity.outer(from);
        mesh.link(t.n[i], cavity.vertex(from), cavity.vertex(to), installed.triangles[at(k)]);
        continue;
      }
      for (int m = 0; m < patch.count(); ++m) {  // inside: another triangle has it backwards
        const Patch::Corner& other = patch.corners(m);
        for (const Corner j : kCorners) {
          if (other[j] == to && other[j.next()] == from) t.n[i] = installed.triangles[at(m)];
        }
      }
    }
  }
  for (int k = 0; k < patch.count(); ++k) mesh.measure(installed.triangles[at(k)]);
  for (int k = 0; k < cavity.size(); ++k) mesh.measure_beyond(cavity.outer(k));
  return true;
}

}  // namespace cover
