#include <cover/estimate.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <cover/cover_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

double triangles_expected(const Input& input, const Options& options) {
  const Result<Prepared> prepared = prepare(input, options);
  return estimate(prepared.value(), options).value().triangles;
}

TEST(Estimate, IsNearWhatTheMeshTakes) {
  const Input input = testing::checker(3, 30, 7);
  for (const double size : {0.0, 0.02, 0.005}) {
    Options options;
    if (size > 0) options.sizes = {{"", size, false}};
    options.split_interfaces = Angle::degrees(90);
    const double expected = triangles_expected(input, options);
    const auto made =
        static_cast<double>(testing::must_mesh(input, options).report.quality.triangles);
    EXPECT_LT(expected, made * (size > 0 ? 1.35 : 2)) << size;
    EXPECT_GT(expected, made / (size > 0 ? 1.35 : 2)) << size;
  }
}

TEST(Estimate, KnowsThatWholeSegmentsForbidSizes) {
  const Input square = testing::input_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  Options options;
  options.sizes = {{"", 0.01, false}};
  const Estimate whole = estimate(prepare(square, options).value(), options).value();
  EXPECT_LT(whole.triangles, 200) << "by the area alone 23,000";
  ASSERT_EQ(whole.notes.size(), 1U);
  EXPECT_NE(whole.notes.front().message.find("4 segments are longer than the sizes asked for"),
            std::string::npos);
  options.split_interfaces = Angle::degrees(90);
  const Estimate cut = estimate(prepare(square, options).value(), options).value();
  EXPECT_GT(cut.triangles, 10'000);
  EXPECT_TRUE(cut.notes.empty());
}

TEST(Estimate, CountsLayers) {
  Input input =
      testing::segments_between({{0, 0}, {100, 0}, {100, 40}, {0, 40}, {0, -2}, {100, -2}},
                                {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 5}, {5, 1}});
  input.segments[0].name = "line";
  input.seeds.push_back({{50, 20}, "1", "body", {}, 0, 0});
  input.seeds.push_back({{50, -1}, "2", "film", {}, 1, 0});
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.box_method = true;
  options.sizes = {{"line", 2, true}};
  const double without = triangles_expected(input, options);
  options.layers = {{"line", "body", 0.02, 1.3, 0}, {"line", "film", 0.4, 1, 3}};
  const double expected = triangles_expected(input, options);
  const auto made =
      static_cast<double>(testing::must_mesh(input, options).report.quality.triangles);
  EXPECT_LT(without, made / 2);
  EXPECT_LT(expected, made * 1.35);
  EXPECT_GT(expected, made / 1.35);
}

TEST(Estimate, RefusesLayersOfNoLine) {
  Options options;
  options.layers = {{"gate", "", 0.1, 1, 1}};
  const Result<Prepared> square = prepare(testing::input_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  const Result<Estimate> refused = estimate(square.value(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_option);
}

TEST(Estimate, OfDisksIsRightUpToAFactorOfTen) {
  const Input input = testing::checker(3, 30, 7);
  for (const Method method : {Method::nonobtuse, Method::almond}) {
    Options options;
    options.method = method;
    options.fill = Fill::disks;
    const Result<Prepared> prepared = prepare(input, options);
    ASSERT_TRUE(prepared) << prepared.error().message;
    const Estimate expected = estimate(*prepared, options).value();
    EXPECT_TRUE(expected.by_disks);
    const auto made =
        static_cast<double>(testing::must_mesh(input, options).report.quality.triangles);
    EXPECT_LT(expected.triangles, 10 * made);
    EXPECT_GT(expected.triangles, made / 10);
  }
  EXPECT_FALSE(estimate(prepare(input).value()).value().by_disks);
}

TEST(Estimate, GrowsWithTheTriangles) {
  const Input input = testing::checker(3, 30, 7);
  Options fine;
  fine.split_interfaces = Angle::degrees(90);
  fine.sizes = {{"", 1e-3, false}};
  const Estimate small = estimate(prepare(input).value()).value();
  const Estimate large = estimate(prepare(input, fine).value(), fine).value();
  EXPECT_GT(large.bytes, small.bytes + 100 * (large.triangles - small.triangles));
  EXPECT_GT(small.available, small.bytes);
}

TEST(Estimate, WhatDoesNotFitIsRefusedBeforeTheRun) {
  const Input input = testing::checker(1, 2, 7);
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.sizes = {{"", 6e-5, false}};  // 6e8 triangles, 100 GB
  const Result<Output> refused = cover_mesh(input, options);
  if (estimate(prepare(input).value()).value().available > 5e10) GTEST_SKIP() << "it may fit";
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::out_of_memory);
  EXPECT_NE(refused.error().message.find("GB of memory"), std::string::npos)
      << refused.error().message;
}

TEST(Estimate, RefusesOptionsThatAreNotLegal) {
  const Prepared prepared = prepare(testing::input_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}})).value();
  for (const double growth : {1.0, -1.0, std::nan("")}) {
    Options options;
    options.sizes = {{"", 0.1, false}};
    options.growth = growth;
    const Result<Estimate> estimated = estimate(prepared, options);
    ASSERT_FALSE(estimated);
    EXPECT_EQ(estimated.error().code, ErrorCode::bad_option);
    EXPECT_FALSE(box_costs(prepared, options));
  }
}

}  // namespace
}  // namespace cover
