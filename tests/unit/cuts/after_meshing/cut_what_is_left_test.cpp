#include "cuts/after_meshing/cut_what_is_left.hpp"

#include <gtest/gtest.h>

#include "support/inputs/soups.hpp"
#include "without_obtuse.hpp"

namespace cover {
namespace {

/// Layers of 5 nm to 3 um, and a trapezoid in one that a single cut mends, too few for another
/// round: other vertices do not mend it.
Input layers_with_a_trapezoid() {
  Input input;
  testing::add_polygon(input, testing::rectangle(0, 0, 40, 3), "lay0");
  testing::add_polygon(input, testing::rectangle(0, 3, 40, 3.005), "lay1");
  testing::add_polygon(input, testing::rectangle(0, 3.005, 40, 3.025), "lay2");
  testing::add_polygon(input, testing::rectangle(0, 3.025, 40, 4.025), "lay3");
  testing::add_polygon(input, {{8.11, 0.3226}, {11.28, 0.3226}, {10.62, 1.8346}, {8.77, 1.8346}},
                       "trapezoid");
  return input;
}

TEST(CutWhatIsLeft, LeavesNoObtuseTriangle) {
  for (const bool box_method : {false, true}) {
    Options options = no_obtuse_angle();
    options.box_method = box_method;
    const Output output = mesh_of(layers_with_a_trapezoid(), options);
    EXPECT_EQ(output.report.quality.obtuse, 0U) << box_method;
  }
}

TEST(CutWhatIsLeft, DependsOnNeitherUnitNorThreads) {
  expect_same_for_threads_and_unit(layers_with_a_trapezoid());
}

TEST(CutWhatIsLeft, DoesNothingWhereNothingIsLeft) {
  Work work;
  ASSERT_TRUE(cut_what_is_left(work, no_obtuse_angle(), {}));
  EXPECT_TRUE(work.report.notes.empty());
}

}  // namespace
}  // namespace cover
