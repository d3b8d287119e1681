// Random unit cells and sectors with periodic sides, and an independent look at their meshes.
#pragma once

#include <cstdint>
#include <string>

#include <cover/cover_mesh.hpp>

namespace cover::testing {

/// A cell with wavy sides 'left', 'right', 'bottom' and 'top', whose opposite sides are images of
/// each other up to rounding, with inclusions in it. With `gaps`, some points on straight parts are
/// on one side only. The rules are in Input::periodic.
Input random_cell(std::uint64_t seed, bool gaps);

/// A sector of a ring, or of a disk, with wavy radial sides 'start' and 'end', images of each other
/// by rotation or, where `mirror`, by reflection.
Input random_sector(std::uint64_t seed, bool gaps, bool mirror);

/// What is wrong with the pairs of `output`, empty if nothing: vertices on the lines of a rule that
/// have no partner or two, partners that are no images within 1e-9 of the mesh, edges without
/// images. Looks at coordinates and names of lines only.
std::string unpaired(const Output& output);

}  // namespace cover::testing
