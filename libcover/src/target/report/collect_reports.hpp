// From the reports of regions to that of the whole.
// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#pragma once

#include <utility>
#include <vector>

#include <cover/report.hpp>

#include "region/region_mesh.hpp"
#include "target/report/measure_angles.hpp"

namespace cover {

/// Moves what the regions report to the report of the whole, in region order.
inline void collect_reports(std::vector<RegionMesh>& meshes, Report& report) {
  for (RegionMesh& mesh : meshes) {
    merge(report.quality, mesh.report.quality);
    report.steiner_vertices += mesh.report.steiner_vertices;
    report.regions.push_back(std::move(mesh.report));
  }
}

}  // namespace cover
