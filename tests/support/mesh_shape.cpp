#include "support/mesh_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cover::testing {

Output must_mesh(const Input& input, const Options& options) {
  Result<Output> output = cover_mesh(input, options);
  EXPECT_TRUE(output) << output.error().message;
  return std::move(output).value();
}

std::string violations(const Output& output, const VerifyOptions& options) {
  std::string text;
  const TriangleSoup soup = triangle_soup(output.mesh);
  for (const Violation& v : verify_cover(output.pslg, output.table, soup, options).violations) {
    text += v.message + '\n';
  }
  return text;
}

Shape shape_of(const TriangleSoup& soup, double factor, Point shift) {
  Shape shape;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    std::array<Point, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point q = soup.points[soup.triangles[t][i]];
      p[i] = {(q.x - shift.x) / factor, (q.y - shift.y) / factor};
    }
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    shape.insert({p, soup.material[t]});
  }
  return shape;
}

TriangleSoup part_of(const TriangleSoup& soup, RegionId region) {
  TriangleSoup part = soup;
  part.triangles.clear();
  part.region.clear();
  part.material.clear();
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (soup.region[t] != region.value()) continue;
    part.triangles.push_back(soup.triangles[t]);
    part.region.push_back(soup.region[t]);
    part.material.push_back(soup.material[t]);
  }
  return part;
}

Input region_alone(const Output& output, RegionId region) {
  Input alone;
  alone.void_rule = VoidRule::unseeded_faces;
  alone.points = output.pslg.points;  // those of other regions come to lie in the void
  for (std::size_t s = 0; s < output.pslg.segments.size(); ++s) {
    const SegmentSides& sides = output.table.sides[s];
    if (sides.left != region && sides.right != region) continue;
    InputSegment segment;
    segment.a = output.pslg.segments[s].a.value();
    segment.b = output.pslg.segments[s].b.value();
    alone.segments.push_back(segment);
  }
  RegionSeed seed;
  seed.at = output.table.region(region).inside.value();
  seed.material = std::to_string(output.table.region(region).material);
  alone.seeds.push_back(seed);
  return alone;
}

}  // namespace cover::testing
