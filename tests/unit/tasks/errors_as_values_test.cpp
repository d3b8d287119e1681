#include "tasks/errors_as_values.hpp"

#include <gtest/gtest.h>

#include <array>
#include <new>
#include <vector>

#include "region/region_graph.hpp"

namespace cover {
namespace {

TEST(ErrorsAsValues, KeepsResultsAndErrors) {
  EXPECT_EQ(errors_as_values("count", [] { return Result<int>(7); }).value(), 7);
  const auto failed = errors_as_values("count", []() -> Result<int> {
    return Error{ErrorCode::syntax, "no", {}, {}};
  });
  EXPECT_EQ(failed.error().code, ErrorCode::syntax);
}

/// What no input leads to: a table of regions is asked for where segments cross.
TEST(ErrorsAsValues, MakesAnErrorOfABrokenPromise) {
  Pslg pslg;
  pslg.points = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  pslg.point_ids = {0, 1, 2, 3};
  pslg.segments = {{VertexId{0}, VertexId{1}, 0, 0, 0}, {VertexId{2}, VertexId{3}, 0, 0, 1}};
  std::vector<Note> notes;
  const Result<RegionTable> table =
      errors_as_values("regions", [&] { return build_region_table(pslg, {}, notes); });
  ASSERT_FALSE(table.has_value());
  EXPECT_EQ(table.error().code, ErrorCode::internal);
  EXPECT_EQ(table.error().message,
            "regions: find_faces: the segments are no PSLG; this is an error in cover, please "
            "report it with the input");
}

TEST(ErrorsAsValues, LackOfMemoryIsAnErrorOfItsOwn) {
  const auto failed =
      errors_as_values("a stage with a long name", []() -> Status { throw std::bad_alloc(); });
  EXPECT_EQ(failed.error().code, ErrorCode::out_of_memory);
  EXPECT_EQ(failed.error().message, "a stage with a long name: out of memory");
}

TEST(ErrorsAsValues, WhatACallerThrowsIsNoErrorInCover) {
  const auto failed = errors_as_values("sizes", []() -> Status {
    throw CallerFault("the size function failed at (1, 2): no data", {1, 2});
  });
  EXPECT_EQ(failed.error().code, ErrorCode::bad_option);
  EXPECT_EQ(failed.error().message, "the size function failed at (1, 2): no data");
  EXPECT_EQ(failed.error().where, std::vector<Point>({{1, 2}}));
}

}  // namespace
}  // namespace cover
