// The manifest that lies beside a mesh: names, interfaces and their edges.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <cover/result.hpp>
#include <cover/stored_mesh.hpp>

namespace cover {

/// Fills everything but the triangles of `stored` from a manifest; false, and nothing is changed,
/// if the file is not there or is something else (a report, a geometry). Where the mesh's file does
/// not say to which regions triangles belong, their groups and their order do: within a group they
/// stand by region.
///
/// REQUIRES: stored.soup holds the mesh; `group` by triangle, or empty where materials are known
/// Errors:   cannot_open; syntax, also if the manifest is of another mesh
Result<bool> read_manifest(const std::string& path, std::span<const std::int64_t> group,
                           StoredMesh& stored);

}  // namespace cover
