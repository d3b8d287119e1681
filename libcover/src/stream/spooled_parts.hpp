// What a mesh on the disk needs in memory.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/share_out.hpp>
#include <cover/stream_mesh.hpp>

#include <cover/mesh_view.hpp>
#include "io/write_mesh/mesh_spool.hpp"

namespace cover {

struct SpooledParts {
  MeshSpool spool;
  std::vector<std::uint32_t> vertex_of;  ///< by VertexId: in the mesh; kNone: not there
  /// By SegmentId: twice the first of its half-edges in its first region, counted there, and one
  /// more if that leads from the segment's second point to its first; kNone: not in the mesh.
  std::vector<std::uint32_t> first_half_edge;
  WriteElsewhere elsewhere;  ///< where some regions are in other processes
};

/// The region whose triangles come first beside a segment; kVoid: none.
RegionId first_region(const SegmentSides& sides);

/// The edges of the mesh that are segments.
std::vector<LineEdge> lines_of(const Pslg& pslg, const RegionTable& table,
                               const SpooledParts& parts);

}  // namespace cover
