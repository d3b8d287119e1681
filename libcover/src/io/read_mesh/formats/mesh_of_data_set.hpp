// What is a mesh in a data set of VTK's.
#pragma once

#include <functional>
#include <string>

#include <cover/read_mesh.hpp>
#include <cover/result.hpp>

#include "io/read_mesh/mesh_collector.hpp"
#include "io/vtk_files/data_set.hpp"

namespace cover {

/// Triangles, lines with a LineID, and arrays; `add` may add lines that are no cells, between
/// points that are there.
///
/// Errors: syntax, where there are no triangles
Result<MeshFile> mesh_of(const DataSet& data, const std::string& path,
                         const std::function<void(MeshCollector&)>& add = {});

}  // namespace cover
