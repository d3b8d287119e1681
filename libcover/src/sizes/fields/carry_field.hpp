// Values that the input has beside its geometry, at the vertices of a mesh.
#pragma once

#include <vector>

#include <cover/mesh_class.hpp>
#include <cover/output.hpp>
#include <cover/plane_field.hpp>
#include <cover/report.hpp>

namespace cover {

/// Values of Output: its fields and those of regions.
struct CarriedField {
  std::vector<PlaneField::Array> fields;
  RegionValues region_values;
};

/// The arrays of `field` at the vertices of `mesh`, as Output has them. Vertices that lie
/// outside the field by more than rounding are told in `notes`.
///
/// Cost: O((n + m) log m) for n vertices and m triangles of the field, typically.
CarriedField carry_field(const PlaneField& field, const Mesh& mesh, std::vector<Note>& notes);

}  // namespace cover
