// Random unit cells and sectors, whole and cut in every way: no vertex on a periodic side is
// without its partner, and all promises hold.
#include <gtest/gtest.h>

#include <random>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "support/inputs/periodic_cells.hpp"
#include "support/inputs/shapes.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

/// Random cells and sectors: COVER_PERIODIC_TRIALS if set.
std::size_t periodic_trials() { return testing::cases_asked_for("COVER_PERIODIC_TRIALS", 60); }

Options random_periodic_options(std::mt19937_64& random) {
  Options options;
  options.effort = Effort::fast;
  switch (random() % 6) {
    case 0:
      break;
    case 1:
      options.split_interfaces = Angle::degrees(90 + static_cast<double>(random() % 30));
      break;
    case 2:
      options.split_interfaces = Angle::degrees(90);
      options.sizes = {{"", 0.25, false}};
      break;
    case 3:
      options.split_interfaces = Angle::degrees(100);
      options.sizes = {{random() % 2 == 0 ? "unnamed" : "region:1", 0.1, false}};
      break;
    case 4:
      options.box_method = true;
      break;
    default:
      options.box_method = true;
      options.split_interfaces = Angle::degrees(90);
      options.max_angle = Angle::degrees(90);
      break;
  }
  return options;
}

TEST(Periodic, NoVertexIsWithoutItsPartner) {
  const std::uint64_t first = testing::test_seed(1500);
  std::size_t cut = 0, completed = 0;
  for (std::uint64_t seed = first; seed < first + periodic_trials(); ++seed) {
    SCOPED_TRACE(testing::seed_trace(seed));
    std::mt19937_64 random(seed);
    const bool gaps = random() % 2 == 0;
    const std::size_t kind = random() % 4;
    const Input input =
        kind < 2 ? testing::random_cell(seed, gaps) : testing::random_sector(seed, gaps, kind == 3);
    const Options options = random_periodic_options(random);
    const Result<Output> output = cover_mesh(input, options);
    ASSERT_TRUE(output) << output.error().message;
    ASSERT_EQ(output->periodic.size(), input.periodic.size());
    EXPECT_EQ(testing::unpaired(*output), "");
    EXPECT_EQ(testing::violations(*output), "");
    cut += output->pslg.points.size() > output->report.input_points ? 1 : 0;
    completed += output->report.changes.empty() ? 0 : 1;
  }
  EXPECT_GT(cut, periodic_trials() / 3);
  EXPECT_GT(completed, periodic_trials() / 10);
}

}  // namespace
}  // namespace cover
