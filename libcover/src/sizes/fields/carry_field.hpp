// Values that the input has beside its geometry, at the vertices of a mesh.
#pragma once

#include <vector>

#include <cover/mesh_class.hpp>
#include <cover/plane_field.hpp>
#include <cover/report.hpp>

namespace cover {

/// The arrays of `field` at the vertices of `mesh`, as Output::fields has them. Vertices that lie
/// outside the field by more than rounding are told in `notes`.
///
/// Cost: O((n + m) log m) for n vertices and m triangles of the field, typically.
std::vector<PlaneField::Array> carry_field(const PlaneField& field, const Mesh& mesh,
                                           std::vector<Note>& notes);

}  // namespace cover
