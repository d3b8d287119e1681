#include "layers/front/offsets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "layers/front/thickness.hpp"

namespace cover::layers {
namespace {

constexpr double kClose = 1e-12;

Vector normal_at(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

TEST(Offsets, GoStraightUpFromAStraightLine) {
  const Offset offset = offset_of({3, 5}, {0, 1}, {0, 1}, false);
  EXPECT_EQ(offset.kind, Offset::Kind::plain);
  EXPECT_EQ(offset.at(0.25), (Point{3, 5.25}));
  EXPECT_EQ(tops_of(offset, 1).size(), 1U);
}

TEST(Offsets, KeepTheDistanceToBothLinesInAMitre) {
  for (const double bend : {-20.0, -7.0, 5.0, 20.0, 45.0, 79.0}) {
    SCOPED_TRACE(bend);
    const Vector from = normal_at(30), to = normal_at(30 + bend);
    const Offset offset = offset_of({1, 2}, from, to, false);
    EXPECT_EQ(offset.kind, Offset::Kind::plain);
    const Vector way = offset.at(3) - Point{1, 2};
    EXPECT_NEAR(dot(way, from), 3, kClose);
    EXPECT_NEAR(dot(way, to), 3, kClose);
  }
}

TEST(Offsets, MakeSquaresAroundARightCorner) {
  const Offset corner = offset_of({0, 0}, {0, 1}, {1, 0}, false);
  EXPECT_EQ(corner.kind, Offset::Kind::corner);
  const auto tops = tops_of(corner, 2);
  ASSERT_EQ(tops.size(), 3U);
  EXPECT_EQ(tops[0].at(3), (Point{2, 3}));
  EXPECT_EQ(tops[1].at(3), (Point{3, 3}));
  EXPECT_EQ(tops[2].at(3), (Point{3, 2}));
  EXPECT_EQ(tops[1].kind, Offset::Kind::corner);
  const Vector n = normal_between(tops[0], tops[1]), m = normal_between(tops[1], tops[2]);
  EXPECT_NEAR(n.y, 1, kClose);
  EXPECT_NEAR(m.x, 1, kClose);
}

TEST(Offsets, MakeTwoSquaresAroundTheEndOfASlit) {
  const auto tops = tops_of(offset_of({0, 0}, {0, 1}, {0, -1}, true), 0);
  ASSERT_EQ(tops.size(), 5U);
  const Point expected[] = {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(tops[k].at(1).x, expected[k].x, kClose) << k;
    EXPECT_NEAR(tops[k].at(1).y, expected[k].y, kClose) << k;
  }
}

TEST(Offsets, FanAroundOtherCornersInPiecesThatAreNoWiderThanAMitre) {
  for (const double bend : {21.0, 45.0, 79.0, 101.0, 135.0, 159.0}) {
    SCOPED_TRACE(bend);
    const auto tops = tops_of(offset_of({0, 0}, normal_at(0), normal_at(-bend), false), 0);
    ASSERT_GE(tops.size(), 3U);
    EXPECT_NEAR(tops.front().at(1).y, 0, kClose);
    double sum = 0;
    for (std::size_t k = 0; k + 1 < tops.size(); ++k) {
      EXPECT_NEAR(length(tops[k].along), 1, kClose);
      const double piece = -turning_angle(tops[k].along, tops[k + 1].along);
      EXPECT_GT(piece, 0);
      EXPECT_LE(piece, kMitre + 1e-9);
      sum += piece;
    }
    EXPECT_NEAR(sum, bend, 1e-9);
  }
}

/// Corners that are alike up to rounding get the same, wherever they lie.
TEST(Offsets, AreAlikeInAllCornersOfARegularPolygon) {
  for (const double bend : {20.0, 40.0, 60.0, 80.0, 160.0}) {
    SCOPED_TRACE(bend);
    const auto offset = [&](int k) {
      const double from = bend * k;
      return offset_of({0, 0}, normal_at(from), normal_at(from - bend), false);
    };
    for (int k = 1; k < 36; ++k) {
      EXPECT_EQ(offset(k).kind, offset(0).kind) << k;
      EXPECT_EQ(tops_of(offset(k), 0).size(), tops_of(offset(0), 0).size()) << k;
    }
  }
  EXPECT_EQ(offset_of({0, 0}, normal_at(0), normal_at(-20), false).kind, Offset::Kind::plain);
}

TEST(Thickness, IsAGeometricSum) {
  const Thickness thickness({"", "", 0.2, 1.5, 4}, 100);
  ASSERT_EQ(thickness.rows(), 4);
  EXPECT_EQ(thickness.total(0), 0);
  EXPECT_EQ(thickness.total(1), 0.2);
  EXPECT_NEAR(thickness.total(4), 0.2 * (std::pow(1.5, 4) - 1) / 0.5, kClose);
  EXPECT_NEAR(thickness.layer(3), 0.2 * std::pow(1.5, 3), kClose);
}

TEST(Thickness, EndsWhereThereIsNoRoom) {
  EXPECT_EQ(Thickness({"", "", 1, 1, 0}, 10.5).rows(), 10);
  EXPECT_EQ(Thickness({"", "", 1, 1e300, 0}, 10.5).rows(), 1);
  EXPECT_EQ(Thickness({"", "", 11, 2, 5}, 10.5).rows(), 0);
  EXPECT_EQ(Thickness({"", "", 1e-6, 1, 0}, 10.5).rows(), Thickness::kMostRows);
}

}  // namespace
}  // namespace cover::layers
