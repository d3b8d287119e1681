// Meshes compared by their geometry, whatever their ids.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

namespace cover::testing {

/// The mesh of an input that must not fail.
Output must_mesh(const Input& input, const Options& options = {});

/// What verify_cover() finds, a line each; empty if every promise holds.
std::string violations(const Output& output, const VerifyOptions& options = {});

/// The triangles of a mesh by coordinates, each from its smallest corner, with their material.
using Shape = std::set<std::pair<std::array<Point, 3>, std::int64_t>>;

/// The shape of `soup`, with every coordinate taken back by `shift`, then by `factor`.
Shape shape_of(const TriangleSoup& soup, double factor = 1, Point shift = {0, 0});

/// The triangles of one region.
TriangleSoup part_of(const TriangleSoup& soup, RegionId region);

/// One region of a mesh as an input of its own: its segments, its points, its material.
Input region_alone(const Output& output, RegionId region);

}  // namespace cover::testing
