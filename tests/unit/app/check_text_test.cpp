// Sentences of a check.
#include "words/check_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cover::app {
namespace {

TEST(CheckText, PlacesFollowTheirViolation) {
  Verification found;
  EXPECT_EQ(violations_text(found), "");
  found.violations = {{1, "no vertex", {{0.5, 1}}}, {4, "wrong", {}}};
  found.violation_count = 1002;
  EXPECT_EQ(violations_text(found),
            "FAILED promise 1: no vertex\n    at (0.5, 1)\n"
            "FAILED promise 4 (materials): wrong\n... and 1,000 more\n");
}

TEST(CheckText, ASoundMesh) {
  Verification found;
  found.regions = 1;
  found.segments_whole = 4;
  EXPECT_EQ(sound_text(found, 1234, true),
            "Every promise holds: 1,234 triangles, 1 region, 4 segments whole\n");
  EXPECT_EQ(sound_text(found, 1, true),
            "Every promise holds: 1 triangle, 1 region, 4 segments whole\n");
  found.regions = 2;
  found.within_rounding = 1;
  found.unchecked = {"materials"};
  EXPECT_EQ(sound_text(found, 2, true),
            "All that was checked holds: 2 triangles, 2 regions, 4 segments whole; 1 of the "
            "regions meet the bound up to the rounding of coordinates\nNot checked: materials\n");
  EXPECT_EQ(sound_text(found, 2, false).substr(0, 46),
            "All else that was checked holds: 2 triangles, ");
}

TEST(CheckText, CutsTellWhoMadeThemOrHowToAllowThem) {
  const auto begins_with = [](const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
  };
  EXPECT_EQ(cuts_text({1, false, true, "--box-method cut", true}, false),
            "Segments are cut at 1 point by the run itself: --box-method cut\n");
  EXPECT_EQ(cuts_text({7, true, true, "", true}, false),
            "Segments are cut at 7 points, those of arcs on their circles\n");
  EXPECT_TRUE(begins_with(cuts_text({7, false, false, "", true}, false),
                          "Segments have vertices inside; all else is sound. If sides were"));
  EXPECT_TRUE(begins_with(cuts_text({7, false, false, "", true}, true),
                          "Segments have vertices inside; all else is sound. If segments were to"));
  EXPECT_TRUE(begins_with(
      cuts_text({7, true, false, "", false}, false),
      "Segments are cut at 7 points, those of arcs on their circles; all else but materials is"));
}

TEST(CheckText, NothingMissingIsNotWorthAWord) {
  EXPECT_EQ(missing_text(0, {}, {}), "");
  EXPECT_EQ(in_void_text(0), "");
  EXPECT_EQ(other_ids_text(0), "");
  EXPECT_EQ(in_void_text(1).find("1 triangle lies along "), 0u);
  EXPECT_EQ(in_void_text(2).find("2 triangles lie along "), 0u);
  EXPECT_EQ(other_ids_text(1).find("1 triangle has another RegionId "), 0u);
  EXPECT_EQ(other_ids_text(2000).find("2,000 triangles have another RegionId "), 0u);
}

TEST(CheckText, MissingPointsNameOptions) {
  const std::vector<std::string> possible{"--weld", "--speckle", "--no-smooth"};
  EXPECT_EQ(missing_text(2, {}, possible),
            "2 points of the input missing in the mesh. If the run that made it moved them, or "
            "read other ones, repeat its --weld, --speckle or --no-smooth here\n");
  const std::vector<std::string> of_run{"--speckle 9", "--no-smooth"};
  EXPECT_EQ(missing_text(1, of_run, possible),
            "1 point of the input missing in the mesh. The run that made it had other options: "
            "repeat --speckle 9 --no-smooth here\n");
}

TEST(CheckText, TargetsAreThoseOfTheRun) {
  Verification found;
  found.limits.resize(1);
  found.limits[0].of_largest = found.limits[0].of_smallest = Standing::open;
  EXPECT_NE(sound_text(found, 1, true).find("beside targets of 100 and 20 degrees, and beside"),
            std::string::npos);
  const auto text_of = [&](bool is_largest, bool is_smallest) {
    return sound_text(found, 1, true,
                      {Angle::degrees(90), Angle::degrees(20), is_largest, is_smallest});
  };
  EXPECT_NE(text_of(true, true)
                .find("targets of 90 and 20 degrees, those of the run that made it, and beside"),
            std::string::npos);
  EXPECT_NE(text_of(true, false).find("20 degrees, the first that of the run that made it, and"),
            std::string::npos);
  EXPECT_NE(text_of(false, true).find("20 degrees, the second that of the run that made it, and"),
            std::string::npos);
}

TEST(CheckText, OfManyCouplingsTheFirstAreListed) {
  Verification found;
  EXPECT_EQ(couplings_text(found), "Box method: no negative coupling; 0 obtuse triangles\n");
  found.negative_couplings.resize(21);
  const std::string text = couplings_text(found);
  EXPECT_EQ(text.find("FAILED box method: 21 negative couplings: "), 0u);
  EXPECT_NE(text.find("\n    ... and 1 more\n"), std::string::npos);
}

TEST(CheckText, SidesOfPairs) {
  PeriodicRule rule;
  rule.from = "left";
  rule.to = "right";
  EXPECT_EQ(periodic_text(rule, std::size_t{3}),
            "Periodic: 3 pairs of vertices on 'left' and 'right', none without a partner\n");
  EXPECT_EQ(periodic_text(rule, Error{ErrorCode::bad_option, "no partner", {{1, 2}}, {}}),
            "FAILED no partner\n    at (1, 2)\n");
}

TEST(CheckText, Rows) {
  LayersFound layers;
  layers.edges = 1;
  EXPECT_EQ(layers_text(layers, "gate", "oxide", false),
            "FAILED Layers along 'gate' in 'oxide': none over 1 edge\n");
  layers.edges = 1016;
  EXPECT_EQ(layers_text(layers, "gate", "oxide", true),
            "Layers along 'gate' in 'oxide': none over 1,016 edges\n");
  layers.layered = 1;
  EXPECT_EQ(layers_text(layers, "gate", "oxide", true).find("Layers along 'gate' in 'oxide': 0 to"),
            0u);
}

TEST(CheckText, SecondOrder) {
  CurvedVerification found;
  found.on_arcs = 2;
  EXPECT_EQ(curved_violations_text(found), "");
  EXPECT_EQ(curved_sound_text(found),
            "Second order: every Jacobian is positive everywhere; 2 edges lie on arcs\n");
  found.violations = {{2, "folded", {{0, 0}}}};
  found.violation_count = 1;
  EXPECT_EQ(curved_violations_text(found), "FAILED second order: folded\n    at (0, 0)\n");
}

}  // namespace
}  // namespace cover::app
