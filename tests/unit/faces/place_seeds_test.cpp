// Seeds of an input over what its polygons say of the same faces. That they count in a run is
// tested in tests/unit/clean/soup_test.cpp.
#include "faces/place_seeds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace cover {
namespace {

/// Two squares beside each other, of which a polygon has painted the left one: segment 0 is between
/// them.
class SeedsOverPolygons : public ::testing::Test {
 protected:
  SeedsOverPolygons() {
    painted_.points = {{1, 0}, {1, 1}, {0, 1}, {0, 0}, {2, 0}, {2, 1}};
    constexpr std::array<std::array<std::uint32_t, 2>, 7> kEnds{
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 5}, {5, 1}}};
    for (const auto& [a, b] : kEnds) painted_.segments.push_back({VertexId{a}, VertexId{b}});
    RegionSeed polygon = seed({0, 0}, "oxide");
    polygon.region = "left";
    polygon.size = 0.5;
    painted_.seeds = {polygon};
    painted_.side_seeds.assign(7, {0, 0});
    for (std::size_t s = 0; s < 4; ++s) painted_.side_seeds[s] = {1, 0};
  }

  static RegionSeed seed(Point at, std::string material) {
    RegionSeed out;
    out.at = at;
    out.material = std::move(material);
    return out;
  }

  [[nodiscard]] Pslg placed() const {
    std::vector<Note> notes;
    Result<Pslg> out = place_seeds(input_, painted_, notes);
    EXPECT_TRUE(out) << out.error().message;
    return out ? *std::move(out) : Pslg{};
  }
  /// What speaks for the face on the left of a segment; null: it is void.
  static const RegionSeed* on_left(const Pslg& pslg, std::size_t segment) {
    const std::uint32_t k = pslg.side_seeds[segment][0];
    return k == 0 ? nullptr : &pslg.seeds[k - 1];
  }

  Input input_;
  Pslg painted_;
};

TEST_F(SeedsOverPolygons, WithoutSeedsPolygonsSpeakForAll) {
  const Pslg out = placed();
  EXPECT_EQ(out.side_seeds, painted_.side_seeds);
}

TEST_F(SeedsOverPolygons, ASeedWinsOverThePolygon) {
  input_.seeds = {seed({0.5, 0.5}, "gas")};
  const Pslg out = placed();
  ASSERT_NE(on_left(out, 0), nullptr);
  EXPECT_EQ(on_left(out, 0)->material, "gas");
  EXPECT_EQ(on_left(out, 0)->region, "");
  EXPECT_FALSE(on_left(out, 0)->size) << "what was wished of the polygon is of another material";
}

TEST_F(SeedsOverPolygons, ASeedWithoutAMaterialLeavesThePolygonsOwn) {
  input_.seeds = {seed({0.5, 0.5}, "")};
  input_.seeds[0].size = 0.25;
  const Pslg out = placed();
  ASSERT_NE(on_left(out, 0), nullptr);
  EXPECT_EQ(on_left(out, 0)->material, "oxide");
  EXPECT_EQ(on_left(out, 0)->region, "left");
  EXPECT_EQ(on_left(out, 0)->size, 0.25);
  input_.seeds[0].size = 0.75;
  EXPECT_EQ(on_left(placed(), 0)->size, 0.5) << "the smaller size counts";
}

TEST_F(SeedsOverPolygons, AFaceBetweenPolygonsGetsAMaterialOfItsOwn) {
  input_.seeds = {seed({1.5, 0.5}, "gas")};
  const Pslg out = placed();
  ASSERT_NE(on_left(out, 5), nullptr);
  EXPECT_EQ(on_left(out, 5)->material, "gas");
  EXPECT_EQ(out.side_seeds[0][1], out.side_seeds[5][0]) << "it is on the right of segment 0";
  EXPECT_EQ(on_left(out, 0)->material, "oxide");
}

TEST_F(SeedsOverPolygons, AHoleSeedMakesAFaceOfAPolygonVoid) {
  input_.holes = {{{0.5, 0.5}, 1, 0}};
  EXPECT_EQ(on_left(placed(), 0), nullptr);
}

TEST_F(SeedsOverPolygons, ASeedOutsideIsRefused) {
  input_.seeds = {seed({9, 9}, "gas")};
  std::vector<Note> notes;
  EXPECT_EQ(place_seeds(input_, painted_, notes).error().code, ErrorCode::seed_in_void);
}

}  // namespace
}  // namespace cover
