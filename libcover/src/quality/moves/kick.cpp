// See kick.hpp.
#include "quality/moves/kick.hpp"

#include "geom/triangle.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/optimum/min_max_polygon.hpp"

namespace cover {

namespace {

bool put_inside(MutableMesh& mesh, std::uint32_t t) {
  Cavity cavity(mesh);
  cavity.start(t);
  const Point p = centroid(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
  Installed installed;
  return install_star(mesh, cavity, p, installed);
}

bool put_on_edge(MutableMesh& mesh, std::uint32_t t, Corner i) {
  Cavity cavity(mesh);
  cavity.start(t);
  Installed installed;
  return cavity.grow(static_cast<int>(i)) &&
         install_star(mesh, cavity, midpoint(mesh.corner(t, i), mesh.corner(t, i.next())),
                      installed);
}

bool remove_corner(MutableMesh& mesh, std::uint32_t t, Corner i) {
  const std::uint32_t v = mesh.triangles[t].v[i];
  Cavity cavity(mesh);
  Patch patch;
  Installed installed;
  return !mesh.is_fixed(v) && cavity.start_star(v) &&
         min_max_polygon(mesh, cavity, kInverted, patch) < kInverted &&
         install_patch(mesh, cavity, patch, installed);
}

}  // namespace

bool do_kick(MutableMesh& mesh, std::uint32_t t, Kick kick) {
  const Corner i = kick.at;
  switch (kick.what) {
    case Kick::What::vertex_inside:
      return put_inside(mesh, t);
    case Kick::What::vertex_on_edge:
      return put_on_edge(mesh, t, i);
    case Kick::What::flip:
      return !is_side(mesh.triangles[t].n[i]) && mesh.flip(t, i);
    case Kick::What::removal:
      return remove_corner(mesh, t, i);
  }
  return false;
}

}  // namespace cover
