#include "quality/parts/work_in_parts.hpp"

#include <algorithm>
#include <random>
#include <stop_token>

#include "../mesh_checks.hpp"
#include "base/run_all.hpp"
#include "quality/mutable/delaunay_flips.hpp"
#include "quality/quality_region.hpp"
#include "quality/repair/improve.hpp"
#include "quality/repair/search.hpp"
#include "quality/repair/thin_out.hpp"
#include "quality/starts/delaunay_refinement.hpp"
#include "region/region_boundary.hpp"
#include "region/whole_mesh.hpp"
#include "support/inputs/random_regions.hpp"
#include "target/report/fill_report.hpp"

namespace cover {
namespace {

using namespace testing;

constexpr std::size_t kPartSize = 300;

/// Calls `run` with a team of `workers`.
template <class Run>
void with_team(unsigned workers, const Run& run) {
  run_all(1, workers, [&](std::size_t, const Team& team) { run(team); });
}

RefineLimits limits_for(const MutableMesh& mesh) {
  RefineLimits limits;
  limits.smallest_cot = 1 / std::tan(24.5 * 3.14159265358979 / 180);
  limits.budget = 20 * mesh.points.size() + 1000;
  return limits;
}

MutableMesh refined(const RegionBoundary& boundary) {
  MutableMesh mesh = cdt_mesh(boundary);
  refine(mesh, limits_for(mesh));
  return mesh;
}

bool are_same(const MutableMesh& a, const MutableMesh& b) {
  return a.points == b.points && a.excess == b.excess &&
         std::equal(
             a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end(),
             [](const MeshTriangle& s, const MeshTriangle& t) { return s.v == t.v && s.n == t.n; });
}

double count_missed(const MutableMesh& mesh) {
  return static_cast<double>(std::count_if(mesh.excess.begin(), mesh.excess.end(),
                                           [](double excess) { return excess > kSameCot; }));
}

/// What `change` makes of `start` with 1, 2, 3, 7 and 64 threads, which is the same.
template <class Change>
MutableMesh with_any_team(const MutableMesh& start, const Change& change) {
  MutableMesh first = start;
  change(first, Sharing{{}, kPartSize});
  for (const unsigned workers : {2U, 3U, 7U, 64U}) {
    MutableMesh mesh = start;
    with_team(workers, [&](const Team& team) { change(mesh, Sharing{team, kPartSize}); });
    EXPECT_TRUE(are_same(mesh, first)) << workers;
  }
  return first;
}

/// Between fixed vertices triangles reach through the whole region: only branches have short
/// borders.
TEST(WorkInParts, AreBranchesBetweenFixedVertices) {
  const MutableMesh start = cdt_mesh(flower(4000));
  ASSERT_EQ(start.points.size(), start.fixed_vertices());
  std::vector<std::size_t> sizes(part_count(start, {{}, kPartSize}));
  ASSERT_GT(sizes.size(), 8U);
  MutableMesh mesh = start;
  const Borders borders = work_in_parts(
      mesh, {{}, kPartSize}, [&](Part& part) { sizes[part.index] = part.triangles.size(); });
  EXPECT_TRUE(are_same(mesh, start));
  std::size_t parts = 0, all = 0;
  for (const std::size_t size : sizes) {
    parts += size > 0 ? 1 : 0;
    all += size;
    EXPECT_LE(size, 3 * kPartSize);
  }
  EXPECT_GT(parts, 4U);
  EXPECT_EQ(all, start.triangle_count());
  EXPECT_LE(borders.triangles.size(), 2 * (parts - 1));
}

TEST(WorkInParts, AreLeftAloneOnceAStopIsRequested) {
  std::stop_source source;
  source.request_stop();
  const MutableMesh start = refined(flower(2000));
  MutableMesh mesh = start;
  std::size_t worked = 0;
  work_in_parts(mesh, {{}, kPartSize, source.get_token()}, [&](Part&) { ++worked; });
  EXPECT_EQ(worked, 0U);
  EXPECT_TRUE(are_same(mesh, start));
}

TEST(WorkInParts, ArePutBackAsTheyWere) {
  const RegionBoundary boundary = flower(2000);
  const MutableMesh start = refined(boundary);
  std::vector<std::size_t> sizes(part_count(start, {{}, kPartSize}));
  ASSERT_GT(sizes.size(), 8U);
  MutableMesh mesh = start;
  const Borders borders = work_in_parts(mesh, {{}, kPartSize}, [&](Part& part) {
    EXPECT_TRUE(part.mesh.is_valid());
    sizes[part.index] = part.triangles.size();
    EXPECT_LT(part.first_border, part.mesh.allowances.size());
    for (std::uint32_t t = 0; t < part.mesh.triangles.size(); ++t)
      EXPECT_EQ(part.mesh.excess[t],
                part.mesh.excess_of(part.mesh.triangles[t].v, part.mesh.triangles[t].n));
  });
  EXPECT_TRUE(are_same(mesh, start));
  expect_sound(mesh, boundary);
  EXPECT_LT(*std::max_element(sizes.begin(), sizes.end()), 2 * kPartSize);
  EXPECT_GT(*std::min_element(sizes.begin(), sizes.end()), kPartSize / 2);
  EXPECT_FALSE(borders.triangles.empty());
  const std::vector<std::uint32_t> near = borders.triangles_near(mesh);
  EXPECT_TRUE(
      std::includes(near.begin(), near.end(), borders.triangles.begin(), borders.triangles.end()));
  EXPECT_LT(near.size(), mesh.triangle_count() / 2);
}

TEST(WorkInParts, RefinementLeavesNoTraceOfBorders) {
  const RegionBoundary boundary = flower(2000);
  const MutableMesh whole = refined(boundary);
  MutableMesh mesh =
      with_any_team(cdt_mesh(boundary), [](MutableMesh& part, const Sharing& sharing) {
        refine(part, limits_for(part), {}, sharing);
      });
  expect_sound(mesh, boundary);
  const auto triangles = static_cast<double>(whole.triangle_count());
  EXPECT_NEAR(static_cast<double>(mesh.triangle_count()), triangles, 0.02 * triangles);
  EXPECT_LE(worst_excess(mesh), worst_excess(whole) + 0.1);
  EXPECT_EQ(make_delaunay(mesh), 0U);
}

TEST(WorkInParts, ImprovementSearchAndThinningAreTheSameForAnyTeam) {
  const RegionBoundary boundary = flower(2000);
  const MutableMesh start = refined(boundary);
  const MutableMesh improved = with_any_team(start, [](MutableMesh& mesh, const Sharing& sharing) {
    const ImproveResult result = improve(mesh, 10'000'000, {}, sharing);
    EXPECT_GT(result.evaluations, 0U);
    EXPECT_FALSE(result.budget_used_up);
  });
  expect_sound(improved, boundary);
  EXPECT_LT(worst_excess(improved), worst_excess(start));
  // Borders leave nothing that the whole would not.
  MutableMesh undivided = start;
  improve(undivided, 10'000'000);
  EXPECT_LE(count_missed(improved), count_missed(undivided) * 1.1 + 5);

  Goal strict = default_goal();
  strict.large -= 0.05;
  const MutableMesh searched =
      with_any_team(improved, [&](MutableMesh& mesh, const Sharing& sharing) {
        Budget budget{100'000, {}};
        search_excerpts(mesh, strict, budget, Restarts::none, sharing);
      });
  expect_sound(searched, boundary);
  MutableMesh before = improved;
  before.set_goal(strict);
  EXPECT_LT(count_missed(searched), count_missed(before));

  const MutableMesh thin = with_any_team(improved, [](MutableMesh& mesh, const Sharing& sharing) {
    EXPECT_GT(thin_out(mesh, 10'000'000, sharing).removed, 0U);
  });
  expect_sound(thin, boundary);
  MutableMesh thin_whole = improved;
  thin_out(thin_whole, 10'000'000);
  const auto triangles = static_cast<double>(thin.triangle_count());
  EXPECT_NEAR(triangles, static_cast<double>(thin_whole.triangle_count()), 0.03 * triangles);
}

TEST(WorkInParts, FlipsAcrossBordersMakeItDelaunay) {
  const RegionBoundary boundary = flower(2000);
  MutableMesh start = refined(boundary);
  improve(start, 10'000'000);
  Goal goal = default_goal();
  goal.coupling = {1, true, false, kInverted};
  start.set_goal(goal);
  MutableMesh flipped = start;
  ASSERT_GT(make_delaunay(flipped), 0U);
  MutableMesh mesh = with_any_team(start, [](MutableMesh& whole, const Sharing& sharing) {
    const Borders borders =
        work_in_parts(whole, sharing, [](Part& part) { make_delaunay(part.mesh); });
    make_delaunay(whole, borders.triangles);
  });
  expect_sound(mesh, boundary);
  EXPECT_EQ(make_delaunay(mesh), 0U);
  const MutableMesh improved = with_any_team(start, [](MutableMesh& part, const Sharing& sharing) {
    improve(part, 10'000'000, {}, sharing, Before::flips_to_delaunay);
  });
  expect_sound(improved, boundary);
}

/// The whole method on random regions cut into tiny parts, each with one thread and with four.
TEST(WorkInParts, RandomRegionsInTinyParts) {
  std::mt19937_64 random(7);
  const std::uint64_t tries = cases_asked_for("COVER_BLOCK_TRIES", 100);
  std::size_t divided = 0;
  for (std::uint64_t k = 0; k < tries; ++k) {
    const RandomRegion region = random_region(random);
    const RegionBoundary& boundary = region.boundary;
    Options options;
    if (k % 3 == 1) options.couplings = Couplings::last;
    if (k % 3 == 2) options.effort = Effort::fast;
    RegionMesh mesh = quality_region(boundary, options, {}, {{}, 12}).mesh;
    RegionMesh other;
    with_team(4, [&](const Team& team) {
      other = quality_region(boundary, options, {}, {team, 12}).mesh;
    });
    EXPECT_EQ(mesh.triangles, other.triangles) << region.kind;
    EXPECT_EQ(mesh.steiner, other.steiner) << region.kind;
    const std::vector<Point> points = all_points(boundary, mesh);
    const auto flaw = find_flaw(
        {points, mesh.triangles, boundary.sides, boundary.segments, boundary.points.size()});
    EXPECT_FALSE(flaw) << region.kind << ": " << (flaw ? flaw->what : "");
    fill_report(boundary, mesh);
    EXPECT_TRUE(mesh.report.bound_held) << region.kind;
    divided += mesh.triangles.size() >= 24 ? 1 : 0;
  }
  EXPECT_GT(divided, tries / 4);
}

}  // namespace
}  // namespace cover
