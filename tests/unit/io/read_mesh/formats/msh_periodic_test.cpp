// $Periodic as rules between named curves; what is not as cover or gmsh writes it is left.
#include "io/read_mesh/formats/msh_periodic.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <fmt/core.h>

namespace cover {
namespace {

/// A square whose right side, curve 2, is the image of its left one, curve 1.
std::string square(const std::string& periodic, const char* image = "2 1 2 6 2 20 30") {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
         "$PhysicalNames\n2\n1 5 \"left\"\n1 6 \"right\"\n$EndPhysicalNames\n"
         "$Nodes\n4\n10 0 0 0\n20 3 0 0\n30 3 3 0\n40 0 3 0\n$EndNodes\n"
         "$Elements\n4\n1 1 2 5 1 40 10\n" +
         std::string(image) +
         "\n3 2 2 1 1 10 20 30\n4 2 2 1 1 10 30 40\n$EndElements\n$Periodic\n" + periodic +
         "$EndPeriodic\n";
}

std::vector<PeriodicNodes> read(const std::string& text) {
  const Result<MshFile> file = parse_msh_file(text, "square.msh");
  EXPECT_TRUE(file);
  return file ? periodic_of_msh(text, *file) : std::vector<PeriodicNodes>();
}

std::string link(const char* affine, const char* nodes = "2\n20 10\n30 40\n") {
  return fmt::format("1\n1 2 1\nAffine {}\n{}", affine, nodes);
}

constexpr const char* kShift = "1 0 0 3 0 1 0 0 0 0 1 0 0 0 0 1";

TEST(MshPeriodic, TranslationOfNamedCurves) {
  const std::vector<PeriodicNodes> all = read(square(link(kShift)));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].rule, (PeriodicRule{"left", "right", PeriodicRule::Map::translation, {}, {}}));
  EXPECT_EQ(all[0].map.x0[0], 3);
  using Pairs = decltype(PeriodicNodes::vertices);
  EXPECT_EQ(all[0].vertices, (Pairs{{0, 1}, {3, 2}}));
  using Edges = decltype(PeriodicNodes::edges);
  EXPECT_EQ(all[0].edges, (Edges{{3, 0, 2, 1}}));
}

TEST(MshPeriodic, TurnsByRoundingAreTranslations) {
  const auto all = read(square(link("1 -1e-300 0 3 1e-300 1 0 0 0 0 1 0 0 0 0 1")));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].rule.map, PeriodicRule::Map::translation);
  EXPECT_EQ(all[0].map.yx[0], 0);
}

TEST(MshPeriodic, ALinkThatStandsThereTwiceIsOne) {
  const std::string once = link(kShift).substr(2);
  const auto all = read(square("2\n" + once + once));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].edges.size(), 1u);
  EXPECT_EQ(all[0].vertices.size(), 2u);
}

TEST(MshPeriodic, RotationsHaveACentreAndMirrorsHaveNone) {
  // The bottom as a quarter turn of the left side about the middle.
  const auto turned = read(
      square(link("0 -1 0 3 1 0 0 0 0 0 1 0 0 0 0 1", "2\n20 10\n10 40\n"), "2 1 2 6 2 10 20"));
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_EQ(turned[0].rule.map, PeriodicRule::Map::rotation);
  EXPECT_EQ(turned[0].rule.centre, (Point{1.5, 1.5}));
  EXPECT_DOUBLE_EQ(turned[0].rule.angle.in_degrees(), 90);
  // The same side by a mirror that keeps the corner 10.
  const auto kept =
      read(square(link("0 1 0 0 1 0 0 0 0 0 1 0 0 0 0 1", "1\n20 40\n"), "2 1 2 6 2 10 20"));
  ASSERT_EQ(kept.size(), 1u);
  using Pairs = decltype(PeriodicNodes::vertices);
  EXPECT_EQ(kept[0].vertices, (Pairs{{0, 0}, {3, 1}}));
  const auto mirrored = read(square(link("-1 0 0 3 0 1 0 0 0 0 1 0 0 0 0 1")));
  ASSERT_EQ(mirrored.size(), 1u);
  EXPECT_EQ(mirrored[0].rule.map, PeriodicRule::Map::mirror);
  // With a shift along the axis: the left side, upside down, on the right one.
  const auto glided = read(square(link("1 0 0 3 0 -1 0 3 0 0 1 0 0 0 0 1", "2\n20 40\n30 10\n")));
  ASSERT_EQ(glided.size(), 1u);
  EXPECT_EQ(glided[0].rule.map, PeriodicRule::Map::glide);
}

TEST(MshPeriodic, WhatIsNotUnderstoodIsLeftAsAWhole) {
  const std::string good = link(kShift);
  for (const std::string& periodic :
       {std::string("1\n1 2 1\n2\n20 10\n30 40\n"),           // without a map
        link(kShift, "2\n20 10\n30 50\n"),                    // no such node
        link(kShift, "1\n20 10\n"),                           // a node too few
        link(kShift, "2\n20 40\n30 20\n"),                    // no line
        link("1 0 0 3", "2\n20 10\n30 40\n"),                 // a map too short
        std::string("1\n2 1 1\nAffine ") + kShift + "\n0\n",  // of a surface
        std::string("1\n1 7 1\nAffine ") + kShift + "\n0\n",  // no such curve
        link("1 1 0 3 0 1 0 0 0 0 1 0 0 0 0 1"),              // a shear
        link("2 0 0 3 0 2 0 0 0 0 1 0 0 0 0 1"),              // a scale
        link("0 0 0 0 0 0 0 0 0 0 1 0 0 0 0 1"),              // all to one place
        link("1 0 0 7 0 1 0 0 0 0 1 0 0 0 0 1"),              // another shift
        link("1 0 0 1e308 0 1 0 1e308 0 0 1 0 0 0 0 1"),      // one that overflows
        link(kShift, "2\n20 40\n30 10\n"),                    // ends changed round
        link(kShift, "3\n20 10\n30 40\n10 30\n"),             // a pair beside the lines
        link(kShift, "3\n20 10\n30 40\n20 40\n"),             // a node of two originals
        std::string("1\n1 1 1\nAffine 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n0\n"),  // a line to itself
        std::string("9999\n"), std::string("x\n")}) {
    SCOPED_TRACE(periodic);
    EXPECT_TRUE(read(square(periodic)).empty());
  }
  EXPECT_EQ(read(square(good)).size(), 1u);
}

}  // namespace
}  // namespace cover
