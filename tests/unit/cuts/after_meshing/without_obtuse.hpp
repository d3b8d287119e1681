// Meshes without obtuse angles, verified.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"

namespace cover {

/// Segments may be cut until no triangle is obtuse.
inline Options no_obtuse_angle() {
  Options options;
  options.max_angle = Angle::degrees(90);
  options.split_interfaces = Angle::degrees(90);
  options.threads = 1;
  return options;
}

/// A mesh that keeps every promise, on the segments that it has cut.
inline Output mesh_of(const Input& input, const Options& options = no_obtuse_angle()) {
  Result<Output> output = cover_mesh(input, options);
  EXPECT_TRUE(output.has_value()) << output.error().message;
  for (const Violation& v :
       verify_cover(output->pslg, output->table, triangle_soup(output->mesh)).violations) {
    ADD_FAILURE() << v.message;
  }
  // A cut makes one segment two.
  EXPECT_EQ(output->pslg.segments.size() - output->report.input_segments,
            output->pslg.points.size() - output->report.input_points);
  return *std::move(output);
}

/// The mesh has the same bytes on three threads, and the same triangles in another unit.
inline void expect_same_for_threads_and_unit(const Input& input) {
  Options options = no_obtuse_angle();
  options.threads = 3;
  const TriangleSoup one = triangle_soup(mesh_of(input).mesh);
  const TriangleSoup three = triangle_soup(mesh_of(input, options).mesh);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.triangles, three.triangles);
  const Output tiny = mesh_of(testing::transformed(input, 0x1p-30, {0, 0}));
  EXPECT_EQ(triangle_soup(tiny.mesh).triangles, one.triangles);
}

}  // namespace cover
