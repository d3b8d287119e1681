// Report, requirements and check have one notion of obtuse, wherever a mesh lies.
#include <cover/requirements.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/read_mesh.hpp>
#include <cover/verify.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

/// Obtuse triangles, and those that rounding explains.
std::array<std::size_t, 2> obtuse_in(const Output& output, const TriangleSoup& mesh) {
  VerifyOptions options;
  options.box_method = options.allow_split = true;
  const Verification found = verify_cover(output.pslg, output.table, mesh, options);
  return {found.obtuse, found.obtuse_by_rounding};
}

bool is_unmet(const Output& output, const Options& options, const char* what) {
  const std::vector<std::string> unmet = unmet_requirements(output, options);
  return std::any_of(unmet.begin(), unmet.end(),
                     [&](const std::string& s) { return s.rfind(what, 0) == 0; });
}

void expect_agreement(const Input& input, bool may_be_obtuse) {
  Options options;
  options.threads = 1;
  options.require.non_obtuse = options.require.max_angle = true;
  if (!may_be_obtuse) {
    options.max_angle = Angle::degrees(90);
    options.split_interfaces = Angle::degrees(90);
  }
  const Output output = testing::must_mesh(input, options);
  const Quality& all = output.report.quality;
  const TriangleSoup soup = triangle_soup(output.mesh);
  const std::array<std::size_t, 2> found = obtuse_in(output, soup);
  EXPECT_EQ(found[0], all.obtuse);
  EXPECT_EQ(found[1], all.obtuse_by_rounding);
  EXPECT_EQ(is_unmet(output, options, "non-obtuse"), all.obtuse > 0);
  if (!may_be_obtuse) {
    EXPECT_EQ(all.obtuse, 0u);
    EXPECT_FALSE(is_unmet(output, options, "max-angle"));
  }
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "mesh.vtu";
  ASSERT_TRUE(write_mesh(output, path));
  const Result<MeshFile> again = read_mesh(path);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(obtuse_in(output, again->soup), found);
  std::array<std::size_t, 2> sum{0, 0};
  for (const RegionReport& region : output.report.regions) {
    Result<Prepared> alone = prepare(testing::region_alone(output, region.id), {});
    ASSERT_TRUE(alone) << alone.error().message;
    VerifyOptions check;
    check.box_method = check.allow_split = true;
    const Verification part =
        verify_cover(alone->pslg, alone->table, testing::part_of(soup, region.id), check);
    EXPECT_EQ(part.obtuse, region.quality.obtuse);
    EXPECT_EQ(part.obtuse_by_rounding, region.quality.obtuse_by_rounding);
    sum[0] += part.obtuse, sum[1] += part.obtuse_by_rounding;
  }
  EXPECT_EQ(sum, found);
}

TEST(Requirements, ReportRequirementAndCheckAgreeWhereverTheMeshLies) {
  for (const testing::RandomInput& kind : testing::kRandomDevices) {
    const Input input = kind.make(3);
    for (const auto& [factor, shift] :
         {std::pair{1.0, Point{0, 0}}, {0.37, {1e6 + 0.1, -3e5}}, {1e7, {0.3, 0.1}}}) {
      SCOPED_TRACE(kind.name + std::to_string(factor));
      const Input moved = testing::transformed(input, factor, shift);
      expect_agreement(moved, true);
      expect_agreement(moved, false);
    }
  }
}

/// One region near the origin, another far away, by which the first was excused once.
TEST(Requirements, ARegionFarAwayExcusesNothing) {
  const double lean = 1e-11;
  Input input = testing::segments_between(
      {{0, 0}, {1, 0}, {-lean, 1}, {1e9, 1e9}, {1e9 + 1, 1e9}, {1e9, 1e9 + 1}},
      {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}});
  Options options;
  options.method = Method::almond;
  options.require.non_obtuse = true;
  const Output output = testing::must_mesh(input, options);
  EXPECT_EQ(output.report.quality.obtuse, 1u);
  EXPECT_EQ(obtuse_in(output, triangle_soup(output.mesh))[1], 0u);
  EXPECT_TRUE(is_unmet(output, options, "non-obtuse"));
}

}  // namespace
}  // namespace cover
