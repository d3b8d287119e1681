#include <cover/read_dxf.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "support/cases_folder.hpp"
#include "support/inputs/dxf_writer.hpp"
#include "support/inputs/soups.hpp"
#include "support/read_result.hpp"

namespace cover {
namespace {

using testing::DxfWriter;

Input read(const std::string& text, const ReadOptions& options = {}) {
  return testing::must_read(parse_dxf(text, "a.dxf", options));
}

std::string message(const std::string& text, const ReadOptions& options = {}) {
  return testing::must_refuse(parse_dxf(text, "a.dxf", options));
}

/// The area of all regions.
double area_of(const Input& input) {
  const auto out = testing::clean(input);
  EXPECT_TRUE(out) << out.error().message;
  double area = 0;
  if (out)
    for (const Region& region : out->table.regions) area += region.area;
  return area;
}

double area_of(DxfWriter& drawing, double chord_angle = 5) {
  ReadOptions options;
  options.chord_angle = chord_angle;
  return area_of(read(drawing.finish(), options));
}

/// Of the disk of radius 1, cut into n chords.
double polygon_area(int n) { return n / 2.0 * std::sin(2 * M_PI / n); }

TEST(ReadDxf, LinesMeetWhereTheyAreTheSame) {
  DxfWriter d;
  d.begin_entities().line("0", 0, 0, 0.1, 0).line("0", 0.1, 0, 0.1, 0.2).line("0", 0.1, 0.2, 0, 0);
  const Input input = read(d.finish());
  EXPECT_EQ(input.points.size(), 3U);
  EXPECT_EQ(input.segments.size(), 3U);
  EXPECT_EQ(input.segments[2].id, 2);
  EXPECT_TRUE(input.segments[0].name.empty());
  EXPECT_DOUBLE_EQ(area_of(input), 0.01);
}

TEST(ReadDxf, TheMarkOfUtf8IsPassed) {
  DxfWriter d;
  d.begin_entities().line("0", 0, 0, 0.1, 0).line("0", 0.1, 0, 0.1, 0.2).line("0", 0.1, 0.2, 0, 0);
  EXPECT_EQ(read("\xef\xbb\xbf" + d.finish()).segments.size(), 3U);
}

TEST(ReadDxf, EndsOfLinesThatAreTakenForOthersAreTold) {
  for (const double away : {1e-13, 0x1p-54}) {
    DxfWriter d;
    d.begin_entities().line("0", 0, 0, 0.1, 0).line("0", 0.1, 0, 0.1, 0.2);
    d.line("0", 0.1, 0.2 + away, 0, 0);
    const Input input = read(d.finish());
    EXPECT_EQ(input.points.size(), 3U);
    ASSERT_EQ(input.changes.size(), 1U) << away;
    Options strict;
    strict.strict = true;
    const auto refused = testing::clean(input, strict);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::changed_input);
    const auto cleaned = testing::clean(input);
    ASSERT_TRUE(cleaned) << cleaned.error().message;
    EXPECT_EQ(cleaned->report.changes.size(), 1U);
    if (away < 1e-13) continue;
    EXPECT_EQ(input.changes[0].message,
              "an end of curve 2 at (0.1, 0.20000000000010001) was moved by 1e-13 onto the end of "
              "another at (0.1, 0.2)");
  }
}

TEST(ReadDxf, CirclesAndArcsShareTheirPoints) {
  DxfWriter d;
  // A sector of 60 degrees of the circle, by the doubles that a program computes.
  const double x = std::cos(M_PI / 3), y = std::sin(M_PI / 3);
  d.begin_entities().circle("0", 0, 0, 1).line("0", 0, 0, 1, 0).line("0", 0, 0, x, y);
  d.entity("ARC", "0", {{10, 0}, {20, 0}, {40, 1}, {50, 0}, {51, 60}});
  const auto out = testing::clean(read(d.finish()));
  ASSERT_TRUE(out) << out.error().message;
  ASSERT_EQ(out->table.regions.size(), 2U);
  EXPECT_EQ(out->pslg.segments.size(), 72U + 2);
  EXPECT_NEAR(out->table.regions[0].area + out->table.regions[1].area, polygon_area(72), 1e-12);
}

TEST(ReadDxf, EndsThatMissByRoundingAreTheSame) {
  // Six arcs, end to end, about centres that are off by a few units in the last place.
  DxfWriter d;
  d.begin_entities();
  std::vector<Point> corners;
  for (int k = 0; k < 6; ++k)
    corners.push_back({100 + std::cos(k * M_PI / 3) * (1 + 1e-13), std::sin(k * M_PI / 3)});
  for (int k = 0; k < 6; ++k) {
    d.entity(
        "ARC", "0",
        {{10, 100 + k * 2e-14}, {20, -k * 1e-16}, {40, 1}, {50, 60.0 * k}, {51, 60.0 * k + 60}});
    d.line("0", 100, 0, corners[static_cast<std::size_t>(k)].x,
           corners[static_cast<std::size_t>(k)].y);
  }
  const Input input = read(d.finish());
  EXPECT_EQ(input.points.size(), 73U);
  const auto out = testing::clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 6U);
  EXPECT_TRUE(out->report.changes.empty());
}

TEST(ReadDxf, AnArcOverZeroDegreesGoesOn) {
  DxfWriter d;
  d.begin_entities().entity("ARC", "0", {{10, 0}, {20, 0}, {40, 1}, {50, 270}, {51, 90}});
  d.line("0", 0, 1, 0, -1);
  EXPECT_NEAR(area_of(d), polygon_area(72) / 2, 1e-12);
}

TEST(ReadDxf, AnArcOf360DegreesIsACircle) {
  for (const double from : {1.2, 1.3, 0.7, 359.9}) {
    DxfWriter d;
    d.begin_entities();
    d.entity("ARC", "0",
             {{10, 0}, {20, 0}, {40, 1}, {50, from}, {51, std::round(from * 10 + 3600) / 10}});
    const Input input = read(d.finish());
    EXPECT_EQ(input.points.size(), 72U) << from;
    EXPECT_EQ(input.segments.size(), 72U) << from;
  }
}

TEST(ReadDxf, BulgesAreArcs) {
  // Two half circles; the second one is drawn clockwise into the square.
  DxfWriter d;
  d.begin_entities().entity(
      "LWPOLYLINE", "0", {{90, 2}, {70, 1}, {10, -1}, {20, 0}, {42, 1}, {10, 1}, {20, 0}, {42, 1}});
  EXPECT_NEAR(area_of(d), polygon_area(72), 1e-12);
  DxfWriter bitten;
  bitten.begin_entities().entity("LWPOLYLINE", "0",
                                 {{90, 4},
                                  {70, 1},
                                  {10, 0},
                                  {20, 0},
                                  {42, -1},
                                  {10, 2},
                                  {20, 0},
                                  {10, 2},
                                  {20, 2},
                                  {10, 0},
                                  {20, 2}});
  EXPECT_NEAR(area_of(bitten), 4 - polygon_area(72) / 2, 1e-12);
  DxfWriter old;
  old.begin_entities().entity("POLYLINE", "0", {{66, 1}, {70, 1}});
  old.entity("VERTEX", "0", {{10, -1}, {20, 0}, {42, 1}})
      .entity("VERTEX", "0", {{10, 1}, {20, 0}, {42, 1}});
  old.group(0, "SEQEND");
  EXPECT_NEAR(area_of(old), polygon_area(72), 1e-12);
}

TEST(ReadDxf, ChordsKeepToAngleAndError) {
  DxfWriter d;
  d.begin_entities().circle("0", 5, 5, 1);
  EXPECT_NEAR(area_of(d, 10), polygon_area(36), 1e-12);
  ReadOptions options;
  options.chord_error = 1e-4;
  const Input input = read(d.finish(), options);
  for (const InputSegment& s : input.segments) {
    const Point a = input.points[s.a], b = input.points[s.b];
    EXPECT_LE(1 - std::hypot((a.x + b.x) / 2 - 5, (a.y + b.y) / 2 - 5), 1.0001e-4);
  }
  EXPECT_LT(input.segments.size(), 260U);
}

TEST(ReadDxf, EllipsesAndSplines) {
  DxfWriter whole;
  whole.begin_entities().entity(
      "ELLIPSE", "0",
      {{10, 1}, {20, 1}, {11, 0}, {21, 2}, {40, 0.5}, {41, 0}, {42, 6.283185307179586}});
  EXPECT_NEAR(area_of(whole), 2 * polygon_area(72), 1e-12);
  DxfWriter half;
  half.begin_entities().entity(
      "ELLIPSE", "0",
      {{10, 0}, {20, 0}, {11, 2}, {21, 0}, {40, 0.5}, {41, 0}, {42, 3.141592653589793}});
  half.line("0", -2, 0, 2, 0);
  EXPECT_NEAR(area_of(half), polygon_area(72), 1e-9);
  DxfWriter spline;
  spline.begin_entities().entity("SPLINE", "0",
                                 {{70, 8},
                                  {71, 2},
                                  {72, 6},
                                  {73, 3},
                                  {74, 0},
                                  {40, 0},
                                  {40, 0},
                                  {40, 0},
                                  {40, 1},
                                  {40, 1},
                                  {40, 1},
                                  {10, 0},
                                  {20, 0},
                                  {10, 1},
                                  {20, 2},
                                  {10, 2},
                                  {20, 0}});
  spline.line("0", 2, 0, 0, 0);
  EXPECT_NEAR(area_of(spline, 0.5), 4.0 / 3, 1e-4);  // a parabola of height 1 over 2
}

TEST(ReadDxf, CopiesOnTheSamePlaceAreDrawnOnce) {
  DxfWriter d;
  d.begin_blocks().begin_block("bar", 0, 0).line("0", 0, 0, 1, 0).end_block().end_section();
  d.begin_entities().insert("bar", "iron", {{10, 0}, {20, 0}, {71, 30000}});
  d.insert("bar", "iron", {{10, 0}, {20, 1}, {70, 30000}, {71, 2}, {45, 3}});
  const Input input = read(d.finish());
  EXPECT_EQ(input.segments.size(), 3);
}

TEST(ReadDxf, BlocksAreMovedTurnedScaledAndMirrored) {
  DxfWriter d;
  d.begin_blocks().begin_block("tooth", 1, 0);
  d.entity("ARC", "0", {{10, 1}, {20, 0}, {40, 1}, {50, 0}, {51, 90}})
      .line("side", 1, 0, 2, 0)
      .line("0", 1, 0, 1, 1);
  d.end_block().begin_block("two").insert("tooth", "0", {{10, 0}, {20, 0}});
  d.insert("tooth", "far", {{10, 0}, {20, 0}, {41, 1}, {42, 1}, {50, 180}})
      .end_block()
      .end_section();
  d.begin_entities().insert("two", "iron", {{10, 10}, {20, 0}, {41, 2}, {42, 2}, {50, 90}});
  d.insert("tooth", "mirror", {{10, 20}, {20, 0}, {41, -1}, {42, 1}});
  d.insert("tooth", "oval", {{10, 30}, {20, 0}, {41, 2}, {42, 1}, {70, 2}, {71, 1}, {44, 5}});
  const Input input = read(d.finish());
  const double quarter = polygon_area(72) / 4;
  EXPECT_NEAR(area_of(input), quarter * (4 + 4 + 1 + 2 + 2), 1e-9);
  std::set<std::string> names;
  for (const InputSegment& s : input.segments) names.insert(s.name);
  EXPECT_EQ(names, (std::set<std::string>{"iron", "far", "mirror", "oval", "side"}));
  // Turned by quarters, corners are exact; mirrored, the arc bulges to the left.
  std::set<Point> points(input.points.begin(), input.points.end());
  for (const Point p : {Point{10, 2}, Point{8, 0}, Point{10, -2}, Point{12, 0}, Point{19, 0},
                        Point{20, 1}, Point{37, 0}})
    EXPECT_EQ(points.count(p), 1U) << p.x << ' ' << p.y;
}

TEST(ReadDxf, ChordsKnowTheirCircles) {
  DxfWriter d;
  d.begin_blocks().begin_block("b");
  d.entity("ARC", "0", {{10, 0}, {20, 0}, {40, 1}, {50, 0}, {51, 90}});
  // A quarter of the circle of radius 1 about (6, 0), by its bulge.
  d.entity("LWPOLYLINE", "0",
           {{90, 2}, {70, 0}, {10, 7}, {20, 0}, {42, std::tan(M_PI / 8)}, {10, 6}, {20, 1}});
  d.end_block().end_section();
  d.begin_entities().line("0", 0, 0, 1, 0);
  d.insert("b", "0", {{10, 0}, {20, 0}});
  d.insert("b", "0", {{10, 20}, {20, 5}, {41, -3}, {42, 3}, {50, 30}});
  d.insert("b", "0", {{10, 50}, {20, 0}, {41, 2}, {42, 1}});  // ellipses
  const Input input = read(d.finish());
  ASSERT_EQ(input.circles.size(), 4U);
  EXPECT_EQ(input.circles[0], (ArcCircle{{0, 0}, 1}));
  EXPECT_NEAR(input.circles[1].centre.x, 6, 1e-12);
  EXPECT_NEAR(input.circles[2].radius, 3, 1e-12);
  EXPECT_NEAR(input.circles[3].radius, 3, 1e-12);
  std::vector<int> chords(5);
  for (const InputSegment& s : input.segments) {
    ASSERT_LT(s.circle, chords.size());
    ++chords[s.circle];
    if (s.circle == 0) continue;
    const ArcCircle& circle = input.circles[s.circle - 1];
    for (const Point p : {input.points[s.a], input.points[s.b]})
      EXPECT_NEAR(std::hypot(p.x - circle.centre.x, p.y - circle.centre.y), circle.radius, 1e-12);
  }
  EXPECT_EQ(chords, (std::vector<int>{1 + 2 * 18, 18, 18, 18, 18}));
}

TEST(ReadDxf, FromBehindXIsNegated) {
  DxfWriter d;
  d.begin_entities().entity(
      "ARC", "0", {{10, 3}, {20, 0}, {40, 1}, {50, 0}, {51, 90}, {210, 0}, {220, 0}, {230, -1}});
  d.line("0", -4, 0, -3, 1);
  const Input input = read(d.finish());
  std::set<Point> points(input.points.begin(), input.points.end());
  EXPECT_EQ(points.count({-4, 0}) + points.count({-3, 1}), 2U);
  EXPECT_NEAR(area_of(input), polygon_area(72) / 4 - 0.5, 1e-12);
  DxfWriter tilted;
  tilted.begin_entities().circle("0", 0, 0, 1);
  tilted.entity("CIRCLE", "0", {{10, 0}, {20, 0}, {40, 9}, {210, 1}, {220, 0}, {230, 0}});
  EXPECT_NEAR(area_of(tilted), polygon_area(72), 1e-12);
}

TEST(ReadDxf, LayersNameSegmentsAndAreChosen) {
  DxfWriter d;
  d.begin_entities().circle("rotor", 0, 0, 1).circle("stator", 0, 0, 2).circle("0", 0, 0, 3);
  std::map<std::string, int> names;
  for (const InputSegment& s : read(d.finish()).segments) ++names[s.name];
  EXPECT_EQ(names, (std::map<std::string, int>{{"", 72}, {"rotor", 72}, {"stator", 72}}));
  ReadOptions options;
  options.layers = {"stator"};
  const Input input = read(d.finish(), options);
  EXPECT_EQ(input.segments.size(), 72U);
  EXPECT_TRUE(input.segments[0].name.empty());  // as all are there
  options.is_one_of_several = true;
  EXPECT_EQ(read(d.finish(), options).segments[0].name, "stator");
  options.is_one_of_several = false;
  EXPECT_TRUE(input.warnings.empty());
  options.layers = {"stator", "coil"};
  EXPECT_EQ(read(d.finish(), options).warnings,
            (std::vector<std::string>{
                "no line or curve is on the layer 'coil'; its layers: 0, rotor, stator"}));
  options.layers = {"coil"};
  EXPECT_EQ(message(d.finish(), options),
            "a.dxf: no line or curve in it on the layers that are read; its layers: 0, rotor, "
            "stator");
}

TEST(ReadDxf, TextsOfTheLabelLayerNameRegions) {
  DxfWriter d;
  d.begin_entities()
      .circle("0", 0, 0, 1)
      .circle("0", 5, 0, 1)
      .circle("0", 10, 0, 1)
      .circle("0", 15, 0, 1);
  d.text("labels", 0, 0, "%%ucopper%%u/A+")
      .text("labels", 5, 0, "copper/A-")
      .text("notes", 100, 0, "Motor");
  d.entity("MTEXT", "labels", {{10, 10}, {20, 0}}).group(1, "{\\fArial|b0;vo%%oid}");
  ReadOptions options;
  options.label_layer = "labels";
  const auto out = testing::clean(read(d.finish(), options));
  ASSERT_TRUE(out) << out.error().message;
  ASSERT_EQ(out->table.regions.size(), 3U);
  std::set<std::string> names;
  for (const Region& region : out->table.regions)
    names.insert(region.material_name + ":" + region.name);
  EXPECT_EQ(names.count("copper:A+") + names.count("copper:A-"), 2U);
  EXPECT_EQ(read(d.finish()).warnings,
            std::vector<std::string>{"4 texts are left out; --label-layer makes names of regions "
                                     "of those on one layer"});
  options.label_layer = "Labels";
  EXPECT_EQ(read(d.finish(), options).seeds.size(), 2U);
  options.label_layer = "label";
  EXPECT_EQ(message(d.finish(), options),
            "a.dxf: label_layer: no text is on the layer 'label'; texts are on labels, notes");
  options.is_one_of_several = true;  // others may have it
  const Input part = read(d.finish(), options);
  ASSERT_EQ(part.asked.size(), 1U);
  EXPECT_FALSE(part.asked[0].is_there);
}

TEST(ReadDxf, ALabelInAnOpenOutlineIsToldWithWhatClosesIt) {
  DxfWriter d;
  d.begin_entities().circle("0", 20, 5, 3).line("0", 0, 0, 10, 0).line("0", 10, 0, 10, 10);
  d.line("0", 10, 10, 0, 10).line("0", 0, 10, 0, 5e-4);
  d.text("Text", 5, 5, "Erde/unten").text("Text", 20, 5, "void").text("Text", 5, 0, "void");
  ReadOptions options;
  options.label_layer = "text";
  Input input = read(d.finish(), options);
  const auto on_line = testing::clean(input);
  ASSERT_FALSE(on_line);
  EXPECT_EQ(on_line.error().message,
            "a.dxf: the text 'void' of layer Text at (5, 0) lies on a segment");
  input.holes.pop_back();
  const auto out = testing::clean(input);
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().message,
            "a.dxf: the text 'Erde/unten' of layer Text at (5, 5) lies outside of all segments, or "
            "what is around it is open; 2 ends of lines nearly meet another, the first at (0, 0), "
            "0.0005 away: --weld 3e-05 closes such gaps");
}

TEST(ReadDxf, FacesWithoutALabelAreTold) {
  DxfWriter d;
  d.begin_entities().circle("0", 0, 0, 2).circle("0", 5, 0, 1).circle("0", 10, 0, 1);
  d.circle("0", 0, 0, 1).text("labels", 0, 0, "copper").text("labels", 5, 0, "void");
  const std::string text = d.finish();
  EXPECT_FALSE(testing::clean(read(text))->tells("closed face"));
  ReadOptions options;
  options.label_layer = "labels";
  const auto out = testing::clean(read(text, options));
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 3U);
  EXPECT_TRUE(out->tells("2 closed faces have no label inside, the largest at ("));
  EXPECT_TRUE(out->tells(") with an area of 9.4128"));  // 3 times that of 72 chords
  EXPECT_TRUE(out->tells(": they are 'unnamed'"));
}

TEST(ReadDxf, TextsAreInTheCodePageOfTheDrawing) {
  DxfWriter d;
  d.group(0, "SECTION")
      .group(2, "HEADER")
      .group(9, "$DWGCODEPAGE")
      .group(3, "ANSI_1252")
      .end_section();
  d.begin_entities().circle("0", 0, 0, 1).text("labels", 0, 0, "L\xe4ufer/\\U+00DCbung");
  ReadOptions options;
  options.label_layer = "labels";
  const Input input = read(d.finish(), options);
  ASSERT_EQ(input.seeds.size(), 1U);
  EXPECT_EQ(input.seeds[0].material, "L\xc3\xa4ufer");
  EXPECT_EQ(input.seeds[0].region,
            "\xc3\x9c"
            "bung");
}

TEST(ReadDxf, UnitsAndWhatIsLeftOutAreTold) {
  DxfWriter d;
  d.group(0, "SECTION")
      .group(2, "HEADER")
      .group(9, "$INSUNITS")
      .group(70, 1)
      .group(9, "$X")
      .group(70, 4)
      .end_section();
  d.begin_entities()
      .circle("0", 0, 0, 1)
      .circle("0", 9, 0, -1)
      .entity("HATCH", "0", {{91, 1000000000}})
      .entity("SOLID", "0", {{10, 0}});
  const Input input = read(d.finish());
  ASSERT_EQ(input.warnings.size(), 3U);
  EXPECT_EQ(input.warnings[0], "entities that are not read: 1 HATCH, 1 SOLID");
  EXPECT_EQ(input.warnings[1], "1 circle or arc whose radius is not positive: left out");
  EXPECT_NE(input.warnings[2].find("inches"), std::string::npos);
  ReadOptions options;
  options.unit = "mm";
  options.scale = 25.4;
  EXPECT_NEAR(area_of(read(d.finish(), options)), 25.4 * 25.4 * polygon_area(72), 1e-9);
}

/// A square of 10 on layer Frame, and a table with one more layer that has these flags and colour.
DxfWriter frame_beside_layer(const std::string& name, int flags, int colour) {
  DxfWriter d;
  d.group(0, "SECTION").group(2, "TABLES").group(0, "TABLE").group(2, "LAYER").group(70, 2);
  d.group(0, "LAYER").group(2, "Frame").group(70, 0).group(62, 7);
  d.group(0, "LAYER").group(2, name).group(70, flags).group(62, colour);
  d.group(0, "ENDTAB").end_section();
  return d;
}

void add_frame(DxfWriter& d) {
  d.entity(
      "LWPOLYLINE", "Frame",
      {{90, 4}, {70, 1}, {10, 0}, {20, 0}, {10, 9}, {20, 0}, {10, 9}, {20, 9}, {10, 0}, {20, 9}});
}

TEST(ReadDxf, PointsAreNamedByTheirLayer) {
  DxfWriter d = frame_beside_layer("Off", 0, -7);
  d.begin_blocks().begin_block("B").entity("POINT", "wells", {{10, 1}, {20, 1}});
  d.entity("POINT", "0", {{10, 0}, {20, 1}}).end_block().end_section().begin_entities();
  add_frame(d);
  d.entity("POINT", "wells", {{10, 3}, {20, 4}}).entity("POINT", "0", {{10, 5}, {20, 5}});
  d.entity("POINT", "corner", {{10, 9}, {20, 9 + 1e-15}}).entity("POINT", "Off", {{10, 1}});
  d.insert("B", "inner", {{10, 5}, {20, 5}, {41, 2}});
  const std::string text = d.finish();
  const Input input = read(text);
  EXPECT_EQ(input.points.size(), 8U) << "four corners, three wells and inner";
  std::vector<std::pair<std::string, Point>> names;
  for (const PointName& name : input.point_names)
    names.emplace_back(name.name, input.points[name.point]);
  EXPECT_EQ(names,
            (std::vector<std::pair<std::string, Point>>{
                {"wells", {3, 4}}, {"corner", {9, 9}}, {"wells", {7, 6}}, {"inner", {5, 6}}}));
  EXPECT_TRUE(input.segments[0].name.empty()) << "points are no second layer of segments";
  EXPECT_EQ(input.warnings, std::vector<std::string>{"1 point is left out on hidden layers"});
  EXPECT_EQ(area_of(input), 81);

  ReadOptions options;
  options.layers = {"wells", "frame"};
  EXPECT_EQ(read(text, options).points.size(), 6U);
  options.layers = {"wells"};
  EXPECT_NE(message(text, options).find("no line or curve in it on the layers"), std::string::npos);
  options.is_one_of_several = true;
  EXPECT_EQ(read(text, options).points.size(), 2U);
}

TEST(ReadDxf, WidthsOfPolylinesAreTold) {
  DxfWriter d;
  d.begin_entities();
  add_frame(d);
  d.entity("LWPOLYLINE", "Top", {{90, 2}, {43, 2}, {10, 1}, {20, 1}, {10, 5}, {20, 1}});
  d.entity("LWPOLYLINE", "Top", {{90, 2}, {10, 1}, {20, 2}, {40, 0.5}, {41, 1}, {10, 5}, {20, 2}});
  d.entity("LWPOLYLINE", "Top", {{90, 2}, {43, 0}, {10, 1}, {20, 4}, {10, 5}, {20, 4}});
  d.entity("POLYLINE", "Old", {{66, 1}});
  d.entity("VERTEX", "Old", {{10, 1}, {20, 3}, {40, 0.25}, {41, 0.25}});
  d.entity("VERTEX", "Old", {{10, 2}, {20, 3}}).group(0, "SEQEND");
  d.circle("Frame", 7, 7, 1);
  EXPECT_EQ(read(d.finish()).warnings,
            std::vector<std::string>{"3 polylines have a width, 1 on 'Old', 2 on 'Top': what is "
                                     "read is the line in the middle"});
}

TEST(ReadDxf, LayersThatAreOffOrFrozenAreLeftOut) {
  struct Case {
    const char *layer, *why;
    int flags, colour;
  };
  for (const Case& c : {Case{"Aux", " (frozen)", 1, 7}, Case{"Aux", " (off)", 0, -7},
                        Case{"DEFPOINTS", " (never printed)", 0, 7}}) {
    DxfWriter d = frame_beside_layer(c.layer, c.flags, c.colour);
    d.begin_entities();
    add_frame(d);
    d.line(c.layer, 0, 0, 9, 9).circle(c.layer, 5, 5, 1);
    const std::string text = d.finish();
    const Input input = read(text);
    EXPECT_EQ(input.segments.size(), 4U) << c.layer;
    EXPECT_TRUE(input.segments[0].name.empty());  // as all that is read is on one layer
    EXPECT_EQ(input.warnings,
              std::vector<std::string>{std::string("2 lines and curves are left out on hidden "
                                                   "layers: ") +
                                       c.layer + c.why + "; --layer reads those it names"});
    ReadOptions options;
    options.layers = {"Frame", c.layer};
    const Input all = read(text, options);
    EXPECT_EQ(all.segments.size(), 4U + 1 + 72);
    EXPECT_TRUE(all.warnings.empty());
  }
  // What is no layer's state, as bit 2 of the flags: frozen in new windows.
  DxfWriter shown = frame_beside_layer("Aux", 2, 7);
  shown.begin_entities();
  add_frame(shown);
  EXPECT_EQ(read(shown.line("Aux", 0, 0, 9, 9).finish()).segments.size(), 5U);
  DxfWriter nothing = frame_beside_layer("Aux", 1, 7);
  EXPECT_EQ(message(nothing.begin_entities().line("Aux", 0, 0, 9, 9).finish()),
            "a.dxf: no line or curve in it; 1 line or curve is left out on hidden layers: Aux "
            "(frozen); --layer reads those it names");
}

TEST(ReadDxf, WhatIsInsertedOnAFrozenLayerIsFrozen) {
  // A layer that is off hides what is on layer 0 of the block alone.
  for (const auto& [flags, colour, segments] : {std::tuple(1, 7, 4U), std::tuple(0, -7, 5U)}) {
    DxfWriter d = frame_beside_layer("Aux", flags, colour);
    d.begin_blocks().begin_block("b").line("0", 0, 0, 9, 9).line("Frame", 0, 9, 9, 0).end_block();
    d.end_section().begin_entities();
    add_frame(d);
    const std::string text = d.insert("b", "Aux", {{10, 0}, {20, 0}}).finish();
    EXPECT_EQ(read(text).segments.size(), segments);
    ReadOptions options;
    options.layers = {"Aux"};
    EXPECT_EQ(read(text, options).segments.size(), 1U);
  }
}

TEST(ReadDxf, OfWhatRunsThroughSpaceXAndYCount) {
  DxfWriter d;
  d.begin_entities().line("0", 0, 0, 4, 0).entity("POLYLINE", "0", {{66, 1}, {70, 8}, {230, -1}});
  d.entity("VERTEX", "0", {{10, 4}, {20, 0}, {30, 1}, {70, 32}});
  d.entity("VERTEX", "0", {{10, 4}, {20, 4}, {30, 2}, {70, 32}}).group(0, "SEQEND");
  d.entity("LINE", "0", {{10, 4}, {20, 4}, {30, 0}, {11, 0}, {21, 0}, {31, 3}});
  // At one height it is as plane as all else; a mesh is none.
  d.entity("POLYLINE", "0", {{66, 1}, {70, 8}});
  d.entity("VERTEX", "0", {{10, 2}, {20, 0}, {30, 7}, {70, 32}});
  d.entity("VERTEX", "0", {{10, 4}, {20, 1}, {30, 7}, {70, 32}}).group(0, "SEQEND");
  d.entity("POLYLINE", "0", {{66, 1}, {70, 16}});
  d.entity("VERTEX", "0", {{10, 1}, {20, 0}, {70, 64}});
  const Input input =
      read(d.entity("VERTEX", "0", {{10, 3}, {20, 3}, {70, 64}}).group(0, "SEQEND").finish());
  EXPECT_EQ(input.segments.size(), 4U);
  EXPECT_DOUBLE_EQ(area_of(input), 8);
  EXPECT_EQ(input.warnings,
            (std::vector<std::string>{"1 polyline is a surface: left out",
                                      "2 lines and curves run through space: z is dropped"}));
}

TEST(ReadDxf, InvisibleEntitiesAreLeftOut) {
  DxfWriter d;
  d.begin_blocks().begin_block("b").line("Frame", 0, 0, 9, 9).end_block().end_section();
  d.begin_entities();
  add_frame(d);
  d.entity("LINE", "Frame", {{60, 1}, {10, 5}, {20, 0}, {11, 5}, {21, 9}});
  d.insert("b", "Frame", {{60, 1}, {10, 0}, {20, 0}});
  d.entity("POLYLINE", "Frame", {{60, 1}, {66, 1}, {70, 0}});
  d.entity("VERTEX", "Frame", {{10, 0}, {20, 5}}).entity("VERTEX", "Frame", {{10, 9}, {20, 5}});
  const Input input = read(d.group(0, "SEQEND").line("Frame", 0, 4, 9, 4).finish());
  EXPECT_EQ(input.segments.size(), 5U);
  EXPECT_EQ(input.warnings, std::vector<std::string>{"3 entities are invisible: left out"});
}

TEST(ReadDxf, StraightLinesGoThroughEndsThatRoundingTookOffThem) {
  constexpr double kSize = 10, kUlp = 0x1p-49;  // of its coordinates from 8 on
  for (const double ulps : {1.0, 4.0, 5.0}) {
    DxfWriter d;
    d.begin_entities().line("0", 0, 5, kSize, 5).line("0", 4, 5 + ulps * kUlp, 4, 9);
    d.line("0", 0, 5, 4, 9).line("0", 4, 9, kSize, 5);
    const Input input = read(d.finish());
    const bool is_bent = ulps <= 4;
    ASSERT_EQ(input.segments.size(), is_bent ? 5U : 4U) << ulps;
    ASSERT_EQ(input.changes.size(), is_bent ? 1U : 0U) << ulps;
    const auto cleaned = testing::clean(input);
    ASSERT_TRUE(cleaned) << cleaned.error().message;
    EXPECT_EQ(cleaned->table.regions.size(), is_bent ? 2U : 1U);
    Options strict;
    strict.strict = true;
    EXPECT_EQ(testing::clean(input, strict).has_value(), !is_bent);
    if (!is_bent) continue;
    EXPECT_EQ(input.segments[0].b, input.segments[1].a);
    EXPECT_EQ(input.segments[1].id, 0);
    EXPECT_EQ(input.changes[0].kind, Change::Kind::welded);
    EXPECT_EQ(
        input.changes[0].message.find("curve 0, straight from (0, 5) to (10, 5), was bent by "), 0U)
        << input.changes[0].message;
  }
}

TEST(ReadDxf, LinesThroughEndsOfArcsAreNotTold) {
  // The arc ends on the line but for rounding, at two thirds of the line and on its other half.
  DxfWriter d;
  d.begin_entities().line("0", 0, 0, 3 * std::cos(0.7), 3 * std::sin(0.7));
  d.line("0", 0, 0, 3 * std::cos(0.2), 3 * std::sin(0.2));
  for (const double radius : {1.0, 1.5, 2.0, 2.5})
    d.entity("ARC", "0",
             {{10, 0}, {20, 0}, {40, radius}, {50, 0.2 * 180 / M_PI}, {51, 0.7 * 180 / M_PI}});
  const Input input = read(d.finish());
  EXPECT_TRUE(input.changes.empty());
  const auto cleaned = testing::clean(input);
  ASSERT_TRUE(cleaned) << cleaned.error().message;
  EXPECT_EQ(cleaned->table.regions.size(), 4U);
}

TEST(ReadDxf, ALineThatTouchesACircleStays) {
  DxfWriter d;
  d.begin_entities().line("0", 1, -1, std::nextafter(1.0, 2.0), 1).circle("0", 0, 0, 1);
  const Input input = read(d.finish());
  EXPECT_EQ(input.segments.size(), 73U);
  EXPECT_TRUE(input.changes.empty());
}

TEST(ReadDxf, EntitiesInPaperSpaceAreTold) {
  const auto begin = [](DxfWriter& d) {
    d.begin_entities();
    d.entity("LINE", "Sheet", {{67, 1}, {10, 5}, {20, 0}, {11, 5}, {21, 9}});
    d.entity("VIEWPORT", "Sheet", {{67, 1}, {10, 5}, {20, 0}});
  };
  DxfWriter sheet;
  begin(sheet);
  EXPECT_EQ(message(sheet.finish()),
            "a.dxf: no line or curve in it; 1 entity is in paper space: left out");
  DxfWriter d;
  begin(d);
  add_frame(d);
  d.entity("POLYLINE", "Sheet", {{67, 1}, {66, 1}, {70, 0}});
  d.entity("VERTEX", "Sheet", {{67, 1}, {10, 0}, {20, 5}});
  d.entity("VERTEX", "Sheet", {{67, 1}, {10, 9}, {20, 5}});
  const Input input = read(d.group(0, "SEQEND").line("Frame", 0, 4, 9, 4).finish());
  EXPECT_EQ(input.segments.size(), 5U);
  EXPECT_EQ(input.warnings, std::vector<std::string>{"2 entities are in paper space: left out"});
}

TEST(ReadDxf, BadFilesAreRefused) {
  EXPECT_EQ(message(""), "a.dxf:0: the file ends without EOF");
  EXPECT_EQ(message("hello\nworld\n"), "a.dxf:1: 'hello' is no group code of DXF");
  EXPECT_NE(message("AutoCAD Binary DXF\r\n").find("binary DXF"), std::string::npos);
  EXPECT_NE(message("AC1015").find("DWG"), std::string::npos);
  DxfWriter empty;
  EXPECT_EQ(message(empty.begin_entities().finish()), "a.dxf: no line or curve in it");
  DxfWriter comma;
  comma.begin_entities().group(0, "LINE").group(10, "1,5");
  EXPECT_EQ(message(comma.finish()),
            "a.dxf:8: '1,5' is no number (decimals have a point; between numbers stand blanks)");
  DxfWriter infinite;
  infinite.begin_entities().group(0, "LINE").group(10, "1e999");
  EXPECT_NE(message(infinite.finish()).find("not finite"), std::string::npos);
  DxfWriter self;
  self.begin_blocks().begin_block("a").insert("b", "0", {{10, 0}}).end_block();
  self.begin_block("b").insert("a", "0", {{10, 0}}).end_block().end_section();
  self.begin_entities().insert("a", "0", {{10, 0}});
  EXPECT_EQ(message(self.finish()), "a.dxf: a block contains itself");
  DxfWriter lost;
  lost.begin_entities().circle("0", 0, 0, 1).insert("nowhere", "0", {{10, 0}});
  EXPECT_EQ(read(lost.finish()).warnings.back(), "blocks that are inserted and not there: nowhere");
}

TEST(ReadDxf, BombsAndLiesAreRefusedAtOnce) {
  DxfWriter array;
  array.begin_blocks().begin_block("a").circle("0", 0, 0, 1).end_block().end_section();
  const DxfWriter::Groups steps{{70, 1000000000}, {71, 1000000000}, {44, 1}, {45, 1}};
  array.begin_entities().insert("a", "0", steps);
  EXPECT_NE(message(array.finish()).find("blocks make 1e+18 things"), std::string::npos);
  DxfWriter empty;
  empty.begin_blocks().begin_block("a").end_block().end_section();
  empty.begin_entities().insert("a", "0", steps);
  EXPECT_NE(message(empty.finish()).find("blocks make 1e+18 things"), std::string::npos);
  DxfWriter nested;
  nested.begin_blocks().begin_block("b0").circle("0", 0, 0, 1).end_block();
  for (int k = 1; k < 40; ++k) {
    nested.begin_block("b" + std::to_string(k));
    for (int n = 0; n < 9; ++n) nested.insert("b" + std::to_string(k - 1), "0", {{10, n}});
    nested.end_block();
  }
  nested.end_section().begin_entities().insert("b39", "0", {{10, 0}});
  EXPECT_NE(message(nested.finish()).find("blocks make"), std::string::npos);
  DxfWriter fine;
  fine.begin_entities().circle("0", 0, 0, 1);
  ReadOptions options;
  options.chord_error = 1e-30;
  EXPECT_NE(message(fine.finish(), options).find("have more than 4194304 points"),
            std::string::npos);
  // Counts are believed by nobody.
  DxfWriter lies;
  lies.begin_entities().entity(
      "LWPOLYLINE", "0",
      {{90, 2000000000}, {70, 1}, {10, 0}, {20, 0}, {10, 1}, {20, 0}, {10, 0}, {20, 1}});
  lies.entity("SPLINE", "0",
              {{71, 2}, {72, 2000000000}, {73, 2000000000}, {74, 2000000000}, {10, 0}, {20, 0}});
  EXPECT_DOUBLE_EQ(area_of(read(lies.finish())), 0.5);
}

TEST(ReadDxf, EveryCutOffFileIsAnError) {
  DxfWriter d;
  d.begin_blocks().begin_block("a").circle("0", 0, 0, 1).end_block().end_section();
  d.begin_entities().insert("a", "0", {{10, 0}, {20, 0}}).line("x", 0, 0, 5, 5);
  const std::string text = d.finish();
  for (std::size_t n = 0; n + 2 < text.size(); ++n)  // EO is no EOF
    EXPECT_FALSE(parse_dxf(text.substr(0, n), "a.dxf")) << n;
}

TEST(ReadDxf, ReadsMotorsOfOthers) {
  for (const auto& [name, regions] :
       {std::pair("stator_concentrated.dxf", 26U), std::pair("reluctance_caseA.dxf", 7U)}) {
    const auto path = cases_folder() / "formats" / name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const Result<Input> input = read_dxf(path.string());
    ASSERT_TRUE(input) << input.error().message;
    const auto out = testing::clean(*input);
    ASSERT_TRUE(out) << out.error().message;
    EXPECT_EQ(out->table.regions.size(), regions) << name;
  }
}

}  // namespace
}  // namespace cover
