// What the calls of the library hand out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <cover/mesh_class.hpp>
#include <cover/periodic.hpp>
#include <cover/plane_field.hpp>
#include <cover/point.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>

namespace cover {

/// Input made clean: what is meshed, and what it took.
struct Prepared {
  Pslg pslg;
  RegionTable table;
  Report report;  ///< gamma_opt and bound per region, changes and warnings; no mesh figures
};

/// An edge whose node of second order is not the double next to its middle.
struct MovedNode {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Point middle;
};

/// What `cover_mesh` returns.
struct Output {
  Mesh mesh;
  Pslg pslg;
  RegionTable table;
  Report report;
  std::vector<PeriodicNodes> periodic{};  ///< by rule: Options::periodic, then Input::periodic
  /// Values of Input::field at the vertices of the mesh, linear in its triangles; of several in one
  /// place, where a value jumps, the one of the largest magnitude. Outside the field, that of the
  /// nearest place on its border. NaN: none.
  std::vector<PlaneField::Array> fields{};
  /// Of a mesh that was read from triangles of six nodes: those off the middles of their edges,
  /// where no manifest tells the arcs that they lie on. Nothing: triangles had three nodes.
  std::optional<std::vector<MovedNode>> nodes{};
};

}  // namespace cover
