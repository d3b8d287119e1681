// What the calls of the library hand out.
#pragma once

#include <cover/mesh_class.hpp>
#include <cover/periodic.hpp>
#include <cover/plane_field.hpp>
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
};

}  // namespace cover
