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

/// A square of two regions beside a line from (low, 0) to (high, 1), cut at its points of height.
Output two_regions(double low, double high, const std::vector<double>& heights,
                   const PlaneField& field) {
  Input input;
  input.points = {{0, 0}, {low, 0}, {1, 0}, {1, 1}, {high, 1}, {0, 1}};
  const auto segment = [&](std::uint32_t a, std::uint32_t b) {
    InputSegment made;
    made.a = a;
    made.b = b;
    input.segments.push_back(made);
  };
  for (std::uint32_t k = 0; k < 6; ++k) segment(k, (k + 1) % 6);
  std::uint32_t before = 1;
  for (const double y : heights) {
    input.points.push_back({low + (high - low) * y, y});
    segment(before, static_cast<std::uint32_t>(input.points.size() - 1));
    before = static_cast<std::uint32_t>(input.points.size() - 1);
  }
  segment(before, 4);
  input.field = std::make_shared<const PlaneField>(field);
  Result<Output> output = cover_mesh(input);
  EXPECT_TRUE(output) << output.error().message;
  return *std::move(output);
}

TEST(CarryField, RegionsKeepTheirOwnValuesWhereTheyMeet) {
  constexpr double kLow = 0.3, kHigh = 0.7;
  // Points in the line's middle are beside it by rounding.
  const std::vector<double> heights{0.1, 0.2, 0.3, 0.45, 0.6, 0.7, 0.9};
  PlaneField field;
  field.points = {{0, 0}, {kLow, 0}, {kHigh, 1}, {0, 1}, {kLow, 0}, {1, 0}, {1, 1}, {kHigh, 1}};
  field.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  field.arrays = {{"both", {1, 2, 2, 1, -8, -8, -8, -8}},
                  {"one", {0, 0, 0, 0, 5, 5, 5, 5}},
                  {"none", {1, 1, 1, 1, kNone, kNone, kNone, kNone}},
                  {"same", {0, kLow, kHigh, 0, kLow, 1, 1, kHigh}}};
  const Output output = two_regions(kLow, kHigh, heights, field);
  ASSERT_EQ(output.table.regions.size(), 2U);
  const bool first_is_left = output.table.regions[0].inside->x < output.table.regions[1].inside->x;
  const RegionId left(first_is_left ? 1 : 2), right(first_is_left ? 2 : 1);
  const auto seen = [&](std::size_t k, std::uint32_t v, RegionId region) {
    return value_in(output.fields, output.region_values, k, v, region);
  };
  std::size_t on_border = 0;
  for (std::uint32_t v = 0; v < output.mesh.vertices(); ++v) {
    const Point p = at(output.mesh, v);
    if (std::abs(p.x - (kLow + (kHigh - kLow) * p.y)) > 1e-12) continue;
    ++on_border;
    EXPECT_NEAR(seen(0, v, left), 2, 1e-12);
    EXPECT_NEAR(seen(0, v, right), -8, 1e-12);
    EXPECT_NEAR(output.fields[0].values[v], -8, 1e-12);
    EXPECT_NEAR(seen(1, v, left), 0, 1e-12);
    EXPECT_NEAR(seen(1, v, right), 5, 1e-12);
    EXPECT_NEAR(seen(2, v, left), 1, 1e-12);
    EXPECT_TRUE(std::isnan(seen(2, v, right)));
    EXPECT_NEAR(output.fields[2].values[v], 1, 1e-12);
  }
  EXPECT_EQ(on_border, heights.size() + 2);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(output.region_values[k].size(), on_border) << output.fields[k].name;
  EXPECT_TRUE(output.region_values[3].empty());
  const auto& notes = output.report.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const Note& note) {
    return note.message.find("9 vertices have several values of both") != std::string::npos &&
           note.message.find("a .vtm keeps that of each region") != std::string::npos;
  }));
}

TEST(CarryField, FieldsWithoutArraysAreNone) {
  PlaneField field = linear();
  field.arrays.clear();
  EXPECT_TRUE(meshed(0, 1, field).fields.empty());
}

}  // namespace
}  // namespace cover
