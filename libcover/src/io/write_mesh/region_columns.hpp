// Arrays of a file whose numbers belong to regions, written region by region to their places: by
// several threads, and by several processes that have some of the regions each.
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <cover/result.hpp>

#include "base/team.hpp"
#include "io/write_mesh/mesh_spool.hpp"

namespace cover {

/// What an array holds: numbers of vertices, or of triangles.
enum class Column : std::uint8_t {
  places,    ///< of vertices, three Float64 each
  corners,   ///< of triangles, three Int64 each
  ends,      ///< Int64: 0, and after each triangle the number of corners up to there
  types,     ///< UInt8: VTK's triangles
  material,  ///< Int32, as the next one
  region,
  largest,  ///< Float64: angles in degrees
  smallest
};

/// Where an array stands in the file.
struct ColumnPlace {
  Column column = Column::places;
  std::uint64_t at = 0;
};

/// How many a region has of its own, and its material.
struct RegionCounts {
  std::uint32_t steiner = 0;
  std::uint32_t triangles = 0;
  std::int32_t material = 0;
};

/// What each process needs to know of the whole. Region r has the RegionId r + 1.
struct ColumnPlan {
  std::string path;   ///< of the file, which is there and has its length
  std::string shown;  ///< its name in messages
  std::uint64_t input_vertices = 0;
  std::vector<ColumnPlace> columns;
  std::vector<RegionCounts> regions;
};

/// Writes the numbers of the regions that `spool` has, and those of the input if it has these.
///
/// Errors: cannot_write, cancelled
/// Memory: some megabytes for each thread, 16 bytes for each region
Status write_columns(const MeshSpool& spool, const ColumnPlan& plan, const std::stop_token& stop,
                     const Team& team);

}  // namespace cover
