#include "sizes/fields/carry_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/core.h>

#include <cover/cover_mesh.hpp>
#include <cover/mesh.hpp>

namespace cover {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A unit square in four triangles with the value 1 + x + 2 y.
PlaneField linear() {
  PlaneField field;
  field.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
  field.triangles = {{0, 1, 4}, {1, 2, 4}, {4, 2, 3}, {0, 4, 3}};
  field.arrays = {{"linear", {1, 2, 4, 3, 2.5}}, {"part", {1, 1, kNone, 1, 1}}};
  return field;
}

/// A square from `low` to `high` with so many points on its sides that it has vertices inside.
Output meshed(double low, double high, const PlaneField& field) {
  Input input;
  input.source = "square";
  constexpr std::uint32_t kEach = 8;
  const std::array<Point, 5> corners{
      {{low, low}, {high, low}, {high, high}, {low, high}, {low, low}}};
  for (std::size_t side = 0; side < 4; ++side) {
    const Point a = corners[side], b = corners[side + 1];
    for (std::uint32_t k = 0; k < kEach; ++k)
      input.points.push_back({a.x + (b.x - a.x) * k / kEach, a.y + (b.y - a.y) * k / kEach});
  }
  const auto n = static_cast<std::uint32_t>(input.points.size());
  for (std::uint32_t k = 0; k < n; ++k) {
    InputSegment segment;
    segment.a = k;
    segment.b = (k + 1) % n;
    input.segments.push_back(segment);
  }
  input.field = std::make_shared<const PlaneField>(field);
  Result<Output> output = cover_mesh(input);
  EXPECT_TRUE(output) << output.error().message;
  return *std::move(output);
}

Point at(const Mesh& mesh, std::size_t v) {
  const auto& p = mesh.tri().point(TriMesh::VertexHandle(static_cast<int>(v)));
  return {p[0], p[1]};
}

TEST(CarryField, IsLinearAtTheVerticesOfTheMesh) {
  const Output output = meshed(0, 1, linear());
  ASSERT_EQ(output.fields.size(), 2U);
  EXPECT_EQ(output.fields[0].name, "linear");
  ASSERT_EQ(output.fields[0].values.size(), output.mesh.vertices());
  ASSERT_GT(output.mesh.vertices(), 36U);
  std::size_t none = 0;
  for (std::size_t v = 0; v < output.mesh.vertices(); ++v) {
    const Point p = at(output.mesh, v);
    EXPECT_NEAR(output.fields[0].values[v], 1 + p.x + 2 * p.y, 1e-14);
    const double part = output.fields[1].values[v];
    none += std::isnan(part) ? 1 : 0;
    EXPECT_TRUE(std::isnan(part) || std::abs(part - 1) < 1e-15);
    // Triangles without the corner that has no value; on their edges they win over the others.
    if (p.x + p.y <= 1) {
      EXPECT_FALSE(std::isnan(part)) << p.x << ' ' << p.y;
    }
  }
  EXPECT_GT(none, 0U);
  for (const Note& note : output.report.notes)
    EXPECT_EQ(note.message.find("outside"), std::string::npos) << note.message;
}

TEST(CarryField, OutsideTheNearestValueCountsAndIsTold) {
  const Output output = meshed(-1, 2, linear());
  for (std::size_t v = 0; v < output.mesh.vertices(); ++v) {
    const Point p = at(output.mesh, v);
    EXPECT_NEAR(output.fields[0].values[v],
                1 + std::clamp(p.x, 0.0, 1.0) + 2 * std::clamp(p.y, 0.0, 1.0), 1e-14);
  }
  const auto& notes = output.report.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const Note& note) {
    return note.message.find("outside the triangles that have linear, part, first at (-1, -1)") !=
           std::string::npos;
  }));
}

TEST(CarryField, WhereAValueJumpsTheLargerMagnitudeCounts) {
  // Two materials beside x = 0.5, each with points of its own there.
  PlaneField field;
  field.points = {{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}, {0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}};
  field.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  field.arrays = {{"doping", {1, 1, 1, 1, -8, -8, -8, -8}}};
  const Output output = meshed(0, 1, field);
  std::size_t on_border = 0;
  for (std::size_t v = 0; v < output.mesh.vertices(); ++v) {
    const Point p = at(output.mesh, v);
    EXPECT_NEAR(output.fields[0].values[v], p.x < 0.5 ? 1 : -8, 1e-14);
    if (p.x == 0.5) ++on_border;
  }
  ASSERT_GT(on_border, 1U);
  const auto told = [](const Output& made) {
    std::string all;
    for (const Note& note : made.report.notes) all += note.message + "\n";
    return all;
  };
  EXPECT_NE(told(output).find(
                fmt::format("{} vertices have several values of doping, first at (0.5", on_border)),
            std::string::npos)
      << told(output);
  // Beside what is not doped there is one value.
  std::fill(field.arrays[0].values.begin(), field.arrays[0].values.begin() + 4, 0);
  EXPECT_EQ(told(meshed(0, 1, field)).find("several values"), std::string::npos);
}

TEST(CarryField, FieldsWithoutArraysAreNone) {
  PlaneField field = linear();
  field.arrays.clear();
  EXPECT_TRUE(meshed(0, 1, field).fields.empty());
}

}  // namespace
}  // namespace cover
