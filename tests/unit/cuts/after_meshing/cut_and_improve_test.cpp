#include "cuts/after_meshing/cut_and_improve.hpp"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "geom/vector.hpp"
#include "support/inputs/inputs.hpp"
#include "without_obtuse.hpp"

namespace cover {
namespace {

/// Thin rectangles beside and above each other, whose corners do not face each other.
Input layers() {
  Input input;
  const auto rectangle = [&](double x0, double y0, double x1, double y1, const char* material) {
    InputPolygon polygon;
    polygon.rings = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
    polygon.material = material;
    input.polygons.push_back(polygon);
  };
  rectangle(0, 0, 10, 4, "bulk");
  rectangle(0, 2.7, 3, 4, "source");
  rectangle(7, 2.5, 10, 4, "drain");
  rectangle(2.5, 4, 7.6, 4.05, "oxide");
  rectangle(2.6, 4.05, 7.4, 5, "gate");
  return input;
}

TEST(CutAndImprove, LeavesNoObtuseTriangleInADeviceOfRectangles) {
  const Output output = mesh_of(layers());
  EXPECT_EQ(output.report.quality.obtuse, 0u);
  EXPECT_LT(output.mesh.tri().n_vertices(), 200u);
  for (const RegionReport& region : output.report.regions) {
    for (const Note& note : region.notes) {
      EXPECT_EQ(note.message.find("above 90"), std::string::npos) << note.message;
    }
  }
}

/// The mesh that comes after sees the sizes asked for, and takes no vertices away (thin_cuts).
TEST(CutAndImprove, KeepsTheSizesAskedFor) {
  for (const double size : {2.0, 0.7}) {
    Options options = no_obtuse_angle();
    options.sizes = {{"", size, false}};
    const Output output = mesh_of(layers(), options);
    const TriangleSoup soup = triangle_soup(output.mesh);
    double longest = 0;
    for (const auto& [a, b, c] : soup.triangles) {
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        longest = std::max(longest, length(soup.points[to] - soup.points[from]));
    }
    EXPECT_LT(longest, 2 * size);
    for (const Note& note : output.report.notes)
      EXPECT_EQ(note.message.find("taken away"), std::string::npos) << note.message;
  }
}

/// A border in steps of pixels from one corner of a square with long sides to the middle.
Input stairs() {
  const double n = 10, wall = 24;
  std::vector<Point> steps;
  for (double k = 0; k < n; ++k) {
    steps.push_back({k, k});
    steps.push_back({k + 1, k});
  }
  steps.push_back({n, n});
  Input input;
  const auto patch = [&](const std::vector<Point>& rest, const char* material) {
    InputPolygon polygon;
    polygon.rings = {steps};
    polygon.rings[0].insert(polygon.rings[0].end(), rest.begin(), rest.end());
    polygon.material = material;
    input.polygons.push_back(polygon);
  };
  patch({{n, wall}, {-6, wall}, {-6, 0}}, "grain");
  patch({{wall, n}, {wall, -6}, {0, -6}}, "matrix");
  return input;
}

TEST(CutAndImprove, HalvesLongSegmentsBesideShortOnes) {
  const Output output = mesh_of(stairs());
  EXPECT_EQ(output.report.quality.obtuse, 0u);
  EXPECT_LT(output.mesh.tri().n_vertices(), 120u);
  std::size_t told = 0;
  for (const Note& note : output.report.notes) {
    const bool is_cut = note.kind == Note::Kind::cut;
    told += is_cut ? 1 : 0;
    if (is_cut) {
      EXPECT_EQ(note.where.size(), output.pslg.points.size() - output.report.input_points);
    }
  }
  EXPECT_EQ(told, 1u);  // once, however many rounds there were, for all that is left
}

TEST(CutAndImprove, LeavesNoObtuseTriangleInAChecker) {
  const Output output = mesh_of(testing::checker(4, 5, 1));
  EXPECT_LE(output.report.quality.largest_nu.supplement().in_degrees(), 90 + 1e-6);
}

TEST(CutAndImprove, DependsOnNeitherThreadsNorTheUnit) {
  for (const Input& input : {layers(), stairs()}) expect_same_for_threads_and_unit(input);
}

TEST(CutAndImprove, DoesNothingUnasked) {
  Options options = no_obtuse_angle();
  options.split_interfaces.reset();
  const Output output = mesh_of(layers(), options);
  EXPECT_GT(output.report.quality.obtuse, 0u);
}

}  // namespace
}  // namespace cover
