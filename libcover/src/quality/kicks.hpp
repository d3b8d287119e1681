// Out of local optima: steps that make a triangulation worse first.
#pragma once

#include "quality/merit.hpp"
#include "quality/mutable_mesh.hpp"
#include "quality/optimise.hpp"

namespace cover {

/// Tries, for every triangle with a larger angle than the goal allows: a vertex in its middle or on
/// one of its edges, a flip, the removal of a vertex; and improves what comes of it. Keeps what is
/// better by `goal`, and goes on from there.
///
/// REQUIRES: `mesh` is improved, `merit` is its merit by `goal`; the goal it has set is that of the
/// improvement Cost:     each attempt copies the mesh
void improve_by_kicks(MutableMesh& mesh, const Goal& goal, Merit& merit, Budget& budget);

}  // namespace cover
