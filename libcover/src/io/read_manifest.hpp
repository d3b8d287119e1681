// The manifest that lies beside a mesh: names, interfaces and their edges.
#pragma once

#include <string>

#include <cover/result.hpp>
#include <cover/stored_mesh.hpp>

namespace cover {

/// Fills everything but the triangles of `stored` from a manifest; false, and nothing is changed,
/// if the file is not there or is something else (a report, a geometry).
///
/// REQUIRES: stored.soup holds the mesh
/// Errors:   cannot_open; syntax, also if the manifest is of another mesh
Result<bool> read_manifest(const std::string& path, StoredMesh& stored);

}  // namespace cover
