#include "verify/promises/verify_limits.hpp"

#include <gtest/gtest.h>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(VerifyLimits, TheCheckerFindsTheLimitsOfTheRun) {
  Options options;
  options.threads = 1;
  const Input input = random_cells(40, 3);
  const Result<Output> output = cover_mesh(input, options);
  ASSERT_TRUE(output) << output.error().message;
  const Verification found = verify_cover(output->pslg, output->table, triangle_soup(output->mesh));
  ASSERT_EQ(found.violation_count, 0U);
  const auto& regions = output->report.regions;
  ASSERT_EQ(found.limits.size(), regions.size());
  LimitCounts counts;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    counts.add(found.limits[r]);
    const RegionLimits& own = regions[r].limits;
    EXPECT_NE(own.of_largest, Standing::unknown);
    EXPECT_NE(found.limits[r].of_largest, Standing::unknown);
    EXPECT_EQ(own.of_largest == Standing::met, found.limits[r].of_largest == Standing::met);
    EXPECT_EQ(own.of_smallest == Standing::met, found.limits[r].of_smallest == Standing::met);
    // No limit is better than what was reached.
    EXPECT_GE(found.limits[r].largest_nu.in_degrees() + 1e-6,
              regions[r].quality.largest_nu.in_degrees());
    if (own.of_smallest != Standing::met) {
      EXPECT_GE(found.limits[r].smallest.in_degrees() + 1e-6,
                regions[r].quality.smallest.in_degrees());
    }
  }
  // Cells whose corners lie in the middle of their neighbours' sides miss many targets.
  EXPECT_GT(counts.smallest[static_cast<std::size_t>(Standing::near)] +
                counts.smallest[static_cast<std::size_t>(Standing::optimal)],
            0U);
}

TEST(VerifyLimits, NothingIsSaidWhereSegmentsMayBeSplit) {
  Options options;
  options.threads = 1;
  const Result<Output> output = cover_mesh(checker(2, 2, 1), options);
  ASSERT_TRUE(output);
  VerifyOptions verify;
  verify.allow_split = true;
  EXPECT_TRUE(verify_cover(output->pslg, output->table, triangle_soup(output->mesh), verify)
                  .limits.empty());
}

}  // namespace
}  // namespace cover
