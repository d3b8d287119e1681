// A run as far as its regions are meshed, for what comes after.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include <cover/cover_mesh.hpp>

#include "cuts/work.hpp"
#include "region/region_graph.hpp"
#include "tasks/mesh_regions.hpp"

namespace cover {

/// The regions of `input`, meshed one by one, no segment cut.
inline Work meshed(const Input& input, const Options& options) {
  Options whole = options;
  whole.split_interfaces.reset();
  Result<Prepared> prepared = prepare(input, whole);
  EXPECT_TRUE(prepared) << prepared.error().message;
  Work work{*std::move(prepared)};
  work.boundaries = split_regions(work.pslg, work.table);
  Result<std::vector<RegionMesh>> meshes = mesh_regions(work.boundaries, options, {});
  EXPECT_TRUE(meshes) << meshes.error().message;
  work.meshes = *std::move(meshes);
  return work;
}

}  // namespace cover
