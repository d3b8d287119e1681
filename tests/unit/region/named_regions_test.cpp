#include <cover/regions.hpp>

#include <gtest/gtest.h>

#include <cover/pslg.hpp>

#include "region/lines_between.hpp"

namespace cover {
namespace {

RegionTable table() {
  RegionTable table;
  const auto add = [&](std::string name, std::string material_name, int material) {
    Region region;
    region.id = RegionId{table.regions.size() + 1};
    region.name = std::move(name);
    region.material_name = std::move(material_name);
    region.material = material;
    table.regions.push_back(region);
  };
  add("gate", "poly", 3);
  add("drain", "Si", 1);
  add("source", "Si", 1);
  add("1", "region:2", 3);
  return table;
}

using Ids = std::vector<RegionId>;

TEST(NamedRegions, NamesOfRegionsAndMaterials) {
  EXPECT_EQ(named_regions(table(), "gate"), Ids{RegionId{1}});
  EXPECT_EQ(named_regions(table(), "Si"), (Ids{RegionId{2}, RegionId{3}}));
  EXPECT_EQ(named_regions(table(), "si"), Ids{});
  EXPECT_EQ(named_regions(table(), ""), Ids{});
}

TEST(NamedRegions, NumbersOfMaterialsAndIds) {
  EXPECT_EQ(named_regions(table(), "3"), (Ids{RegionId{1}, RegionId{4}}));
  EXPECT_EQ(named_regions(table(), "region:3"), Ids{RegionId{3}});
  for (const char* none : {"2", "-1", "3x", "region:", "region:0", "region:5", "region:-1"}) {
    EXPECT_EQ(named_regions(table(), none), Ids{}) << none;
  }
}

TEST(NamedRegions, NamesComeFirst) {
  EXPECT_EQ(named_regions(table(), "1"), Ids{RegionId{4}});
  EXPECT_EQ(named_regions(table(), "region:2"), Ids{RegionId{4}});
}

/// A square, whose sides are 'left', 'right' and twice nothing, and the markers 7, 8, 7 and 9.
TEST(NamedSegments, LinesOrElseMarkers) {
  Pslg pslg;
  RegionTable lines;
  for (const int marker : {7, 8, 7, 9}) {
    pslg.segments.emplace_back();
    pslg.segments.back().marker = marker;
  }
  lines.interfaces.resize(3);
  for (Interface& line : lines.interfaces) line.kind = InterfaceKind::contact;
  lines.interfaces[0].name = "left";
  lines.interfaces[0].segments = {SegmentId{3}, SegmentId{0}};
  lines.interfaces[1].name = "8";
  lines.interfaces[1].segments = {SegmentId{2}};
  lines.interfaces[2].name = "left";
  lines.interfaces[2].segments = {SegmentId{1}};
  using Segments = std::vector<SegmentId>;
  EXPECT_EQ(named_segments(pslg, lines, "left"),
            (Segments{SegmentId{0}, SegmentId{1}, SegmentId{3}}));
  EXPECT_EQ(named_segments(pslg, lines, "7"), (Segments{SegmentId{0}, SegmentId{2}}));
  EXPECT_EQ(named_segments(pslg, lines, "marker 7"), (Segments{SegmentId{0}, SegmentId{2}}));
  EXPECT_EQ(named_segments(pslg, lines, "8"), Segments{SegmentId{2}});
  EXPECT_EQ(named_segments(pslg, lines, "marker 8"), Segments{SegmentId{1}});
  for (const char* none : {"0", "marker 0", "6", "7x", "marker", "marker 7 ", ""})
    EXPECT_EQ(named_segments(pslg, lines, none), Segments{}) << none;
}

/// As drawings number regions, any of two may be the left one.
TEST(NamedSegments, InterfacesInEitherOrder) {
  Pslg pslg;
  pslg.segments.resize(4);
  RegionTable lines = table();
  lines.interfaces.resize(4);
  for (std::size_t k = 0; k < 4; ++k) {
    lines.interfaces[k].left = RegionId{k + 1};
    lines.interfaces[k].right = RegionId{k == 2 ? 0 : k < 2 ? k + 2 : 1};
    lines.interfaces[k].segments = {SegmentId{k}};
  }
  lines.interfaces[0].name = "gate_drain";
  lines.interfaces[1].name = "drain_source_2";  // as a contact has the other name
  lines.interfaces[2].name = "source_outline";
  lines.interfaces[2].kind = InterfaceKind::outline;
  lines.regions[3].name = "drain";  // to the left of another gate
  lines.interfaces[3].name = "gate_drain";
  using Segments = std::vector<SegmentId>;
  EXPECT_EQ(named_segments(pslg, lines, "gate_drain"), (Segments{SegmentId{0}, SegmentId{3}}));
  EXPECT_EQ(named_segments(pslg, lines, "drain_gate"), (Segments{SegmentId{0}, SegmentId{3}}));
  EXPECT_EQ(named_segments(pslg, lines, "source_drain"), Segments{SegmentId{1}});
  for (const char* none : {"gate_gate", "drain_gat", "_gate", "drain_", "outline_source"})
    EXPECT_EQ(named_segments(pslg, lines, none), Segments{}) << none;
  pslg.names = {"", "drain_gate"};  // the input's own line, wherever it lies
  EXPECT_EQ(named_segments(pslg, lines, "drain_gate"), Segments{});
}

TEST(LinesBetween, RegionsOrMaterialsThatANameIsMadeOf) {
  RegionTable between = table();
  const auto add = [&](std::string name, int left, int right, InterfaceKind kind) {
    Interface line;
    line.name = std::move(name);
    line.left = RegionId{left};
    line.right = right == 0 ? kVoid : RegionId{right};
    line.kind = kind;
    between.interfaces.push_back(std::move(line));
  };
  add("oxide", 1, 2, InterfaceKind::contact);
  add("gate_source", 3, 1, InterfaceKind::interface);
  add("outline", 1, 0, InterfaceKind::outline);
  EXPECT_EQ(lines_between(between, "gate_drain"), "; between 'gate' and 'drain' lies 'oxide'");
  EXPECT_EQ(lines_between(between, "Si_poly"),
            "; between 'Si' and 'poly' lie 'gate_source', 'oxide'");
  EXPECT_EQ(lines_between(between, "poly_Si"),
            "; between 'poly' and 'Si' lie 'gate_source', 'oxide'");
  for (const char* none : {"Si_Si", "Si", "Si_", "poly_", "drain_source"})
    EXPECT_EQ(lines_between(between, none), "") << none;
}

TEST(LineInVoid, TellsWhereItLies) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}};
  pslg.names = {"", "gate"};
  pslg.segments = {{VertexId{0}, VertexId{1}, 0, 0}, {VertexId{1}, VertexId{2}, 0, 1}};
  EXPECT_EQ(line_in_void(pslg, "gate"),
            "the line 'gate' touches no region that is meshed: it lies in the void, first from "
            "(1, 0) to (1, 1)");
  EXPECT_EQ(line_in_void(pslg, "gat"), "");
  EXPECT_EQ(line_in_void(pslg, ""), "");
}

TEST(NamedRegions, TheErrorNamesTheNearest) {
  const Error error = no_such_region(table(), "only", "gaet");
  EXPECT_EQ(error.code, ErrorCode::bad_option);
  EXPECT_NE(error.message.find("only 'gaet'"), std::string::npos);
  EXPECT_NE(error.message.find("'gate'?"), std::string::npos);
}

}  // namespace
}  // namespace cover
