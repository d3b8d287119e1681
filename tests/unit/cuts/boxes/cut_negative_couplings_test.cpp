#include "cuts/boxes/cut_negative_couplings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

Options for_boxes() {
  Options options;
  options.box_method = true;
  return options;
}

/// What the outside check finds on the PSLG with its cuts.
std::vector<NegativeCoupling> negative(const Output& output) {
  VerifyOptions verify;
  verify.box_method = true;
  return verify_cover(output.pslg, output.table, triangle_soup(output.mesh), verify)
      .negative_couplings;
}

/// Whether the report names negative couplings that are left.
bool warns(const Output& output) {
  return std::any_of(output.report.notes.begin(), output.report.notes.end(), [](const Note& note) {
    return note.message.starts_with("box-method: ") && note.kind == Note::Kind::warning;
  });
}

/// A half disc whose diameter is one side: every inner point lies in its disk.
Input half_disc(int chords) {
  testing::Loop loop;
  for (int k = 0; k <= chords; ++k) {
    const double u = std::numbers::pi * k / chords;
    loop.push_back({std::cos(u), k == 0 || k == chords ? 0 : std::sin(u)});
  }
  return testing::input_of(loop);
}

TEST(CutNegativeCouplings, LeavesNoNegativeCouplingOnRandomDevices) {
  for (const testing::RandomInput& kind : testing::kRandomDevices) {
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      const Output output = testing::must_mesh(kind.make(seed), for_boxes());
      EXPECT_TRUE(negative(output).empty()) << kind.name << seed;
      EXPECT_FALSE(warns(output)) << kind.name << seed;
      EXPECT_EQ(testing::violations(output), "") << kind.name << seed;
    }
  }
}

TEST(CutNegativeCouplings, TellsWhichVertexSawASideThatIsGivenUp) {
  std::size_t given_up = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Output output = testing::must_mesh(testing::random_cells(40, seed), for_boxes());
    for (const BoxCut& cut : output.report.box_cuts) {
      given_up += cut.reason == BoxCut::Reason::given_up ? 1 : 0;
      EXPECT_NE(cut.by, cut.at);
    }
  }
  EXPECT_GT(given_up, 0u);
}

TEST(CutNegativeCouplings, HandsOnErrorsThatAreNotOfItsCuts) {
  std::size_t failed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    int rounds = 0;
    Callbacks callbacks;
    callbacks.share_out = [&](RegionJobs& jobs) {
      ++rounds;
      for (std::size_t k = 0; k < jobs.size(); ++k) {
        if (rounds == 1)
          jobs.mesh_here(k);
        else
          jobs.accept(k, Bytes(1));  // no mesh
      }
      return ok();
    };
    const Result<Output> output =
        cover_mesh(testing::random_cells(40, seed), for_boxes(), callbacks);
    EXPECT_EQ(output.has_value(), rounds == 1) << seed;
    if (output) continue;
    ++failed;
    EXPECT_EQ(output.error().code, ErrorCode::internal) << seed;
  }
  EXPECT_GT(failed, 0u);
}

TEST(CutNegativeCouplings, AHalfDiscIsCutForItsAngles) {
  const Output output = testing::must_mesh(half_disc(24), for_boxes());
  EXPECT_TRUE(negative(output).empty());
  EXPECT_EQ(testing::violations(output), "");
  ASSERT_FALSE(output.report.box_cuts.empty());
  EXPECT_LT(output.report.quality.largest_nu.supplement().in_degrees(), 130);
  const auto told = [](const Note& note) { return note.kind == Note::Kind::box_cut; };
  const auto note = std::find_if(output.report.notes.begin(), output.report.notes.end(), told);
  ASSERT_NE(note, output.report.notes.end());
  EXPECT_EQ(note->where.size(), output.report.box_cuts.size());
}

/// Thin plates in air, whose cuts are at exact feet. Triangles beside the lower one have small
/// angles, which the sides force; no angle above the upper one has to be large.
TEST(CutNegativeCouplings, LargeAnglesAreMendedBesideSmallOnesThatAreForced) {
  for (const double half_width : {2.0, 3.0}) {
    Input input;
    input.polygons.resize(3);
    input.polygons[0].rings = {{{-28, 0}, {28, 0}, {28, 50}, {-28, 50}}};
    input.polygons[1].rings = {{{-27.95, 0.1}, {27.95, 0.1}, {27.95, 0.2}, {-27.95, 0.2}}};
    input.polygons[2].rings = {
        {{-half_width, 0.8}, {half_width, 0.8}, {half_width, 0.9}, {-half_width, 0.9}}};
    const Output output = testing::must_mesh(input, for_boxes());
    EXPECT_TRUE(negative(output).empty());
    EXPECT_EQ(testing::violations(output), "");
    const Quality& quality = output.report.quality;
    EXPECT_LE(quality.largest_nu.supplement().in_degrees(), 100);
    EXPECT_LT(quality.smallest.in_degrees(), 1) << "none is forced: take thinner plates";
  }
}

}  // namespace
}  // namespace cover
