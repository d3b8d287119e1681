// Attributes of regions and values at points that came with the input of a run, as a file of its
// mesh holds them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>

namespace cover {

/// What arrays of words mean, by their names.
using ArrayWords = std::map<std::string, std::vector<std::string>>;

/// Gives `stored` the arrays of its file that are not our own: those of triangles as attributes of
/// regions, those of points as fields. What a manifest said of them before counts; of its fields
/// the values come now.
///
/// REQUIRES: the regions of the triangles are known, in the order of the file; arrays fit the mesh
/// Returns:  a sentence for what is left out: arrays that differ within a region, fields of the
///           manifest that the file does not have
std::vector<std::string> take_arrays(std::vector<CellArray> of_triangles,
                                     std::vector<PlaneField::Array> of_points,
                                     const ArrayWords& words, StoredMesh& stored);

}  // namespace cover
