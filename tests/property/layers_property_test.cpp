// What must hold with layers along random lines of random devices: every promise, and what the
// report says of them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

class Layers : public ::testing::TestWithParam<testing::RandomInput> {
 protected:
  /// About as thick as a hundredth of a region, give or take a lot.
  static LayerRule random_rule(std::mt19937_64& random, const RegionTable& table) {
    const Interface& line = table.interfaces[random() % table.interfaces.size()];
    LayerRule rule;
    rule.line = line.name;
    const Region& left = table.region(line.left);
    if (random() % 3 == 0) rule.region = left.name;
    std::uniform_real_distribution<double> exponent(-5, -1), growth(1.05, 2);
    rule.first = std::sqrt(left.area) * std::pow(10.0, exponent(random));
    rule.growth = random() % 4 == 0 ? 1.0 : growth(random);
    rule.count = static_cast<int>(random() % 12) + (rule.growth == 1 ? 1 : 0);
    return rule;
  }

  static Options random_options(std::mt19937_64& random, const RegionTable& table) {
    Options options;
    options.threads = 2;
    options.effort = Effort::fast;
    if (random() % 4 == 0) options.method = Method::almond;
    if (random() % 3 == 0) options.split_interfaces = Angle::degrees(100);
    if (options.method == Method::quality && random() % 4 == 0) options.box_method = true;
    for (std::uint64_t k = 1 + random() % 4; k > 0; --k)
      options.layers.push_back(random_rule(random, table));
    return options;
  }

  static void check(const Input& input, const Options& options) {
    const Result<Output> output = cover_mesh(input, options);
    if (!output) {
      // Some layers are thicker than some region, and said to be.
      ASSERT_EQ(output.error().code, ErrorCode::bad_option) << output.error().message;
      EXPECT_NE(output.error().message.find("layers for '"), std::string::npos)
          << output.error().message;
      return;
    }
    EXPECT_EQ(testing::violations(*output), "");
    // Without --box-method cuts serve the angles.
    const bool minds_couplings =
        options.method == Method::quality && (!options.split_interfaces || options.box_method);
    for (const RegionReport& region : output->report.regions) {
      if (minds_couplings) {
        EXPECT_EQ(region.box.negative_inside, 0U);
      }
      for (const LayerReport& layers : region.layers) {
        std::size_t short_of = 0;
        for (const auto& part : layers.cut_short) short_of += part.segments;
        EXPECT_EQ(layers.complete + short_of, layers.segments);
        EXPECT_LE(layers.fewest, layers.most);
        if (layers.asked.count > 0) {
          EXPECT_LE(layers.most, layers.asked.count);
        }
        if (layers.most > 0) {
          EXPECT_GE(layers.thickness, layers.asked.first * (1 - 1e-12));
        }
      }
    }
  }

  /// Layers by chance on the device that `seed` makes.
  static void try_seed(std::uint64_t seed) {
    SCOPED_TRACE(testing::seed_trace(seed));
    std::mt19937_64 random(seed);
    const Input input = GetParam().make(seed);
    const Result<Prepared> prepared = prepare(input);
    if (!prepared) {
      EXPECT_EQ(prepared.error().code, ErrorCode::conflicting_seeds) << prepared.error().message;
      return;
    }
    check(input, random_options(random, prepared->table));
  }
};

TEST_P(Layers, KeepEveryPromise) {
  const std::uint64_t inputs = testing::cases_asked_for("COVER_LAYER_TRIALS", 12);  // of a kind
  const std::uint64_t first = testing::test_seed(4711);
  for (std::uint64_t seed = first; seed < first + inputs; ++seed) try_seed(seed);
}

/// Cells: cuts beside layers, rounded, would cross a segment that is nearly straight with them.
TEST_P(Layers, KeepEveryPromiseWhereCutsWouldCross) { try_seed(700130); }

INSTANTIATE_TEST_SUITE_P(Random, Layers, ::testing::ValuesIn(testing::kRandomDevices),
                         [](const auto& sample) { return sample.param.name; });

}  // namespace
}  // namespace cover
